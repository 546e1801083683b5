//! Point-to-point form factors on the GPU.

use super::{PointFormFactor, PointFormFactorParams};
use crate::kept::Kept;
use crate::texels::gpu::{AVERAGE, GpuTables, STORAGE, UNIFORM, gather_kernel, gather_parts};
use crate::{Changed, Estimator, EstimatorError, Gpu, Inputs, Prepared, Quantity, Records};
use interreflect_gpu::{GpuContext, GpuCx, GpuEstimate, Kernel, Shader};

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

/// What averaging reads, the texels and the kernel, kept across frames.
#[derive(Default)]
pub struct State {
    averaging: Kept<PointFormFactorParams, GpuTables>,
    texels: Option<wgpu::Buffer>,
    shade: Option<Kernel>,
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let made = self.averaging.made().zip(self.texels.as_ref());
        let read = |(tables, texels): (&GpuTables, _)| tables.records(context, texels);
        made.into_iter().map(read).collect()
    }
}

impl Estimator<Gpu> for PointFormFactor {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, SHADE[0], SHADE[1]];

    fn prepare(
        params: &PointFormFactorParams,
        state: &mut State,
        cx: &mut GpuCx,
        quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        let make = || GpuTables::new(cx.context(), &params.averaging());
        let averaging = state.averaging.tables(params, make)?;
        if stale || state.texels.is_none() {
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            state.texels = Some(averaging.average(cx, captured)?);
        }
        let texels = state.texels.as_ref().ok_or(EstimatorError::Unprepared)?;
        state.shade = Some(gather_kernel(
            cx.context(),
            &SHADE,
            &[("largest", f64::from(params.largest_omega_sr()))],
            (texels, averaging.count()),
            (quantity, inputs, out),
            &[],
        )?);
        Ok(())
    }

    fn shade(
        _params: &PointFormFactorParams,
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
