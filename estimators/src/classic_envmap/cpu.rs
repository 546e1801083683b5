//! Classic environment mapping on the CPU.

use super::math::phong_exponent;
use super::{ClassicEnvmap, ClassicEnvmapParams};
use crate::convolution::cpu::{Convolved, Maps};
use crate::lobes::lobes;
use crate::reflection::math::mirrored;
use crate::{Cpu, Estimator, EstimatorError, Inputs, Prepared, Quantity, Records};
use interreflect_cpu::lane::Lane;
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout};
use std::f64::consts::FRAC_1_PI;

/// The convolved maps, kept across frames.
#[derive(Default)]
pub struct State(Convolved);

impl Prepared<Cpu> for State {
    fn records(&self, _caps: &()) -> Result<Vec<Records>, EstimatorError> {
        Ok(self.0.records())
    }
}

impl Estimator<Cpu> for ClassicEnvmap {
    type State = State;

    fn prepare(
        params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        _out: &Estimate,
    ) -> Result<(), EstimatorError> {
        let exponents = lobes(quantity, inputs, state.0.exponents(), phong_exponent)?;
        state.0.update(&params.sizes(), cx, inputs, exponents)
    }

    fn shade(
        _params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut &CpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Cpu>,
        out: &mut Estimate,
    ) -> Result<(), EstimatorError> {
        let maps = state.0.maps()?;
        match quantity {
            Quantity::GlossyRadiance => cx.for_each_tile(inputs.points, out, &Glossy(maps)),
            _ => cx.for_each_tile(inputs.points, out, &maps.irradiance),
        }
        Ok(())
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
