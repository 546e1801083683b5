//! Constant ambient light on the GPU.

use super::ConstantAmbient;
use crate::averaging::{captured_radiance, face_solid_angles_sr};
use crate::{Estimator, EstimatorError, Frame, Gpu, Kernels, Quantity, Records};
use interreflect_gpu::{GpuContext, Kernel, Shader, wgsl};

const AVERAGE: Shader = Shader {
    label: "constant_ambient average",
    parts: &[wgsl::CUBE, include_str!("average.wgsl")],
};

const SHADE: Shader = Shader {
    label: "constant_ambient shade",
    parts: &[
        wgsl::MATH,
        wgsl::POINTS,
        include_str!("math.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

/// The texels' solid angles, the mean radiance and the kernel with its bindings.
pub struct Mean {
    omegas_sr: wgpu::Buffer,
    radiance: wgpu::Buffer,
    shade: Kernel,
}

impl Estimator<Gpu> for ConstantAmbient {
    type Prepared = Mean;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Mean>,
    ) -> Result<Mean, EstimatorError> {
        let captured = frame.cube(&self.captured())?;
        let context = frame.context().clone();
        let omegas_sr = match last {
            Some(last) => last.omegas_sr,
            None => {
                let omegas_sr = face_solid_angles_sr(captured.spec().size);
                context.storage("constant_ambient solid angles", &omegas_sr)?
            }
        };
        let mean = context.storage_zeroed("constant_ambient mean", 16)?;
        let bindings = [
            captured_radiance(captured)?,
            (&omegas_sr).into(),
            (&mean).into(),
        ];
        let average = context.kernel(&AVERAGE, "mean_radiance", &bindings)?;
        average.record(frame.cx, [1, 1, 1]);

        let [points, info, estimate] = frame.point_bindings();
        let bindings = [points, info, estimate, (&mean).into()];
        let entry = match frame.quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
        Ok(Mean {
            shade: context.kernel(&SHADE, entry, &bindings)?,
            omegas_sr,
            radiance: mean,
        })
    }
}

impl Kernels for Mean {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let mean = Records::device::<[f32; 4]>("mean", context, &self.radiance)?;
        Ok(vec![mean])
    }
}
