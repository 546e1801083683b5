//! Light that reaches a surface straight from the scene's lights.

use crate::scene::{CpuScene, Geometry, SurfaceHit};
use glam::Vec3;
use interreflect_scene::{CoarseIrradiance, Incident};
use std::f32::consts::FRAC_1_PI;

/// Light arriving unoccluded at a surface from each of the scene's lights, on the side that the
/// ray came from; `occluders` cast hard shadows.
pub fn arriving<'a>(
    scene: &'a CpuScene,
    occluders: &'a Geometry,
    at: &'a SurfaceHit,
) -> impl Iterator<Item = Incident> + 'a {
    let lights = scene.scene().lights.iter();
    lights
        .filter_map(|light| light.incident(at.position.as_vec3()))
        .filter(|light| at.geometric_normal.dot(light.to_light) > 0.0)
        .filter(|light| {
            let to_light = light.to_light.as_dvec3();
            !occluders.occluded(at.position, to_light, f64::from(light.distance))
        })
}

/// Radiance that leaves a surface towards where the ray came from, as captures see it: emission of
/// the front side and what [`reflected`] says.
pub fn captured_radiance(
    scene: &CpuScene,
    occluders: &Geometry,
    at: &SurfaceHit,
    coarse: Option<&CoarseIrradiance>,
) -> Vec3 {
    let emitted = if at.front {
        at.material.emission
    } else {
        Vec3::ZERO
    };
    emitted + reflected(scene, occluders, at, coarse)
}

/// Radiance that a surface reflects, as captures see it: ρ/π times the irradiance from the scene's
/// lights and, if there is one, from a coarse solution; the surface is then one of the environment
/// objects'.
///
/// Lambertian reflection is two-sided and follows the triangles' own normals. Mirrors do not
/// scatter light: they reflect nothing here; specular lobes are left out.
pub fn reflected(
    scene: &CpuScene,
    occluders: &Geometry,
    at: &SurfaceHit,
    coarse: Option<&CoarseIrradiance>,
) -> Vec3 {
    if at.material.mirror || at.material.albedo == Vec3::ZERO {
        return Vec3::ZERO;
    }
    let mut irradiance: Vec3 = arriving(scene, occluders, at)
        .map(|light| light.irradiance * at.geometric_normal.dot(light.to_light))
        .sum();
    if let Some(coarse) = coarse {
        irradiance += coarse.at(at.triangle, at.barycentric, at.front);
    }
    at.material.albedo * FRAC_1_PI * irradiance
}
