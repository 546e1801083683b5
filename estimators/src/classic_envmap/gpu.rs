//! Classic environment mapping on the GPU.

use super::ClassicEnvmap;
use super::math::phong_exponent;
use crate::convolution::gpu::{self as convolution, Convolved};
use crate::lobes::{MAX_LOBES, lobes};
use crate::{
    Estimator, EstimatorError, Frame, Gpu, Kernels, LOBE_POWER, Quantity, Records, reflection,
};
use interreflect_gpu::{GpuContext, Kernel, Shader, wgsl};

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

/// The convolved maps and the kernel that looks them up.
pub struct Filtered {
    convolved: Convolved,
    shade: Kernel,
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
    fn new(method: &ClassicEnvmap, exponents: &[f32]) -> Self {
        let mut shade = Self {
            cells: method.map_resolution,
            lobes: exponents.len() as u32,
            pad: [0; 2],
            exponents: [0.0; MAX_LOBES],
        };
        shade.exponents[..exponents.len()].copy_from_slice(exponents);
        shade
    }
}

impl Estimator<Gpu> for ClassicEnvmap {
    type Prepared = Filtered;

    const SHADERS: &'static [Shader] = &[convolution::SHADERS[0], convolution::SHADERS[1], SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Filtered>,
    ) -> Result<Filtered, EstimatorError> {
        let context = frame.context().clone();
        let last = last.map(|last| last.convolved);
        let known = last.as_ref().map(Convolved::exponents);
        let exponents = lobes(frame, known, phong_exponent)?;
        let shade = Shade::new(self, &exponents);
        let shade = context.uniform("classic_envmap shade", &shade)?;
        let convolved = Convolved::new(&self.sizes(), frame, exponents, last)?;
        let [points, info, estimate] = frame.point_bindings();
        let maps = convolved.maps().into();
        let bindings = [points, info, estimate, (&shade).into(), maps];
        let entry = match frame.quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
        Ok(Filtered {
            shade: context.kernel(&SHADE, entry, &bindings)?,
            convolved,
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
