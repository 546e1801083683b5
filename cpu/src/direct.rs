//! Light that reaches a surface straight from the scene's lights.

use crate::scene::{CpuScene, Geometry, SurfaceHit};
use glam::Vec3;
use interreflect_scene::material::blinn_phong_normalisation;
use interreflect_scene::{
    CoarseIrradiance, DirectLight, Estimate, Incident, Point, Points, ReflectionLaw,
    SurfaceMaterial,
};
use rayon::prelude::*;
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

/// Radiance that points reflect towards their viewers of the light that comes straight from the scene's lights;
/// where there are shadows, all objects cast hard ones.
///
/// Points have the layout with materials, and are lit on the side of their normal. Shadows are those of rays
/// from the point: exact on flat surfaces, and on a curved mesh those of its triangles.
pub fn direct_light(scene: &CpuScene, points: &Points, light: DirectLight) -> Estimate {
    let radiances: Vec<Vec3> = (0..points.len())
        .into_par_iter()
        .map(|i| {
            let point = points.get(i);
            point.map_or(Vec3::ZERO, |point| at_point(scene, &point, light))
        })
        .collect();
    let mut all = Estimate::new(points.len());
    for (i, radiance) in radiances.into_iter().enumerate() {
        all.set(i, radiance);
    }
    all
}

fn at_point(scene: &CpuScene, point: &Point, how: DirectLight) -> Vec3 {
    let occluders = scene.all_objects();
    let origin = occluders.above(point.position, point.normal);
    let lights = scene.scene().lights.iter();
    lights
        .filter_map(|light| light.incident(point.position))
        .map(|light| {
            let cos_theta = point.normal.dot(light.to_light);
            let reach = f64::from(light.distance);
            let to_light = light.to_light.as_dvec3();
            let hidden = || how.shadows && occluders.occluded(origin, to_light, reach);
            match cos_theta > 0.0 && !hidden() {
                true => light.irradiance * cos_theta * reflectance(point, light.to_light, how.law),
                false => Vec3::ZERO,
            }
        })
        .sum()
}

/// f_r in sr⁻¹ of a point's material, for light from a direction.
fn reflectance(point: &Point, to_light: Vec3, law: ReflectionLaw) -> Vec3 {
    let SurfaceMaterial {
        diffuse,
        specular,
        shininess,
    } = point.material;
    let lambert = diffuse * FRAC_1_PI;
    match law {
        ReflectionLaw::Lambert => lambert,
        ReflectionLaw::BlinnPhong => {
            let half = (to_light + point.view).normalize_or_zero();
            let lobe = point.normal.dot(half).max(0.0).powf(shininess);
            lambert + specular * (lobe * blinn_phong_normalisation(f64::from(shininess)) as f32)
        }
    }
}
