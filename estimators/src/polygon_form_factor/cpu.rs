//! Polygon-to-point form factors on the CPU: row by row over each face, so that a corner is looked
//! at once and an edge integrated once for both texels beside it.

use super::corners::{Quads, REUSED_EDGE, Tables};
use super::math::{clipped_quad, corner_height, edge_angle, edge_cosine, edge_integral};
use super::{Facing, PolygonFormFactor};
use crate::ranges::MAX_RESOLUTION;
use crate::texels::average;
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::params::Fidelity;

/// The quadrilaterals, and what averaging and the corners read.
pub struct Polygons {
    method: PolygonFormFactor,
    averaging: average::Tables,
    corners: Tables,
    quads: Quads,
}

impl Estimator<Cpu> for PolygonFormFactor {
    type Prepared = Polygons;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Polygons>,
    ) -> Result<Polygons, EstimatorError> {
        let (averaging, corners, quads) = match last {
            Some(last) => (
                last.averaging,
                last.corners,
                frame.unless_stale(Some(last.quads)),
            ),
            None => (self.averaging(), Tables::new(self), None),
        };
        let quads = match quads {
            Some(quads) => quads,
            None => {
                let captured = frame.cube(&self.captured(&frame.scene))?;
                corners.quads(&averaging.average(captured), captured)
            }
        };
        Ok(Polygons {
            method: self.clone(),
            averaging,
            corners,
            quads,
        })
    }
}

impl Prepared<Cpu> for Polygons {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let contours = Contours {
            quads: &self.quads,
            resolution: self.method.resolution as usize,
            origin: frame.reference_point.to_array(),
        };
        match (self.method.fidelity, self.method.facing) {
            (Fidelity::Published, _) => frame.for_each_tile(&Published(contours)),
            (Fidelity::Corrected, Facing::Signed) => {
                frame.for_each_tile(&Corrected::<true>(contours));
            }
            (Fidelity::Corrected, Facing::Clamped) => {
                frame.for_each_tile(&Corrected::<false>(contours));
            }
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let with_pad = |[r, g, b]: &[f32; 3]| [*r, *g, *b, 0.0];
        let radiances: Vec<[f32; 4]> = self.quads.radiances.iter().map(with_pad).collect();
        Ok(vec![
            Records::host("corners", &self.quads.corners).sharing_captures(),
            Records::host("radiances", &radiances).sharing_captures(),
        ])
    }
}

/// Corners along the edge of a face, at most.
pub(super) const MAX_SIDE: usize = MAX_RESOLUTION as usize + 1;

struct Contours<'a> {
    quads: &'a Quads,
    /// M: texels along a face's edge.
    resolution: usize,
    origin: [f32; 3],
}

/// A corner from the points.
#[derive(Clone, Copy)]
struct Corner<L> {
    r: Vector<L>,
    /// Above the horizon.
    height: L,
}

/// A texel's corners and the values of its edges, each towards larger columns or rows.
struct Quad<L> {
    /// (s₀,t₀), (s₀,t₁), (s₁,t₁), (s₁,t₀): clockwise seen from the reference point.
    corners: [Corner<L>; 4],
    left: L,
    right: L,
    top: L,
    bottom: L,
}

impl<L: Lane> Quad<L> {
    /// Sum along the contour, clockwise.
    #[inline(always)]
    fn contour(&self) -> L {
        self.left + self.bottom - self.right - self.top
    }
}

/// A fidelity: what an edge and a quadrilateral count.
trait Formula: Sync {
    /// Value of the edge between two corners, which changes its sign with their order.
    fn edge<L: Lane>(&self, a: &Corner<L>, b: &Corner<L>, n: Vector<L>) -> L;
    /// Irradiance from a texel of radiance 1, or nothing where it is below all horizons.
    fn quad<L: Lane>(&self, face: usize, quad: &Quad<L>, n: Vector<L>) -> Option<L>;
}

