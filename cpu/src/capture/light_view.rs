//! Views from the lights: one ray from the light through the centre of each texel.

use crate::scene::{CpuScene, SurfaceHit};
use glam::{DVec3, Vec3};
use interreflect_scene::light_view::MAX_MIRRORS;
use interreflect_scene::{LightFrame, LightViewImage, LightViewSpec, TrueColors, conventions};
use rayon::prelude::*;
use std::f32::consts::FRAC_1_PI;

/// Captures the environment objects from every light of the scene.
///
/// Receivers are absent: neither seen nor in the way. What the first ray meets is lit, so there is
/// no shadow ray; at a mirror the ray is followed through at most [`MAX_MIRRORS`] of them, by their
/// interpolated normals, and what it then meets gets the irradiance I·cos α/b², b the length of the
/// whole way, times the mirrors' reflectances: exact for plane mirrors. A curved one widens or
/// narrows the bundle of rays: the flux of its texel, radiance times area, is still right, the area
/// alone approximate. Rows run in parallel; the result does not depend on how.
pub fn capture_light_views(scene: &CpuScene, spec: LightViewSpec) -> LightViewImage {
    let mut image = LightViewImage::new(scene.scene(), spec);
    let size = spec.size as usize;
    let texels: Vec<Option<Photon>> = (0..image.texels())
        .into_par_iter()
        .with_min_len(size)
        .map(|index| {
            let frame = &image.frames[index / (size * size)];
            let [column, row] = [index % size, index / size % size]
                .map(|i| conventions::texel_centre(spec.size, i as u32));
            Photon::along(scene, frame, column, row)
        })
        .collect();
    for (index, photon) in texels.into_iter().enumerate() {
        if let Some(photon) = photon {
            photon.write(&mut image, index);
        }
    }
    image
}

/// A lit place on a surface.
struct Photon {
    surface: SurfaceHit,
    path_m: f64,
    cos_light: f32,
    irradiance: Vec3,
    to_light: Vec3,
}

impl Photon {
    /// What the ray through (s, t) of a view lights.
    fn along(scene: &CpuScene, frame: &LightFrame, s: f64, t: f64) -> Option<Self> {
        let objects = scene.environment_objects();
        let (start, leaving) = frame.ray(s, t);
        let (mut origin, mut direction) = (start, leaving);
        let (mut path_m, mut throughput) = (0.0, Vec3::ONE);
        for mirrors in 0..=MAX_MIRRORS {
            let nearest = if mirrors == 0 {
                0.0
            } else {
                objects.ray_start()
            };
            let hit = objects
                .bvh()
                .closest(origin, direction, nearest, f64::INFINITY)?;
            let surface = scene.surface(objects, origin, direction, hit);
            path_m += surface.distance;
            if !surface.material.mirror {
                let unfolded = (start + leaving * path_m).as_vec3();
                let arriving = scene.scene().lights[frame.light as usize].incident(unfolded)?;
                let cos_light = -surface.geometric_normal.dot(direction.as_vec3());
                return (cos_light > 0.0 && arriving.irradiance != Vec3::ZERO).then(|| Self {
                    surface,
                    path_m,
                    cos_light,
                    irradiance: arriving.irradiance * throughput * cos_light,
                    to_light: -direction.as_vec3(),
                });
            }
            throughput *= surface.material.specular;
            origin = surface.position;
            direction = reflected(direction, surface.shading_normal.as_dvec3());
        }
        None
    }

    fn write(self, image: &mut LightViewImage, index: usize) {
        let material = &self.surface.material;
        image.position[index] = self.surface.position.as_vec3();
        image.path_m[index] = self.path_m as f32;
        if let Some(radiance) = image.radiance.get_mut(index) {
            *radiance = material.albedo * FRAC_1_PI * self.irradiance;
        }
        if let Some(normal) = image.normal.get_mut(index) {
            *normal = self.surface.geometric_normal;
            image.cos_light[index] = self.cos_light;
        }
        if let Some(colors) = image.true_colors.get_mut(index) {
            *colors = TrueColors {
                diffuse: material.albedo,
                specular: material.specular,
                shininess: material.shininess,
                irradiance: self.irradiance,
                to_light: self.to_light,
            };
        }
    }
}

/// The direction in which a mirror sends a ray on.
fn reflected(direction: DVec3, normal: DVec3) -> DVec3 {
    (direction - normal * (2.0 * normal.dot(direction))).normalize()
}
