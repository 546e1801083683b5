//! Cube captures: one ray from the reference point through the centre of each texel.

use crate::{direct, scene::CpuScene};
use glam::{DVec3, Vec3};
use interreflect_scene::{CoarseIrradiance, CubeImage, CubeSpec, conventions};
use rayon::prelude::*;

/// Captures the environment objects around `origin`.
///
/// Receivers are absent: neither seen nor casting shadows. Only the channels of `spec` are
/// computed; without radiance no surface is shaded, without lights no shadow ray is shot, without
/// `bounces` no coarse solution is made; with them it is made by the first capture that asks. The
/// distance is exact to f32 rounding, the normal is the triangle's. Rows run in parallel; the result
/// does not depend on how.
pub fn capture_cube(scene: &CpuScene, origin: Vec3, spec: CubeSpec) -> CubeImage {
    let mut image = CubeImage::new(spec);
    let solution = scene.coarse_for(&spec);
    let rays = Rays {
        scene,
        origin: origin.as_dvec3(),
        coarse: solution.as_ref().map(|s| &s.irradiance),
    };
    let size = spec.size as usize;
    let rows = conventions::CUBE_FACES * size;
    let radiance = rows_of(&mut image.radiance, size, rows);
    let distance = rows_of(&mut image.distance, size, rows);
    let normal = rows_of(&mut image.normal, size, rows);
    radiance
        .into_par_iter()
        .zip(distance)
        .zip(normal)
        .enumerate()
        .for_each(|(row, ((radiance, distance), normal))| {
            let mut texels = Row {
                radiance,
                distance,
                normal,
            };
            for column in 0..size {
                texels.capture(&rays, column, texel_direction(spec.size, row, column));
            }
        });
    image
}

/// Where rays start, and what the surfaces that they meet reflect.
struct Rays<'a> {
    scene: &'a CpuScene,
    origin: DVec3,
    coarse: Option<&'a CoarseIrradiance>,
}

/// One row of each channel; `None` where the channel is not asked for.
struct Row<'a> {
    radiance: Option<&'a mut [Vec3]>,
    distance: Option<&'a mut [f32]>,
    normal: Option<&'a mut [Vec3]>,
}

impl Row<'_> {
    fn capture(&mut self, rays: &Rays<'_>, column: usize, direction: DVec3) {
        let &Rays { scene, origin, .. } = rays;
        let objects = scene.environment_objects();
        let hit = objects.bvh().closest(origin, direction, 0.0, f64::INFINITY);
        if let (Some(distance), Some(hit)) = (&mut self.distance, &hit) {
            distance[column] = hit.distance as f32;
        }
        if self.radiance.is_none() && self.normal.is_none() {
            return;
        }
        let surface = hit.map(|hit| scene.surface(objects, origin, direction, hit));
        if let (Some(normal), Some(surface)) = (&mut self.normal, &surface) {
            normal[column] = surface.geometric_normal;
        }
        if let Some(radiance) = &mut self.radiance {
            radiance[column] = match (&surface, &scene.scene().environment) {
                (Some(surface), _) => {
                    direct::captured_radiance(scene, objects, surface, rays.coarse)
                }
                (None, Some(environment)) => environment.radiance(direction.as_vec3()),
                (None, None) => Vec3::ZERO,
            };
        }
    }
}

/// The rows of a plane, or as many times nothing if the plane is empty.
fn rows_of<T>(plane: &mut [T], size: usize, rows: usize) -> Vec<Option<&mut [T]>> {
    if plane.is_empty() {
        return (0..rows).map(|_| None).collect();
    }
    plane.chunks_mut(size).map(Some).collect()
}

/// Unit direction of the texel in a column of a row, rows counted over all faces.
fn texel_direction(size: u32, row: usize, column: usize) -> DVec3 {
    let (face, row) = (row / size as usize, row % size as usize);
    let s = conventions::texel_centre(size, column as u32);
    let t = conventions::texel_centre(size, row as u32);
    conventions::cube_vector(face, s, t).normalize()
}
