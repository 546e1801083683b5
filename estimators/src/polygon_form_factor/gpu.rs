//! Polygon-to-point form factors on the GPU.

use super::corners::{REUSED_EDGE, Tables};
use super::{Corners, Facing, PolygonFormFactor, Radiance};
use crate::texels::gpu::{AVERAGE, GpuTables, SURFACE, TEXEL, place, views};
use crate::{ANGLE, Estimator, EstimatorError, Frame, Gpu, Kernels, Records};
use interreflect_gpu::{GpuContext, GpuCube, GpuCx, Kernel, Shader, wgsl};
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

/// The quadrilaterals, what averaging and the corners read, and the kernel.
pub struct Polygons {
    averaging: GpuTables,
    corners: GpuCorners,
    quads: GpuQuads,
    shade: Kernel,
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
        method: &PolygonFormFactor,
        cx: &mut GpuCx,
        (texels, count): (&wgpu::Buffer, u32),
        captured: &GpuCube,
    ) -> Result<GpuQuads, EstimatorError> {
        let context = cx.context();
        let build = Build {
            m: method.resolution,
            size: captured.spec().size,
            place: place(captured.spec().channels),
            exact: u32::from(method.corners() == Corners::Exact),
            mean_radiance: u32::from(method.radiance == Radiance::Corners),
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

impl Estimator<Gpu> for PolygonFormFactor {
    type Prepared = Polygons;

    const SHADERS: &'static [Shader] = &[AVERAGE, CORNERS, SHADE];

    fn prepare(
        &self,
        frame: &mut Frame<'_, Gpu>,
        last: Option<Polygons>,
    ) -> Result<Polygons, EstimatorError> {
        let context = frame.context().clone();
        let (averaging, corners, quads) = match last {
            Some(last) => (
                last.averaging,
                last.corners,
                frame.unless_stale(Some(last.quads)),
            ),
            None => {
                let averaging = GpuTables::new(&context, &self.averaging())?;
                let corners = GpuCorners::new(&context, &Tables::new(self))?;
                (averaging, corners, None)
            }
        };
        let quads = match quads {
            Some(quads) => quads,
            None => {
                let captured = frame.cube(&self.captured(&frame.scene))?;
                let texels = averaging.average(frame.cx, captured)?;
                corners.quads(self, frame.cx, (&texels, averaging.count()), captured)?
            }
        };
        let shade = Shade {
            origin: frame.reference_point.to_array(),
            m: self.resolution,
            reused: REUSED_EDGE.map(|(a, b)| [a as u32, b as u32, 0, 0]),
        };
        let shade = context.uniform("polygon_form_factor shade", &shade)?;
        let [points, info, estimate] = frame.point_bindings();
        let bindings = [
            points,
            info,
            estimate,
            (&shade).into(),
            (&quads.corners).into(),
            (&quads.radiances).into(),
        ];
        let constants = [
            ("corrected", self.fidelity == Fidelity::Corrected),
            ("facing_signed", self.facing == Facing::Signed),
        ];
        let constants = constants.map(|(name, on)| (name, f64::from(u8::from(on))));
        let shade = context.kernel_with(&SHADE, "irradiance", &constants, &bindings)?;
        Ok(Polygons {
            averaging,
            corners,
            quads,
            shade,
        })
    }
}

impl Kernels for Polygons {
    fn kernels(&self) -> &[Kernel] {
        std::slice::from_ref(&self.shade)
    }

    fn records(&self, context: &GpuContext) -> Result<Vec<Records>, EstimatorError> {
        let quads = &self.quads;
        let buffers = [("corners", &quads.corners), ("radiances", &quads.radiances)];
        let read = |(name, buffer)| Records::device::<[f32; 4]>(name, context, buffer);
        buffers.into_iter().map(read).collect()
    }
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
