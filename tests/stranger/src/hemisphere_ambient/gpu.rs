//! Hemisphere ambient light on the GPU.

use super::HemisphereAmbient;
use interreflect::averaging::captured_radiance;
use interreflect::{prelude::*, wgpu};

const AVERAGE: Shader = Shader {
    label: "hemisphere_ambient average",
    parts: &[wgsl::CUBE, include_str!("average.wgsl")],
};

const SHADE: Shader = Shader {
    label: "hemisphere_ambient shade",
    parts: &[
        wgsl::MATH,
        wgsl::POINTS,
        include_str!("math.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

/// Mean radiance from below and from above, and the kernel that blends them.
pub struct Means {
    means: wgpu::Buffer,
    shade: Kernel,
}

impl Estimator<Gpu> for HemisphereAmbient {
    type Prepared = Means;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        _last: Option<Means>,
    ) -> Result<Means, EstimatorError> {
        let context = frame.context().clone();
        let means = context.storage_zeroed("hemisphere_ambient means", 32)?;
        let captured = captured_radiance(frame.cube(&self.captured())?)?;
        let average = context.kernel(&AVERAGE, "average", &[captured, (&means).into()])?;
        average.record(frame.cx, [1, 1, 1]);
        let [points, info, estimate] = frame.point_bindings();
        let bindings = [points, info, estimate, (&means).into()];
        let shade = context.kernel(&SHADE, "shade", &bindings)?;
        Ok(Means { means, shade })
    }
}

impl Kernels for Means {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let means = Records::device::<[f32; 4]>("means", context, &self.means)?;
        Ok(vec![means])
    }
}
