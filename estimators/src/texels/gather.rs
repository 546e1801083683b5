//! Every point sums over all texels.

use super::Texel;
use super::math::{cos_half, towards_texel};
use crate::{Cpu, Frame, Quantity};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;

/// What a texel counts: a method's own formulas.
pub trait TexelLight: Sync {
    /// What the reflectivity needs of the points' lobes.
    type Lobe<L: Lane>;

    /// Solid angle in sr of a texel from the points; `i` is the direction to it, `r2` = (r/d)².
    fn omega<L: Lane>(&self, texel: &Texel, i: Vector<L>, r2: L) -> L;

    /// Cosine at the points, in the mean over the texel.
    fn cosine<L: Lane>(&self, n_i: L, omega: L) -> L;

    /// The points' lobes.
    fn lobe<L: Lane>(&self, shininess: L) -> Self::Lobe<L>;

    /// Diffuse and specular factor of the reflectivity, the cosine included.
    fn reflectivity<L: Lane>(&self, lobe: &Self::Lobe<L>, at: Cosines<L>, omega: L) -> (L, L);
}

impl Texel {
    /// What the method says of its size, in each lane.
    #[inline(always)]
    pub fn extents<L: Lane>(&self) -> L {
        L::from(self.extent)
    }

    /// Cosine between its surface's normal and the direction back along `i`.
    #[inline(always)]
    pub fn cos_surface<L: Lane>(&self, i: Vector<L>) -> L {
        -i.dot(Vector::splat(self.normal))
    }
}

/// Cosines at the point between its normal and the direction to a texel, to the viewer and the half
/// vector of both.
#[derive(Clone, Copy)]
pub struct Cosines<L> {
    /// Between normal and direction to the texel.
    pub n_i: L,
    /// Between normal and direction to the viewer.
    pub n_v: L,
    /// Between normal and half vector.
    pub n_h: L,
}

/// Sums over texels around the reference point at every point.
pub fn gather<M: TexelLight>(frame: &mut Frame<'_, Cpu>, texels: &[Texel], method: M) {
    let sum = Sum {
        texels,
        origin: frame.reference_point.to_array(),
        method,
    };
    match frame.quantity {
        Quantity::GlossyRadiance => frame.for_each_tile(&Glossy(sum)),
        _ => frame.for_each_tile(&Diffuse(sum)),
    }
}

struct Sum<'a, M> {
    texels: &'a [Texel],
    origin: [f32; 3],
    method: M,
}

impl<M: TexelLight> Sum<'_, M> {
    /// Points relative to the reference point.
    #[inline(always)]
    fn relative<L: Lane>(&self, points: &PointLanes<'_, L>) -> Vector<L> {
        points.vector(PointLayout::POSITION) - Vector::splat(self.origin)
    }

    /// Direction I to a texel and its solid angle from x.
    #[inline(always)]
    fn seen<L: Lane>(&self, texel: &Texel, x: Vector<L>) -> (Vector<L>, L) {
        let direction = Vector::splat(texel.direction);
        let (i, r2) = towards_texel(direction, texel.inverse_distance.into(), x);
        (i, self.method.omega(texel, i, r2))
    }
}

#[inline(always)]
fn accumulate<L: Lane>(sum: &mut [L; 3], radiance: [f32; 3], weight: L) {
    for (sum, radiance) in sum.iter_mut().zip(radiance) {
        *sum = *sum + weight * L::from(radiance);
    }
}

/// E = Σ L·(N·I)⁺·Δω.
struct Diffuse<'a, M>(Sum<'a, M>);

impl<M: TexelLight> TileKernel for Diffuse<'_, M> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let (x, n) = (self.0.relative(points), points.vector(PointLayout::NORMAL));
        let mut sum = [L::from(0.0); 3];
        for texel in self.0.texels {
            let (i, omega) = self.0.seen(texel, x);
            let weight = omega * self.0.method.cosine(n.dot(i), omega);
            accumulate(&mut sum, texel.radiance, weight);
        }
        sum
    }
}

/// L_r = Σ L·a·Δω, k_d and k_s taken out of the sum.
struct Glossy<'a, M>(Sum<'a, M>);

impl<M: TexelLight> TileKernel for Glossy<'_, M> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let (x, n) = (self.0.relative(points), points.vector(PointLayout::NORMAL));
        let v = points.vector(PointLayout::VIEW);
        let lobe = self.0.method.lobe(points.plane(PointLayout::SHININESS));
        let n_v = n.dot(v);
        let zero = [L::from(0.0); 3];
        let (mut diffuse, mut specular) = (zero, zero);
        for texel in self.0.texels {
            let (i, omega) = self.0.seen(texel, x);
            let cosines = Cosines {
                n_i: n.dot(i),
                n_v,
                n_h: cos_half(n, i, v),
            };
            let (d, s) = self.0.method.reflectivity(&lobe, cosines, omega);
            accumulate(&mut diffuse, texel.radiance, d * omega);
            accumulate(&mut specular, texel.radiance, s * omega);
        }
        std::array::from_fn(|c| {
            points.plane(PointLayout::DIFFUSE + c) * diffuse[c]
                + points.plane(PointLayout::SPECULAR + c) * specular[c]
        })
    }
}
