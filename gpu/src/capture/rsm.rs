//! Views from the lights: what is lit, along the rays through texel centres.

use super::raster::{Drawing, RASTER, array_view, begin_pass, layer_view};
use super::shadow::SHADOW_MAPS;
use crate::pipeline::{Raster, RenderSpec};
use crate::rsm::Planes;
use crate::scene::{Bounds, MATERIAL};
use crate::{Binding, GpuContext, GpuCx, GpuError, GpuRsm, GpuScene, Shader, scene, wgsl};
use bytemuck::{Pod, Zeroable};
use interreflect_scene::{LightFrame, Projection, RsmSpec, light_frames};

pub(crate) const SHADER: Shader = Shader {
    label: "RSMs",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::LIGHTS,
        RASTER,
        SHADOW_MAPS,
        MATERIAL,
        wgsl::TRUE_COLORS,
        include_str!("rsm.wgsl"),
    ],
};

/// Label of the pass that follows light through mirrors; there only where a scene has some.
const MIRRORS: &str = "mirrors in RSMs";

/// Most triangles of a scene whose mirrors are followed. The 64 lanes of a workgroup share them, for
/// each of eight mirrors, and lavapipe ends the loops of an invocation after 65,535 turns in all.
pub const MAX_MIRRORED_TRIANGLES: u32 = 64 * 8000;

/// Format of what is rasterised: a triangle and a distance.
const SEEN: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// The WGSL struct `Frame`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Frame {
    pub(crate) origin: [f32; 3],
    pub(crate) light: u32,
    pub(crate) axis: [f32; 3],
    pub(crate) half_extent: f32,
    pub(crate) right: [f32; 3],
    pub(crate) orthographic: u32,
    pub(crate) down: [f32; 3],
    pub(crate) near: f32,
}

/// The WGSL struct `Views`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Views {
    pub(crate) size: u32,
    pub(crate) channels: u32,
    pub(crate) triangles: u32,
    pub(crate) ray_start: f32,
    pub(crate) pixels: u32,
}

impl Frame {
    fn new(frame: &LightFrame, extent: Bounds) -> Self {
        Self {
            origin: frame.origin.to_array(),
            light: frame.light,
            axis: frame.axis.to_array(),
            half_extent: frame.half,
            right: frame.right.to_array(),
            orthographic: u32::from(frame.projection == Projection::Orthographic),
            down: frame.down.to_array(),
            near: extent.near(frame.origin),
        }
    }
}

/// Records views from every light: what `spec` asks for, of all surfaces.
///
/// Surfaces are rasterised to find the triangle of each texel, then each texel's ray is cut with
/// the triangle's plane: no shadow pass, for what a light's ray meets first is lit. Where the scene
/// has mirrors a further pass follows the texels that show one, by casting rays against all
/// triangles; a scene without any has no such pass. Mirrors count as on the host
/// (`interreflect_cpu::capture::rsm`).
///
/// # Errors
/// [`GpuError::MirroredTriangles`] if a scene with mirrors has more than
/// [`MAX_MIRRORED_TRIANGLES`], or another [`GpuError`] if the device has no room.
pub fn capture_rsms(cx: &mut GpuCx, scene: &GpuScene, spec: RsmSpec) -> Result<GpuRsm, GpuError> {
    let context = cx.context().clone();
    let from = light_frames(&scene.view_lights, &scene.surroundings, spec.views);
    let count = from.len() as u32;
    let extent = Bounds::around(&scene.surroundings.all);
    let frames: Vec<_> = from.iter().map(|f| Frame::new(f, extent)).collect();
    let view = GpuRsm::blank(&context, from, scene.surroundings.all, spec)?;
    let Some(lights) = scene.lights.as_ref().filter(|_| scene.all_vertex_count > 0) else {
        return Ok(view);
    };
    let triangles = scene.all_vertex_count / 3;
    if scene.corner_normals.is_some() && triangles > MAX_MIRRORED_TRIANGLES {
        return Err(GpuError::MirroredTriangles {
            triangles,
            max: MAX_MIRRORED_TRIANGLES,
        });
    }
    let frames = context.storage("frames of RSMs", &frames)?;
    let seen = rasterise(
        cx,
        &context,
        scene,
        (&frames, count),
        spec.size * pixels_per_texel(spec.size),
    )?;
    let views = Views {
        size: spec.size,
        channels: u32::from(spec.channels.radiance)
            | u32::from(spec.channels.normal) << 1
            | u32::from(spec.channels.true_colors) << 2,
        triangles,
        // Rays start on mirrors: so far, positions in f32 are off their plane.
        ray_start: 4e-6 * extent.reach(),
        pixels: pixels_per_texel(spec.size),
    };
    let views = context.uniform("RSMs", &views)?;
    let Planes {
        position,
        radiance,
        normal,
        true_colors,
    } = &view.planes;
    let bindings = [
        (&views).into(),
        (&frames).into(),
        (&lights.buffer).into(),
        (&scene.materials).into(),
        (&seen).into(),
        (&scene.vertices).into(),
        scene
            .corner_normals
            .as_ref()
            .map_or(Binding::None, Binding::Buffer),
        position.into(),
        radiance.into(),
        normal.into(),
        true_colors.into(),
    ];
    let resolve = context.kernel(&SHADER, "resolve", &bindings)?;
    resolve.record(cx, [spec.size.pow(2).div_ceil(64), count, 1]);
    if scene.corner_normals.is_some() {
        let follow = context.kernel(&SHADER, "follow", &bindings)?;
        follow.record_as(cx, MIRRORS, [spec.size, spec.size, count]);
    }
    Ok(view)
}

/// Pixels along the edge of a picture that are rasterised at least, where it has fewer texels.
const PIXELS: u32 = 256;

/// Pixels along the edge of a texel: odd, so that one lies in its middle. Corners are rasterised to 1/256 of a
/// pixel, which of a coarse picture's texel is more than small triangles allow.
fn pixels_per_texel(size: u32) -> u32 {
    PIXELS.div_ceil(size) | 1
}

/// Records which triangle each pixel shows, `size`² pixels a frame, one pass a frame.
fn rasterise(
    cx: &mut GpuCx,
    context: &GpuContext,
    scene: &GpuScene,
    (frames, layers): (&wgpu::Buffer, u32),
    size: u32,
) -> Result<wgpu::TextureView, GpuError> {
    let seen = context.target_array("first surfaces of RSMs", size, layers, SEEN)?;
    let depth = context.depth_target(size)?;
    let spec = RenderSpec {
        shader: &SHADER,
        vertex: "vs_view",
        fragment: Some("fs_view"),
        raster: Raster::Nearest,
        buffers: &[Some(scene::VERTEX)],
        targets: &[Some(SEEN)],
    };
    let drawing = Drawing::new(context, &spec, &[Binding::None, Binding::Buffer(frames)])?;
    for layer in 0..layers {
        let target = Some(layer_view(&seen, layer));
        let mut pass = begin_pass(cx, SHADER.label, &[target], &depth);
        let corners = scene.all_vertex_count;
        drawing.draw(&mut pass, &scene.vertices, corners, layer);
    }
    Ok(array_view(&seen))
}
