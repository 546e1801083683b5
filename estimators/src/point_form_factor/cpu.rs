//! Point-to-point form factors on the CPU.

use super::PointFormFactor;
use super::math::point_omega;
use crate::texels::gather::{Cosines, TexelLight, gather};
use crate::texels::math::{lobe_normalisation, normalised_reflectivity};
use crate::texels::{Texel, average};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Records};
use interreflect_cpu::lane::{Lane, Vector};

/// The texels, what averaging reads, and the largest solid angle in sr.
pub struct Lights {
    averaging: average::Tables,
    texels: Vec<Texel>,
    light: PointLight,
}

impl Estimator<Cpu> for PointFormFactor {
    type Prepared = Lights;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Lights>,
    ) -> Result<Lights, EstimatorError> {
        let (averaging, texels) = match last {
            Some(last) => (last.averaging, frame.unless_stale(Some(last.texels))),
            None => (self.averaging(), None),
        };
        let texels = match texels {
            Some(texels) => texels,
            None => averaging.average(frame.cube(&self.captured(&frame.scene))?),
        };
        let largest = self.largest_omega_sr();
        Ok(Lights {
            averaging,
            texels,
            light: PointLight { largest },
        })
    }
}

impl Prepared<Cpu> for Lights {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        gather(frame, &self.texels, self.light);
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![
            Records::host("texels", &self.texels).sharing_captures(),
        ])
    }
}

#[derive(Clone, Copy)]
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
