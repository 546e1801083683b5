//! Direct light at points, by shadow maps.

use crate::capture::shadow::{SHADOW_MAPS, SHADOW_TEST, record_shadow_maps};
use crate::{Binding, GpuCx, GpuError, GpuEstimate, GpuPoints, GpuScene, Shader, wgsl};
use interreflect_scene::{DirectLight, ReflectionLaw};

pub(crate) const SHADER: Shader = Shader {
    label: "direct light",
    parts: &[
        wgsl::MATH,
        wgsl::POINTS,
        wgsl::CUBE,
        wgsl::LIGHTS,
        SHADOW_MAPS,
        SHADOW_TEST,
        include_str!("direct.wgsl"),
    ],
};

/// Records shadow maps of all objects, if there are to be shadows, and the radiance that points reflect towards
/// their viewers of the light that comes straight from the scene's lights. Points have the layout with materials.
///
/// Error against ray casting: that of shadow maps (see [`crate::capture_cube`]), and on a curved mesh that of its
/// points' normals, along which a surface is followed to the map's texel.
///
/// # Errors
/// [`GpuError`] if the device has no room.
pub fn direct_light(
    cx: &mut GpuCx,
    scene: &GpuScene,
    points: &GpuPoints,
    out: &GpuEstimate,
    how: DirectLight,
) -> Result<(), GpuError> {
    out.clear(cx);
    let Some(lights) = &scene.lights else {
        return Ok(());
    };
    let shadows = how.shadows.then_some(scene.all_vertex_count);
    let maps = shadows
        .map(|corners| record_shadow_maps(cx, scene, (lights, corners)))
        .transpose()?;
    let [points_buffer, info, estimate] = points.bindings(out);
    let bindings = [
        points_buffer,
        info,
        estimate,
        (&lights.buffer).into(),
        maps.as_ref().map_or(Binding::None, Binding::Texture),
    ];
    let shining = f64::from(u8::from(how.law == ReflectionLaw::BlinnPhong));
    let entry = if how.shadows {
        "shadowed"
    } else {
        "unshadowed"
    };
    let context = cx.context().clone();
    let kernel = context.kernel_with(&SHADER, entry, &[("shining", shining)], &bindings)?;
    kernel.record(cx, points.workgroups());
    Ok(())
}
