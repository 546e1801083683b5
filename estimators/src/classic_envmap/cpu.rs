//! Classic environment mapping on the CPU.

use super::math::phong_exponent;
use super::{ClassicEnvmap, ClassicEnvmapParams};
use crate::convolution::cpu::{Convolved, Maps};
use crate::lobes::lobes;
use crate::reflection::math::mirrored;
use crate::reflection::{at, lanes};
use crate::{Cpu, Estimator, EstimatorError, Inputs, Quantity};
use glam::Vec3;
use interreflect_cpu::lane::Wide;
use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
use interreflect_scene::{Estimate, PointLayout};
use std::f32::consts::FRAC_1_PI;

/// The convolved maps, kept across frames.
#[derive(Default)]
pub struct State(Convolved);

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
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
        let n = points.vector(PointLayout::NORMAL);
        let reflected = mirrored(n, points.vector(PointLayout::VIEW));
        let (kd, ks) = (
            points.vector(PointLayout::DIFFUSE),
            points.vector(PointLayout::SPECULAR),
        );
        let shininess = points.plane(PointLayout::SHININESS);
        lanes(|lane| {
            let exponent = phong_exponent(shininess.0[lane]);
            let lobe = self.0.lobes.iter().find(|(e, _)| *e >= exponent);
            let specular = lobe.map_or(Vec3::ZERO, |(_, map)| map.lookup(at(reflected, lane)));
            let diffuse = self.0.irradiance.lookup(at(n, lane)) * FRAC_1_PI;
            at(kd, lane) * diffuse + at(ks, lane) * specular
        })
    }
}
