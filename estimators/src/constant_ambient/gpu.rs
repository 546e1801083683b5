//! Constant ambient light on the GPU.

use super::{ConstantAmbient, ConstantAmbientParams};
use crate::averaging::face_solid_angles_sr;
use crate::kept::Kept;
use crate::{Estimator, EstimatorError, Gpu, Inputs, Prepared, Quantity, Records};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader, wgsl};

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

/// The texels' solid angles, the mean radiance and the kernel with its bindings, kept across frames.
#[derive(Default)]
pub struct State {
    omegas_sr: Kept<ConstantAmbientParams, wgpu::Buffer>,
    mean: Option<wgpu::Buffer>,
    shade: Option<Kernel>,
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let mean = self.mean.iter();
        mean.map(|mean| Records::device::<[f32; 4]>("mean", context, mean))
            .collect()
    }
}

impl Estimator<Gpu> for ConstantAmbient {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE];

    fn prepare(
        params: &ConstantAmbientParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let captured = inputs.cube(&params.captured())?;
        let missing = || EstimatorError::Missing("the radiance of the captured cube".into());
        let radiance = captured.radiance_distance().ok_or_else(missing)?;
        let context = cx.context().clone();
        let omegas_sr = state.omegas_sr.tables(params, || {
            let omegas_sr = face_solid_angles_sr(captured.spec().size);
            Ok(context.storage("constant_ambient solid angles", &omegas_sr)?)
        })?;
        let mean = context.storage_zeroed("constant_ambient mean", 16)?;
        let bindings = [radiance.into(), (&*omegas_sr).into(), (&mean).into()];
        let average = context.kernel(&AVERAGE, "mean_radiance", &bindings)?;
        average.record(cx, [1, 1, 1]);

        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [points, info, estimate, (&mean).into()];
        let entry = match quantity {
            Quantity::GlossyRadiance => "glossy",
            _ => "irradiance",
        };
        state.shade = Some(context.kernel(&SHADE, entry, &bindings)?);
        state.mean = Some(mean);
        Ok(())
    }

    fn shade(
        _params: &ConstantAmbientParams,
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
