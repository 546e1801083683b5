//! Views from the lights: one ray from the light through the centre of each texel.

use crate::scene::{CpuScene, SurfaceHit};
use glam::{DVec3, Vec3};
use interreflect_scene::rsm::MAX_MIRRORS;
use interreflect_scene::{LightFrame, RsmImage, RsmSpec, TrueColors, conventions};
use rayon::prelude::*;
use std::f32::consts::FRAC_1_PI;

/// Captures all objects, receivers too, from every light of the scene.
///
/// What the first ray meets is lit, so there is
/// no shadow ray; at a mirror the ray is followed through at most [`MAX_MIRRORS`] of them, by their
/// interpolated normals, and what it then meets gets the irradiance I·cos α/b², b the length of the
/// whole way, times the mirrors' reflectances: exact for plane mirrors. A curved one widens or
/// narrows the bundle of rays: the flux of its texel, radiance times area, is still right, the area
/// alone approximate. Rows run in parallel; the result does not depend on how.
pub fn capture_rsms(scene: &CpuScene, spec: RsmSpec) -> RsmImage {
    let mut image = RsmImage::new(scene.scene(), spec);
    let size = spec.size as usize;
    let texels: Vec<Option<LitPlace>> = (0..image.texels())
        .into_par_iter()
        .with_min_len(size)
        .map(|index| {
            let frame = &image.frames[index / (size * size)];
            let [column, row] = [index % size, index / size % size]
                .map(|i| conventions::texel_centre(spec.size, i as u32));
            LitPlace::along(scene, frame, column, row)
        })
        .collect();
    for (index, place) in texels.iter().enumerate() {
        if let Some(place) = place {
            place.write(&mut image, index);
        }
    }
    image
}

/// A lit place on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitPlace {
    /// Position in metres.
    pub position: DVec3,
    /// Length b of the light's way in metres, over all mirrors.
    pub path_m: f64,
    /// Unit normal on the side of the arriving light.
    pub normal: Vec3,
    /// Cosine cos α between the normal and the arriving light, > 0.
    pub cos_light: f32,
    /// What the surface is made of, with the light that arrives.
    pub colors: TrueColors,
}

impl LitPlace {
    /// What the ray through (s, t) ∈ [−1, 1]² of a view lights; `None` if it meets nothing, or
    /// carries no light.
    pub fn along(scene: &CpuScene, frame: &LightFrame, s: f64, t: f64) -> Option<Self> {
        let objects = scene.all_objects();
        let (start, leaving) = frame.ray(s, t);
        let (mut origin, mut direction) = (start, leaving);
        let (mut path_m, mut throughput) = (0.0, Vec3::ONE);
        for mirrors in 0..=MAX_MIRRORS {
            let nearest = match mirrors {
                0 => 0.0,
                _ => objects.ray_start(),
            };
            let hit = objects
                .bvh()
                .closest(origin, direction, nearest, f64::INFINITY)?;
            let surface = scene.surface(objects, origin, direction, hit);
            path_m += surface.distance;
            if !surface.material.mirror {
                let unfolded = (start + leaving * path_m).as_vec3();
                let arriving = scene.scene().lights[frame.light as usize].incident(unfolded)?;
                return Self::lit(
                    &surface,
                    path_m,
                    direction,
                    arriving.irradiance * throughput,
                );
            }
            throughput *= surface.material.specular;
            origin = surface.position;
            direction = reflected(direction, surface.shading_normal.as_dvec3());
        }
        None
    }

    /// A surface that light reaches along `direction`; `irradiance` is that across the light's way.
    fn lit(at: &SurfaceHit, path_m: f64, direction: DVec3, irradiance: Vec3) -> Option<Self> {
        let cos_light = -at.geometric_normal.dot(direction.as_vec3());
        (cos_light > 0.0 && irradiance != Vec3::ZERO).then(|| Self {
            position: at.position,
            path_m,
            normal: at.geometric_normal,
            cos_light,
            colors: TrueColors {
                diffuse: at.material.albedo,
                specular: at.material.specular,
                shininess: at.material.shininess,
                irradiance: irradiance * cos_light,
                to_light: -direction.as_vec3(),
            },
        })
    }

    fn write(&self, image: &mut RsmImage, index: usize) {
        image.position[index] = self.position.as_vec3();
        image.path_m[index] = self.path_m as f32;
        if let Some(radiance) = image.radiance.get_mut(index) {
            *radiance = self.radiance();
        }
        if let Some(normal) = image.normal.get_mut(index) {
            *normal = self.normal;
            image.cos_light[index] = self.cos_light;
        }
        if let Some(colors) = image.true_colors.get_mut(index) {
            *colors = self.colors;
        }
    }

    /// Radiance ρ/π·E·cos α that is reflected by Lambert's law, W·m⁻²·sr⁻¹.
    pub fn radiance(&self) -> Vec3 {
        self.colors.diffuse * FRAC_1_PI * self.colors.irradiance
    }
}

/// The direction in which a mirror sends a ray on.
fn reflected(direction: DVec3, normal: DVec3) -> DVec3 {
    (direction - normal * (2.0 * normal.dot(direction))).normalize()
}
