//! Phong-filtered environment maps on the CPU.

use super::{PhongEnvmap, PhongEnvmapParams};
use crate::convolution::cpu::{Convolved, Maps};
use crate::reflection::Lobes;
use crate::reflection::math::{fresnel_mix, mirrored, schlick};
use crate::{Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use interreflect_cpu::lane::{Lane, Vector};
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout};

/// The convolved maps, kept across frames.
#[derive(Default)]
pub struct State {
    convolved: Convolved,
    lobes: Lobes,
}

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(self.convolved.records())
    }
}

impl Estimator<Cpu> for PhongEnvmap {
    type State = State;

    fn prepare(
        params: &PhongEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let exponents = params.exponents(state.lobes.needed(quantity, inputs));
        state
            .convolved
            .update(&params.sizes(), cx, inputs, exponents)
    }

    fn shade(
        params: &PhongEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let maps = state.convolved.maps()?;
        let f_lambda = params.f_lambda;
        match quantity {
            Quantity::GlossyRadiance => {
                cx.for_each_tile(inputs.points, out, &Glossy { maps, f_lambda });
            }
            _ => cx.for_each_tile(inputs.points, out, &maps.irradiance),
        }
        Ok(())
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
