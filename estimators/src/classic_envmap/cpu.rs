//! Classic environment mapping on the CPU.

use super::ClassicEnvmap;
use super::math::phong_exponent;
use crate::convolution::cpu::{Convolved, Maps};
use crate::lobes::lobes;
use crate::reflection::math::mirrored;
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Quantity, Records};
use interreflect_cpu::lane::Lane;
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;
use std::f64::consts::FRAC_1_PI;

/// The convolved maps.
pub struct Filtered(Convolved);

impl Estimator<Cpu> for ClassicEnvmap {
    type Prepared = Filtered;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let last = last.map(|last| last.0);
        let known = last.as_ref().map(Convolved::exponents);
        let exponents = lobes(frame, known, phong_exponent)?;
        Ok(Filtered(Convolved::new(
            &self.sizes(),
            frame,
            exponents,
            last,
        )?))
    }
}

impl Prepared<Cpu> for Filtered {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let maps = self.0.maps();
        match frame.quantity {
            Quantity::GlossyRadiance => frame.for_each_tile(&Glossy(maps)),
            _ => frame.for_each_tile(&maps.irradiance),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(self.0.records())
    }
}

/// L = k_d/π·E(n) + k_s·L_N(r).
struct Glossy<'a>(&'a Maps);

impl TileKernel for Glossy<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let reflected = mirrored(n, points.vector(PointLayout::VIEW));
        let exponent = phong_exponent(points.plane(PointLayout::SHININESS));
        let specular = self.0.of_lobe(exponent, reflected).to_array();
        let irradiance = self.0.irradiance.along(n).to_array();
        std::array::from_fn(|c| {
            let diffuse = irradiance[c] * L::splat(FRAC_1_PI);
            points.plane(PointLayout::DIFFUSE + c) * diffuse
                + points.plane(PointLayout::SPECULAR + c) * specular[c]
        })
    }
}
