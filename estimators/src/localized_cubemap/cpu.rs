//! Localized cube maps on the CPU.

use super::math::{omega_corrected, omega_published, reflectivity_published};
use super::tables::Tables;
use super::{LocalizedCubemap, LocalizedCubemapParams, Reflectivity};
use crate::kept::Kept;
use crate::lobes::lobes;
use crate::texels::gather::{Cosines, TexelLight, gather};
use crate::texels::math::{lobe_normalisation, normalised_reflectivity};
use crate::texels::{Texel, average};
use crate::{Changed, Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::CpuCx;
use interreflect_scene::Estimate;
use interreflect_scene::params::Fidelity;
use std::f64::consts::FRAC_1_PI;

/// What averaging reads, the texels and the reflectivity's tables, kept across frames.
#[derive(Default)]
pub struct State {
    averaging: Kept<LocalizedCubemapParams, average::Tables>,
    texels: Option<Vec<Texel>>,
    reflectivity: Option<Tables>,
}

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        let texels = self.texels.iter();
        Ok(texels.map(|t| Records::host("texels", t)).collect())
    }
}

impl Estimator<Cpu> for LocalizedCubemap {
    type State = State;

    fn prepare(
        params: &LocalizedCubemapParams,
        state: &mut State,
        _cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.texels.is_none() {
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            let averaging = state.averaging.tables(params, || Ok(params.averaging()))?;
            state.texels = Some(averaging.average(captured));
        }
        if params.reflectivity == Reflectivity::Table {
            let kept = state.reflectivity.as_ref().map(|t| t.lobes.clone());
            let lobes = lobes(quantity, inputs, kept.clone(), |n| n)?;
            if kept.as_ref() != Some(&lobes) {
                state.reflectivity = Some(Tables::new(lobes));
            }
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
        let at = (quantity, inputs.points);
        let texels = (inputs.reference_point.to_array(), texels.as_slice());
        match (params.fidelity, params.reflectivity) {
            (Fidelity::Published, Reflectivity::Sample) => {
                gather(cx, at, texels, Published, out);
            }
            (Fidelity::Corrected, Reflectivity::Sample) => {
                gather(cx, at, texels, Corrected, out);
            }
            (fidelity, Reflectivity::Table) => {
                let tables = state.reflectivity.as_ref();
                let tables = tables.ok_or(EstimatorError::Unprepared)?;
                match fidelity {
                    Fidelity::Published => {
                        gather(cx, at, texels, Averaged::<false>(tables), out);
                    }
                    Fidelity::Corrected => {
                        gather(cx, at, texels, Averaged::<true>(tables), out);
                    }
                }
            }
        }
        Ok(())
    }
}

struct Published;

impl TexelLight for Published {
    type Lobe<L: Lane> = L;

    #[inline(always)]
    fn omega<L: Lane>(&self, texel: &Texel, _i: Vector<L>, r2: L) -> L {
        omega_published(texel.extents(), r2)
    }
    #[inline(always)]
    fn cosine<L: Lane>(&self, n_i: L, _omega: L) -> L {
        n_i.max(L::from(0.0))
    }
    #[inline(always)]
    fn lobe<L: Lane>(&self, shininess: L) -> L {
        shininess
    }
    #[inline(always)]
    fn reflectivity<L: Lane>(&self, shininess: &L, at: Cosines<L>, _omega: L) -> (L, L) {
        reflectivity_published(at.n_i, at.n_v, at.n_h, *shininess)
    }
}

struct Corrected;

impl TexelLight for Corrected {
    /// Exponent and normalisation.
    type Lobe<L: Lane> = (L, L);

    #[inline(always)]
    fn omega<L: Lane>(&self, texel: &Texel, i: Vector<L>, r2: L) -> L {
        omega_corrected(texel.extents(), r2, texel.cos_surface(i))
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

/// The reflectivity averaged over a texel, from tables.
struct Averaged<'a, const CORRECTED: bool>(&'a Tables);

impl<const CORRECTED: bool> TexelLight for Averaged<'_, CORRECTED> {
    /// Number of each lane's table, and normalisation.
    type Lobe<L: Lane> = (L, L);

    #[inline(always)]
    fn omega<L: Lane>(&self, texel: &Texel, i: Vector<L>, r2: L) -> L {
        match CORRECTED {
            true => omega_corrected(texel.extents(), r2, texel.cos_surface(i)),
            false => omega_published(texel.extents(), r2),
        }
    }
    #[inline(always)]
    fn cosine<L: Lane>(&self, n_i: L, omega: L) -> L {
        self.0.averaged_over(L::from(0.0), n_i, omega)
    }
    #[inline(always)]
    fn lobe<L: Lane>(&self, shininess: L) -> (L, L) {
        let table = L::by_lane(|i| self.0.of_lobe(shininess.lanes()[i]));
        (table, lobe_normalisation(shininess))
    }
    #[inline(always)]
    fn reflectivity<L: Lane>(
        &self,
        (table, normalisation): &(L, L),
        at: Cosines<L>,
        omega: L,
    ) -> (L, L) {
        let zero = L::from(0.0);
        let cos_theta = self.cosine(at.n_i, omega);
        let power = self.0.averaged_over(*table, at.n_h, omega);
        if CORRECTED {
            let diffuse = cos_theta * L::splat(FRAC_1_PI);
            return (diffuse, cos_theta * *normalisation * power);
        }
        let lit = |value: L| at.n_v.select_gt(zero, value, zero);
        (lit(cos_theta), lit(at.n_i.select_gt(zero, power, zero)))
    }
}
