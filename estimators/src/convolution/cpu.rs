//! Convolutions on the CPU: every node of a map sums over all texels, sixteen nodes at a time.

use super::Sizes;
use super::math::{cosine_weight, map_nodes, map_taps, phong_weight};
use super::sources::{Source, light, node_points, vectors_sr};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::reflection::{at, lanes};
use crate::{Changed, Cpu, EstimatorError, Inputs};
use glam::Vec3;
use interreflect_cpu::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout, Points};

/// The tables and the convolved maps, kept across frames.
#[derive(Default)]
pub(crate) struct Convolved {
    tables: Kept<Sizes, Tables>,
    maps: Option<Maps>,
}

/// What a convolution reads and where it is evaluated.
struct Tables {
    omegas_sr: Vec<f32>,
    sources: Vec<Source>,
    nodes: Points,
}

impl Tables {
    fn new(sizes: &Sizes) -> Self {
        let source = |vector: Vec3| Source {
            vector: vector.to_array(),
            ..Source::default()
        };
        Self {
            omegas_sr: face_solid_angles_sr(sizes.captured.size),
            sources: vectors_sr(sizes.resolution).map(source).collect(),
            nodes: node_points(sizes.cells),
        }
    }
}

/// The convolved maps: of irradiance, and for each lobe its exponent and its map of radiance.
pub(crate) struct Maps {
    pub(crate) irradiance: Map,
    pub(crate) lobes: Vec<(f32, Map)>,
}

impl Convolved {
    /// The Phong exponents that there are maps for; none before the first convolution.
    pub(crate) fn exponents(&self) -> Option<Vec<f32>> {
        let exponents = |maps: &Maps| maps.lobes.iter().map(|(exponent, _)| *exponent).collect();
        self.maps.as_ref().map(exponents)
    }

    /// Convolves the declared capture with the cosine and with a Phong lobe of each exponent,
    /// unless nothing has changed.
    pub(crate) fn update(
        &mut self,
        sizes: &Sizes,
        cx: &CpuCx,
        inputs: &Inputs<'_, Cpu>,
        exponents: Vec<f32>,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if !stale && self.exponents().as_ref() == Some(&exponents) {
            return Ok(());
        }
        let captured = inputs.cube(&sizes.captured)?;
        let tables = self.tables.tables(sizes, || Ok(Tables::new(sizes)))?;
        let (sources, nodes) = (&mut tables.sources, &tables.nodes);
        light(sources, sizes.resolution, captured, &tables.omegas_sr);
        let lobe = |e| (e, Map::convolve(cx, sizes.cells, nodes, &Phong(sources, e)));
        self.maps = Some(Maps {
            irradiance: Map::convolve(cx, sizes.cells, nodes, &Cosine(sources)),
            lobes: exponents.into_iter().map(lobe).collect(),
        });
        Ok(())
    }

    /// The maps of the last update.
    pub(crate) fn maps(&self) -> Result<&Maps, EstimatorError> {
        self.maps.as_ref().ok_or(EstimatorError::Unprepared)
    }
}

/// RGB at the nodes of a cube map, row by row.
pub(crate) struct Map {
    cells: u32,
    nodes: Vec<Vec3>,
}

impl Map {
    fn convolve<K: TileKernel>(cx: &CpuCx, cells: u32, at: &Points, kernel: &K) -> Self {
        let mut nodes = Estimate::new(map_nodes(cells));
        cx.for_each_tile(at, &mut nodes, kernel);
        Self {
            cells,
            nodes: nodes.iter().collect(),
        }
    }

    /// Bilinear value in a direction, which need not be unit.
    #[inline(always)]
    pub(crate) fn lookup(&self, direction: Vec3) -> Vec3 {
        map_taps(self.cells, direction)
            .into_iter()
            .map(|(node, weight)| self.nodes[node] * weight)
            .sum()
    }
}

/// The value along each point's normal.
impl TileKernel for Map {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        lanes(|lane| self.lookup(at(n, lane)))
    }
}

/// E(n) = Σ L·∫(n·ω)⁺dω.
struct Cosine<'a>(&'a [Source]);

impl TileKernel for Cosine<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let mut sum = [Wide::splat(0.0); 3];
        for source in self.0 {
            let weight = cosine_weight(n, Vector::splat(source.vector));
            for (sum, radiance) in sum.iter_mut().zip(source.radiance) {
                *sum = *sum + weight * Wide([radiance; WIDTH]);
            }
        }
        sum
    }
}

/// L(r) = Σ L·Δω·((r·l)⁺)^N / Σ Δω·((r·l)⁺)^N.
struct Phong<'a>(&'a [Source], f32);

impl TileKernel for Phong<'_> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let r = points.vector(PointLayout::NORMAL);
        let zero = Wide::splat(0.0);
        let exponent = Wide([self.1; WIDTH]);
        let texel = |source: &Source| {
            let vector: Vector<Wide> = Vector::splat(source.vector);
            let omega = vector.dot(vector).sqrt();
            (r.dot(vector) / omega, omega)
        };
        let mut cos_max = zero;
        for source in self.0 {
            cos_max = cos_max.max(texel(source).0);
        }
        let (mut sum, mut total) = ([zero; 3], zero);
        for source in self.0 {
            let (cos, omega) = texel(source);
            let weight = omega * phong_weight(cos, cos_max, exponent);
            total = total + weight;
            for (sum, radiance) in sum.iter_mut().zip(source.radiance) {
                *sum = *sum + weight * Wide([radiance; WIDTH]);
            }
        }
        sum.map(|s| s / total)
    }
}
