//! Phong-filtered environment maps on the GPU.

use super::PhongEnvmap;
use crate::convolution::gpu::{self as convolution, Convolved};
use crate::reflection::{self, Lobes};
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, LOBE_POWER, Quantity, Records};
use interreflect_gpu::{GpuContext, Kernel, Shader, wgsl};

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

/// The convolved maps and the kernel that looks them up.
pub struct Filtered {
    convolved: Convolved,
    lobes: Lobes,
    shade: Kernel,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    cells: u32,
    f_lambda: f32,
}

impl Estimator<Gpu> for PhongEnvmap {
    type Prepared = Filtered;

    const SHADERS: &'static [Shader] = &[convolution::SHADERS[0], convolution::SHADERS[1], SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let context = frame.context().clone();
        let (last, mut lobes) = match last {
            Some(last) => (Some(last.convolved), last.lobes),
            None => (None, Lobes::default()),
        };
        let shines = lobes.needed(frame);
        let shade = Shade {
            cells: self.map_resolution,
            f_lambda: self.f_lambda,
        };
        let shade = context.uniform("phong_envmap shade", &shade)?;
        let convolved = Convolved::new(&self.sizes(), frame, self.exponents(shines), last)?;
        let [points, info, estimate] = frame.point_bindings();
        let maps = convolved.maps().into();
        let bindings = [points, info, estimate, (&shade).into(), maps];
        let entry = match frame.quantity {
            Quantity::GlossyRadiance if shines => "glossy",
            Quantity::GlossyRadiance => "matte",
            _ => "irradiance",
        };
        Ok(Filtered {
            shade: context.kernel(&SHADE, entry, &bindings)?,
            convolved,
            lobes,
        })
    }
}

impl Kernels for Filtered {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        self.convolved.records(context)
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
