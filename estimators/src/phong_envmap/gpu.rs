//! Phong-filtered environment maps on the GPU.

use super::{PhongEnvmap, PhongEnvmapParams};
use crate::convolution::gpu as convolution;
use crate::reflection::{self, Lobes};
use crate::{Estimator, EstimatorError, Gpu, Inputs, LOBE_POWER, Prepared, Quantity, Records};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};

const SHADE: Shader = Shader {
    label: "phong_envmap shade",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::POINTS,
        LOBE_POWER,
        convolution::LEAVES,
        convolution::LOOKUP,
        reflection::LEAVES,
        include_str!("shade.wgsl"),
    ],
};

/// The convolved maps and the kernel that looks them up, kept across frames.
#[derive(Default)]
pub struct State {
    convolved: convolution::Convolved,
    lobes: Lobes,
    shade: Option<Kernel>,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    cells: u32,
    f_lambda: f32,
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        self.convolved.records(context)
    }
}

impl Estimator<Gpu> for PhongEnvmap {
    type State = State;

    const SHADERS: &'static [Shader] = &[convolution::SHADERS[0], convolution::SHADERS[1], SHADE];

    fn prepare(
        params: &PhongEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let lobes = state.lobes.needed(quantity, inputs);
        let shade = Shade {
            cells: params.map_resolution,
            f_lambda: params.f_lambda,
        };
        let shade = cx.context().uniform("phong_envmap shade", &shade)?;
        let exponents = params.exponents(lobes);
        let maps = state
            .convolved
            .update(&params.sizes(), cx, inputs, exponents)?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&shade).into(), maps.into()];
        let entry = match quantity {
            Quantity::GlossyRadiance if lobes => "glossy",
            Quantity::GlossyRadiance => "matte",
            _ => "irradiance",
        };
        state.shade = Some(cx.context().kernel(&SHADE, entry, &bindings)?);
        Ok(())
    }

    fn shade(
        _params: &PhongEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        _out: &mut GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let shade = state.shade.as_ref().ok_or(EstimatorError::Unprepared)?;
        shade.record(cx, inputs.points.workgroups());
        Ok(())
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