impl Contours<'_> {
    #[inline(always)]
    fn gather<L: Lane>(&self, formula: &impl Formula, points: &PointLanes<'_, L>) -> [L; 3] {
        let zero = L::from(0.0);
        let x = points.vector(PointLayout::POSITION) - Vector::splat(self.origin);
        let n = points.vector(PointLayout::NORMAL);
        let reach = x.dot(x).sqrt();
        let (m, side) = (self.resolution, self.resolution + 1);
        let nothing = Corner {
            r: Vector::splat([0.0; 3]),
            height: zero,
        };
        let mut above = [nothing; MAX_SIDE];
        let mut tops = [zero; MAX_SIDE];
        let mut sum = [zero; 3];
        for face in 0..CUBE_FACES {
            let corner = |i: usize, j: usize| {
                let [dx, dy, dz, w] = self.quads.corners[(face * side + j) * side + i];
                let w = L::from(w);
                let r = Vector::splat([dx, dy, dz]) - x.scale(w);
                let height = corner_height(r, n, w, reach);
                Corner { r, height }
            };
            for (i, above) in above.iter_mut().enumerate().take(side) {
                *above = corner(i, 0);
            }
            for i in 0..m {
                tops[i] = formula.edge(&above[i], &above[i + 1], n);
            }
            for j in 0..m {
                let mut below = corner(0, j + 1);
                let mut left = formula.edge(&above[0], &below, n);
                for i in 0..m {
                    let below_right = corner(i + 1, j + 1);
                    let quad = Quad {
                        corners: [above[i], below, below_right, above[i + 1]],
                        left,
                        right: formula.edge(&above[i + 1], &below_right, n),
                        top: tops[i],
                        bottom: formula.edge(&below, &below_right, n),
                    };
                    if let Some(irradiance) = formula.quad(face, &quad, n) {
                        let radiance = self.quads.radiances[(face * m + j) * m + i];
                        for (sum, radiance) in sum.iter_mut().zip(radiance) {
                            *sum = *sum + irradiance * L::from(radiance);
                        }
                    }
                    (above[i], tops[i]) = (below, quad.bottom);
                    (below, left) = (below_right, quad.right);
                }
                above[m] = below;
            }
        }
        sum
    }
}

/// The paper's form factor: unit normals of the edges times one angle, negative sums zeroed.
struct Published<'a>(Contours<'a>);

impl Formula for Published<'_> {
    #[inline(always)]
    fn edge<L: Lane>(&self, a: &Corner<L>, b: &Corner<L>, n: Vector<L>) -> L {
        edge_cosine(a.r, b.r, n)
    }

    #[inline(always)]
    fn quad<L: Lane>(&self, face: usize, quad: &Quad<L>, _n: Vector<L>) -> Option<L> {
        let (a, b) = REUSED_EDGE[face];
        let angle = edge_angle(quad.corners[a].r, quad.corners[b].r);
        let sum = L::from(0.5) * angle * quad.contour();
        Some(sum.max(L::from(0.0)))
    }
}

impl TileKernel for Published<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        self.0.gather(self, points)
    }
}

/// Lambert's: each edge's own angle, clipped at the horizon.
struct Corrected<'a, const SIGNED: bool>(Contours<'a>);

impl<const SIGNED: bool> Formula for Corrected<'_, SIGNED> {
    /// Where no lane has the whole edge above its horizon, none reads it.
    #[inline(always)]
    fn edge<L: Lane>(&self, a: &Corner<L>, b: &Corner<L>, n: Vector<L>) -> L {
        match any_positive(a.height.min(b.height)) {
            true => edge_integral(a.r, b.r, n),
            false => L::from(0.0),
        }
    }

    #[inline(always)]
    fn quad<L: Lane>(&self, _face: usize, quad: &Quad<L>, n: Vector<L>) -> Option<L> {
        let zero = L::from(0.0);
        let heights = quad.corners.map(|c| c.height);
        let [a, b, c, d] = heights;
        let highest = a.max(b).max(c.max(d));
        if !any_positive(highest) {
            return None;
        }
        let lowest = a.min(b).min(c.min(d));
        let whole = L::from(0.5) * quad.contour();
        let cut = lowest.select_gt(zero, zero, highest);
        let part = match any_positive(cut) {
            true => clipped_quad(&quad.corners.map(|c| c.r), &heights, n),
            false => zero,
        };
        let irradiance = lowest.select_gt(zero, whole, cut.select_gt(zero, part, zero));
        Some(match SIGNED {
            true => irradiance,
            false => irradiance.max(zero),
        })
    }
}

impl<const SIGNED: bool> TileKernel for Corrected<'_, SIGNED> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let sum = self.0.gather(self, points);
        sum.map(|e| e.max(L::from(0.0)))
    }
}

#[inline(always)]
fn any_positive<L: Lane>(values: L) -> bool {
    values.largest() > L::Scalar::from(0.0)
}
