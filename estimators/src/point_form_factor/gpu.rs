//! Point-to-point form factors on the GPU.

use super::PointFormFactor;
use crate::texels::gpu::{AVERAGE, GpuTables, STORAGE, UNIFORM, gather_kernel, gather_parts};
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, Records};
use interreflect_gpu::{GpuContext, Kernel, Shader};

const LEAVES: &str = include_str!("math.wgsl");
const LIGHT: &str = include_str!("light.wgsl");

const SHADE: [Shader; 2] = [
    Shader {
        label: "point_form_factor shade, uniform texels",
        parts: &gather_parts(LEAVES, LIGHT, UNIFORM),
    },
    Shader {
        label: "point_form_factor shade, stored texels",
        parts: &gather_parts(LEAVES, LIGHT, STORAGE),
    },
];

/// The texels, what averaging reads, and the kernel.
pub struct Lights {
    averaging: GpuTables,
    texels: wgpu::Buffer,
    shade: Kernel,
}

impl Estimator<Gpu> for PointFormFactor {
    type Prepared = Lights;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE[0], SHADE[1]];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Lights>,
    ) -> Result<Lights, EstimatorError> {
        let (averaging, texels) = match last {
            Some(last) => (last.averaging, frame.unless_stale(Some(last.texels))),
            None => (GpuTables::new(frame.context(), &self.averaging())?, None),
        };
        let texels = match texels {
            Some(texels) => texels,
            None => averaging.average(frame.cx, frame.cube(&self.captured(&frame.scene))?)?,
        };
        let largest = f64::from(self.largest_omega_sr());
        let constants = [("largest", largest)];
        let shade = gather_kernel(frame, &SHADE, &constants, (&texels, averaging.count()), &[])?;
        Ok(Lights {
            averaging,
            texels,
            shade,
        })
    }
}

impl Kernels for Lights {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        Ok(vec![self.averaging.records(context, &self.texels)?])
    }
}
