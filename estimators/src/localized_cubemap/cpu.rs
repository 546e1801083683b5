//! Localized cube maps on the CPU.

use super::math::{omega_corrected, omega_published, reflectivity_published};
use super::tables::Tables;
use super::{LocalizedCubemap, Reflectivity};
use crate::lobes::lobes;
use crate::texels::gather::{Cosines, TexelLight, gather};
use crate::texels::math::{lobe_normalisation, normalised_reflectivity};
use crate::texels::{Texel, average};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_scene::params::Fidelity;
use std::f64::consts::FRAC_1_PI;

/// The texels, what averaging reads, and the reflectivity's tables where it is not sampled.
pub struct Lights {
    fidelity: Fidelity,
    averaging: average::Tables,
    texels: Vec<Texel>,
    reflectivity: Option<Tables>,
}

impl Estimator<Cpu> for LocalizedCubemap {
    type Prepared = Lights;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Lights>,
    ) -> Result<Lights, EstimatorError> {
        let (averaging, texels, reflectivity) = match last {
            Some(last) => (
                last.averaging,
                frame.unless_stale(Some(last.texels)),
                last.reflectivity,
            ),
            None => (self.averaging(), None, None),
        };
        let texels = match texels {
            Some(texels) => texels,
            None => averaging.average(frame.cube(&self.captured(&frame.scene))?),
        };
        let reflectivity = match self.reflectivity {
            Reflectivity::Sample => None,
            Reflectivity::Table => {
                let known = reflectivity.as_ref().map(|t| t.lobes.clone());
                let lobes = lobes(frame, known, |n| n)?;
                let kept = reflectivity.filter(|t| t.lobes == lobes);
                Some(kept.unwrap_or_else(|| Tables::new(lobes)))
            }
        };
        Ok(Lights {
            fidelity: self.fidelity,
            averaging,
            texels,
            reflectivity,
        })
    }
}

impl Prepared<Cpu> for Lights {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let texels = &self.texels;
        match (self.fidelity, &self.reflectivity) {
            (Fidelity::Published, None) => gather(frame, texels, Published),
            (Fidelity::Corrected, None) => gather(frame, texels, Corrected),
            (Fidelity::Published, Some(tables)) => gather(frame, texels, Averaged::<false>(tables)),
            (Fidelity::Corrected, Some(tables)) => gather(frame, texels, Averaged::<true>(tables)),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![
            Records::host("texels", &self.texels).sharing_captures(),
        ])
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
