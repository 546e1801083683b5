//! Classic environment mapping on the GPU.

use super::math::phong_exponent;
use super::{ClassicEnvmap, ClassicEnvmapParams};
use crate::convolution::gpu as convolution;
use crate::lobes::{MAX_LOBES, lobes};
use crate::{
    Estimator, EstimatorError, Gpu, Inputs, LOBE_POWER, Prepared, Quantity, Records, reflection,
};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};

const SHADE: Shader = Shader {
    label: "classic_envmap shade",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::POINTS,
        LOBE_POWER,
        convolution::LEAVES,
        convolution::LOOKUP,
        reflection::LEAVES,
        include_str!("math.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

/// The convolved maps and the kernel that looks them up, kept across frames.
#[derive(Default)]
pub struct State {
    convolved: convolution::Convolved,
    shade: Option<Kernel>,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    cells: u32,
    lobes: u32,
    pad: [u32; 2],
    exponents: [f32; MAX_LOBES],
}

impl Shade {
    fn new(params: &ClassicEnvmapParams, exponents: &[f32]) -> Self {
        let mut shade = Self {
            cells: params.map_resolution,
            lobes: exponents.len() as u32,
            pad: [0; 2],
            exponents: [0.0; MAX_LOBES],
        };
        shade.exponents[..exponents.len()].copy_from_slice(exponents);
        shade
    }
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        self.convolved.records(context)
    }
}

impl Estimator<Gpu> for ClassicEnvmap {
    type State = State;

    const SHADERS: &'static [Shader] = &[convolution::SHADERS[0], convolution::SHADERS[1], SHADE];

    fn prepare(
        params: &ClassicEnvmapParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let kept = state.convolved.exponents().to_vec();
        let exponents = lobes(quantity, inputs, Some(kept), phong_exponent)?;
        let shade = Shade::new(params, &exponents);
        let shade = cx.context().uniform("classic_envmap shade", &shade)?;
        let maps = state
            .convolved
            .update(&params.sizes(), cx, inputs, exponents)?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&shade).into(), maps.into()];
        let entry = match quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
        state.shade = Some(cx.context().kernel(&SHADE, entry, &bindings)?);
        Ok(())
    }

    fn shade(
        _params: &ClassicEnvmapParams,
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
