//! Polygon-to-point form factors on the GPU.

use super::corners::{REUSED_EDGE, Tables};
use super::{Corners, Facing, PolygonFormFactor, PolygonFormFactorParams, Radiance};
use crate::kept::Kept;
use crate::texels::gpu::{AVERAGE, GpuTables, SURFACE, TEXEL, place, views};
use crate::{ANGLE, Changed, Estimator, EstimatorError, Gpu, Inputs, Prepared, Quantity, Records};
use interreflect_gpu::{GpuContext, GpuCube, GpuCx, GpuEstimate, Kernel, Shader, wgsl};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::params::Fidelity;

const CORNERS: Shader = Shader {
    label: "polygon_form_factor corners",
    parts: &[wgsl::CUBE, TEXEL, SURFACE, include_str!("corners.wgsl")],
};

const SHADE: Shader = Shader {
    label: "polygon_form_factor shade",
    parts: &[
        wgsl::POINTS,
        ANGLE,
        include_str!("math.wgsl"),
        include_str!("shade.wgsl"),
    ],
};

/// What averaging and the corners read, the quadrilaterals and the kernel, kept across frames.
#[derive(Default)]
pub struct State {
    tables: Kept<PolygonFormFactorParams, (GpuTables, GpuCorners)>,
    quads: Option<GpuQuads>,
    shade: Option<Kernel>,
}

/// [`Tables`] on the device.
struct GpuCorners {
    meeting: wgpu::Buffer,
    captured: wgpu::Buffer,
    directions: wgpu::Buffer,
    count: u32,
}

/// What shading reads.
struct GpuQuads {
    corners: wgpu::Buffer,
    radiances: wgpu::Buffer,
}

/// As `Build` in corners.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Build {
    m: u32,
    size: u32,
    place: u32,
    exact: u32,
    mean_radiance: u32,
    pad: u32,
}

/// As `Shade` in shade.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Shade {
    origin: [f32; 3],
    m: u32,
    reused: [[u32; 4]; CUBE_FACES],
}

impl GpuCorners {
    fn new(context: &GpuContext, tables: &Tables) -> Result<Self, EstimatorError> {
        let directions: Vec<[f32; 4]> = tables
            .directions()
            .map(|d| d.as_vec3().extend(0.0).to_array())
            .collect();
        Ok(Self {
            meeting: context.storage("texels that meet at corners", &tables.meeting)?,
            captured: context.storage("captured texels beside corners", &tables.captured)?,
            count: directions.len() as u32,
            directions: context.storage("directions of corners", &directions)?,
        })
    }

    /// Records the making of the quadrilaterals from averaged texels.
    fn quads(
        &self,
        params: &PolygonFormFactorParams,
        cx: &mut GpuCx,
        (texels, count): (&wgpu::Buffer, u32),
        captured: &GpuCube,
    ) -> Result<GpuQuads, EstimatorError> {
        let context = cx.context();
        let build = Build {
            m: params.resolution,
            size: captured.spec().size,
            place: place(captured.spec().channels),
            exact: u32::from(params.corners() == Corners::Exact),
            mean_radiance: u32::from(params.radiance == Radiance::Corners),
            pad: 0,
        };
        let build = context.uniform("polygon_form_factor corners", &build)?;
        let room = |label: &str, count: u32| context.storage_zeroed(label, u64::from(count) * 16);
        let quads = GpuQuads {
            corners: room("corners", self.count)?,
            radiances: room("radiances", count)?,
        };
        let [radiance, normals] = views(captured)?;
        let bindings = [
            (&build).into(),
            texels.into(),
            radiance,
            normals,
            (&self.meeting).into(),
            (&self.captured).into(),
            (&self.directions).into(),
            (&quads.corners).into(),
            (&quads.radiances).into(),
        ];
        let corners = context.kernel(&CORNERS, "build_corners", &bindings)?;
        let radiances = context.kernel(&CORNERS, "build_radiances", &bindings)?;
        corners.record(cx, [self.count.div_ceil(64), 1, 1]);
        radiances.record(cx, [count.div_ceil(64), 1, 1]);
        Ok(quads)
    }
}

impl Prepared<Gpu> for State {
    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let Some(quads) = &self.quads else {
            return Ok(Vec::new());
        };
        let buffers = [("corners", &quads.corners), ("radiances", &quads.radiances)];
        let read = |(name, buffer)| Records::device::<[f32; 4]>(name, context, buffer);
        buffers.into_iter().map(read).collect()
    }
}

impl Estimator<Gpu> for PolygonFormFactor {
    type State = State;

    const SHADERS: &'static [Shader] = &[AVERAGE, CORNERS, SHADE];

    fn prepare(
        params: &PolygonFormFactorParams,
        state: &mut State,
        cx: &mut GpuCx,
        _quantity: Quantity,
        inputs: &Inputs<'_, Gpu>,
        out: &GpuEstimate,
    ) -> Result<(), EstimatorError> {
        let stale = inputs.changed.any(Changed::PARAMS | Changed::CAPTURES);
        if stale || state.quads.is_none() {
            let make = || {
                let averaging = GpuTables::new(cx.context(), &params.averaging())?;
                Ok((
                    averaging,
                    GpuCorners::new(cx.context(), &Tables::new(params))?,
                ))
            };
            let (averaging, corners) = state.tables.tables(params, make)?;
            let captured = inputs.cube(&params.captured(&inputs.scene))?;
            let texels = averaging.average(cx, captured)?;
            let texels = (&texels, averaging.count());
            state.quads = Some(corners.quads(params, cx, texels, captured)?);
        }
        let quads = state.quads.as_ref().ok_or(EstimatorError::Unprepared)?;
        let shade = Shade {
            origin: inputs.reference_point.to_array(),
            m: params.resolution,
            reused: REUSED_EDGE.map(|(a, b)| [a as u32, b as u32, 0, 0]),
        };
        let shade = cx.context().uniform("polygon_form_factor shade", &shade)?;
        let [points, info, estimate] = inputs.points.bindings(out);
        let bindings = [
            points,
            info,
            estimate,
            (&shade).into(),
            (&quads.corners).into(),
            (&quads.radiances).into(),
        ];
        let constants = [
            ("corrected", params.fidelity == Fidelity::Corrected),
            ("facing_signed", params.facing == Facing::Signed),
        ];
        let constants = constants.map(|(name, on)| (name, f64::from(u8::from(on))));
        let kernel = cx
            .context()
            .kernel_with(&SHADE, "irradiance", &constants, &bindings)?;
        state.shade = Some(kernel);
        Ok(())
    }

    fn shade(
        _params: &PolygonFormFactorParams,
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
