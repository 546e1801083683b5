//! Point-to-point form factors on the CPU.

use super::math::point_omega;
use super::{PointFormFactor, PointFormFactorParams};
use crate::kept::Kept;
use crate::texels::gather::{Cosines, TexelLight, gather};
use crate::texels::math::{lobe_normalisation, normalised_reflectivity};
use crate::texels::{Texel, average};
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::CpuCx;
use interreflect_scene::Estimate;

/// What averaging reads, and the texels, kept across frames.
#[derive(Default)]
pub struct State {
    averaging: Kept<PointFormFactorParams, average::Tables>,
    texels: Option<Vec<Texel>>,
}

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let texels = self.texels.iter();
        Ok(texels.map(|t| Records::host("texels", t)).collect())
    }
}

impl Estimator<Cpu> for PointFormFactor {
    type State = State;

    fn prepare(
        params: &PointFormFactorParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.texels.is_none() {
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            let averaging = state.averaging.tables(params, || Ok(params.averaging()))?;
            state.texels = Some(averaging.average(captured));
        }
        Ok(())
    }

    fn shade(
        params: &PointFormFactorParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let texels = state.texels.as_ref().ok_or(EstimatorError::Unprepared)?;
        let texels = (inputs.reference_point.to_array(), texels.as_slice());
        let light = PointLight {
            largest: params.largest_omega_sr(),
        };
        gather(cx, (quantity, inputs.points), texels, light, out);
        Ok(())
    }
}

struct PointLight {
    /// Largest solid angle in sr.
    largest: f32,
}

impl TexelLight for PointLight {
    /// Exponent and normalisation.
    type Lobe<L: Lane> = (L, L);

    #[inline(always)]
    fn omega<L: Lane>(&self, texel: &Texel, i: Vector<L>, r2: L) -> L {
        let largest = self.largest.into();
        point_omega(texel.extents(), r2, texel.cos_surface(i), largest)
    }
    #[inline(always)]
    fn cosine<L: Lane>(&self, n_i: L, _omega: L) -> L {
        n_i.max(L::from(0.0))
    }
    #[inline(always)]
    fn lobe<L: Lane>(&self, shininess: L) -> (L, L) {
        (shininess, lobe_normalisation(shininess))
    }
    #[inline(always)]
    fn reflectivity<L: Lane>(&self, lobe: &(L, L), at: Cosines<L>, _omega: L) -> (L, L) {
        normalised_reflectivity(at.n_i, at.n_h, lobe.0, lobe.1)
    }
}
