//! Shadow maps: distances from each light to the first surface.

use super::raster::{Drawing, RASTER, array_view, begin_pass, layer_view};
use crate::pipeline::{Raster, RenderSpec};
use crate::{Binding, GpuCx, GpuError, GpuScene, Shader, lights::GpuLights, scene, wgsl};

/// Texels along the edge of a shadow map. A texel is 2/1024 of the distance to the light wide
/// (0.11°): the edge of a shadow is good to half of that. The six maps of a light take 24 MiB.
pub(crate) const SHADOW_SIZE: u32 = 1024;

/// WGSL of the maps' geometry.
pub(crate) const SHADOW_MAPS: &str = include_str!("shadow_maps.wgsl");

/// WGSL of the test against them.
pub(crate) const SHADOW_TEST: &str = include_str!("shadow_test.wgsl");

pub(crate) const SHADER: Shader = Shader {
    label: "shadow maps",
    parts: &[
        wgsl::MATH,
        wgsl::CUBE,
        wgsl::LIGHTS,
        RASTER,
        SHADOW_MAPS,
        include_str!("shadow.wgsl"),
    ],
};

/// Records the shadow maps of all lights into the layers of one texture: shadows of the triangles of a scene's
/// first `corners` corners.
pub(crate) fn record_shadow_maps(
    cx: &mut GpuCx,
    scene: &GpuScene,
    (lights, corners): (&GpuLights, u32),
) -> Result<wgpu::TextureView, GpuError> {
    let context = cx.context().clone();
    let layers = lights.shadow_instances.len() as u32;
    let format = wgpu::TextureFormat::R32Float;
    let maps = context.target_array("shadow maps", SHADOW_SIZE, layers, format)?;
    let depth = context.depth_target(SHADOW_SIZE)?;
    let spec = RenderSpec {
        shader: &SHADER,
        vertex: "vs_shadow",
        fragment: Some("fs_shadow"),
        raster: Raster::Nearest,
        buffers: &[Some(scene::VERTEX)],
        targets: &[Some(format)],
    };
    let drawing = Drawing::new(&context, &spec, &[Binding::Buffer(&lights.buffer)])?;
    for (layer, &instance) in (0..).zip(&lights.shadow_instances) {
        let target = Some(layer_view(&maps, layer));
        let mut pass = begin_pass(cx, SHADER.label, &[target], &depth);
        drawing.draw(&mut pass, &scene.vertices, corners, instance);
    }
    Ok(array_view(&maps))
}
