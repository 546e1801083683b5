//! Localized cube maps on the CPU: every point sums over all texels, sixteen points at a time.

use super::math::{
    cos_half, lobe_normalisation, omega_corrected, omega_published, reflectivity_corrected,
    reflectivity_published, towards_texel,
};
use super::texels::{Texel, texels};
use super::{LocalizedCubemap, LocalizedCubemapParams};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Quantity};
use interreflect_cpu::lane::{Lane, Vector, Wide};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{Estimate, PointLayout};

/// Solid angles of the captured texels, and the texels, kept across frames.
#[derive(Default)]
pub struct State {
    omegas_sr: Kept<LocalizedCubemapParams, Vec<f32>>,
    texels: Option<Vec<Texel>>,
}

impl Estimator<Cpu> for LocalizedCubemap {
    type State = State;

    fn prepare(
        params: &LocalizedCubemapParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.texels.is_none() {
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            let omegas_sr = state.omegas_sr.tables(params, || {
                Ok(match params.fidelity {
                    Fidelity::Published => Vec::new(),
                    Fidelity::Corrected => face_solid_angles_sr(captured.size),
                })
            })?;
            state.texels = Some(texels(params, omegas_sr, captured));
        }
        Ok(())
    }

    fn shade(
        params: &LocalizedCubemapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let texels = state.texels.as_ref().ok_or(EstimatorError::Unprepared)?;
        let sum = Sum {
            texels,
            origin: inputs.reference_point.to_array(),
        };
        let points = inputs.points;
        match (quantity, params.fidelity) {
            (Quantity::GlossyRadiance, Fidelity::Published) => {
                cx.for_each_tile(points, out, &Glossy::<false>(sum));
            }
            (Quantity::GlossyRadiance, Fidelity::Corrected) => {
                cx.for_each_tile(points, out, &Glossy::<true>(sum));
            }
            (_, Fidelity::Published) => cx.for_each_tile(points, out, &Diffuse::<false>(sum)),
            (_, Fidelity::Corrected) => cx.for_each_tile(points, out, &Diffuse::<true>(sum)),
        }
        Ok(())
    }
}

struct Sum<'a> {
    texels: &'a [Texel],
    origin: [f32; 3],
}

impl Sum<'_> {
    /// Points relative to the reference point.
    #[inline(always)]
    fn relative(&self, points: &PointLanes<'_>) -> Vector<Wide> {
        points.vector(PointLayout::POSITION) - Vector::splat(self.origin)
    }
}

/// Direction I to a texel and its solid angle Δω* from x.
#[inline(always)]
fn seen<const CORRECTED: bool, L: Lane>(texel: &Texel, x: Vector<L>) -> (Vector<L>, L) {
    let splat = |v: f32| L::splat(f64::from(v));
    let direction = Vector::splat(texel.direction);
    let (i, r2) = towards_texel(direction, splat(texel.inverse_distance), x);
    let omega = if CORRECTED {
        let cos_surface = -i.dot(Vector::splat(texel.normal));
        omega_corrected(splat(texel.extent), r2, cos_surface)
    } else {
        omega_published(splat(texel.extent), r2)
    };
    (i, omega)
}

#[inline(always)]
fn accumulate(sum: &mut [Wide; 3], radiance: [f32; 3], weight: Wide) {
    for (sum, radiance) in sum.iter_mut().zip(radiance) {
        *sum = *sum + weight * Wide([radiance; 16]);
    }
}

/// E = Σ L·(N·I)⁺·Δω*.
struct Diffuse<'a, const CORRECTED: bool>(Sum<'a>);

impl<const CORRECTED: bool> TileKernel for Diffuse<'_, CORRECTED> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let zero = Wide::splat(0.0);
        let (x, n) = (self.0.relative(points), points.vector(PointLayout::NORMAL));
        let mut sum = [zero; 3];
        for texel in self.0.texels {
            let (i, omega) = seen::<CORRECTED, Wide>(texel, x);
            accumulate(&mut sum, texel.radiance, omega * n.dot(i).max(zero));
        }
        sum
    }
}

/// L_r = Σ L·a·Δω*, k_d and k_s taken out of the sum.
struct Glossy<'a, const CORRECTED: bool>(Sum<'a>);

impl<const CORRECTED: bool> TileKernel for Glossy<'_, CORRECTED> {
    #[inline(always)]
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let zero = Wide::splat(0.0);
        let (x, n) = (self.0.relative(points), points.vector(PointLayout::NORMAL));
        let v = points.vector(PointLayout::VIEW);
        let shininess = points.plane(PointLayout::SHININESS);
        let (n_v, normalisation) = (n.dot(v), lobe_normalisation(shininess));
        let (mut diffuse, mut specular) = ([zero; 3], [zero; 3]);
        for texel in self.0.texels {
            let (i, omega) = seen::<CORRECTED, Wide>(texel, x);
            let (n_i, n_h) = (n.dot(i), cos_half(n, i, v));
            let (d, s) = if CORRECTED {
                reflectivity_corrected(n_i, n_h, shininess, normalisation)
            } else {
                reflectivity_published(n_i, n_v, n_h, shininess)
            };
            accumulate(&mut diffuse, texel.radiance, d * omega);
            accumulate(&mut specular, texel.radiance, s * omega);
        }
        std::array::from_fn(|c| {
            points.plane(PointLayout::DIFFUSE + c) * diffuse[c]
                + points.plane(PointLayout::SPECULAR + c) * specular[c]
        })
    }
}
