//! Phong-filtered environment maps on the CPU.

use super::PhongEnvmap;
use crate::convolution::cpu::{Convolved, Maps};
use crate::reflection::Lobes;
use crate::reflection::math::{fresnel_mix, mirrored, schlick};
use crate::{Cpu, Estimator, EstimatorError, Frame, Prepared, Quantity, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{PointLanes, TileKernel};
use interreflect_scene::PointLayout;

/// The convolved maps.
pub struct Filtered {
    f_lambda: f32,
    convolved: Convolved,
    lobes: Lobes,
}

impl Estimator<Cpu> for PhongEnvmap {
    type Prepared = Filtered;

    fn prepare(
        &self,
        frame: &mut Frame<'_, Cpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let (last, mut lobes) = match last {
            Some(last) => (Some(last.convolved), last.lobes),
            None => (None, Lobes::default()),
        };
        let exponents = self.exponents(lobes.needed(frame));
        Ok(Filtered {
            f_lambda: self.f_lambda,
            convolved: Convolved::new(&self.sizes(), frame, exponents, last)?,
            lobes,
        })
    }
}

impl Prepared<Cpu> for Filtered {
    fn shade(&self, frame: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        let maps = self.convolved.maps();
        let f_lambda = self.f_lambda;
        match frame.quantity {
            Quantity::GlossyRadiance => frame.for_each_tile(&Glossy { maps, f_lambda }),
            _ => frame.for_each_tile(&maps.irradiance),
        }
        Ok(())
    }

    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(self.convolved.records())
    }
}

/// L_o = (1 − F)·k_d/π·E(n) + F·k_s·L_N(r), the latter 0 where no point has a lobe.
struct Glossy<'a> {
    maps: &'a Maps,
    f_lambda: f32,
}

impl TileKernel for Glossy<'_> {
    #[inline(always)]
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let v = points.vector(PointLayout::VIEW);
        let fresnel = schlick(self.f_lambda.into(), n.dot(v));
        let irradiance = self.maps.irradiance.along(n).to_array();
        let nothing = Vector::splat([0.0; 3]);
        let lobe = self.maps.lobes.first();
        let radiance = lobe.map_or(nothing, |(_, map)| map.along(mirrored(n, v)));
        let radiance = radiance.to_array();
        std::array::from_fn(|c| {
            let diffuse = points.plane(PointLayout::DIFFUSE + c);
            let specular = points.plane(PointLayout::SPECULAR + c);
            fresnel_mix(fresnel, diffuse, irradiance[c], specular, radiance[c])
        })
    }
}
