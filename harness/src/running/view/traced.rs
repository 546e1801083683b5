//! What the rays through pixels meet.

use super::{Look, Mirrors, Pixel, Taps};
use glam::{DVec3, Vec3};
use interreflect_cpu::scene::{CpuScene, SurfaceHit};
use interreflect_scene::{Camera, Point, Role};
use rayon::prelude::*;

/// Mirrors that a pixel's ray is followed through.
const MIRRORS: usize = 8;

/// What the rays through the pixels of a window meet, row by row.
pub(super) fn traced(
    scene: &CpuScene,
    camera: &Camera,
    [x0, y0, x1, y1]: [u32; 4],
    look: Look,
) -> Vec<Traced> {
    let only_receivers = !look.shade.shows(scene.scene(), Role::Environment);
    let (width, height) = (x1 - x0, y1 - y0);
    (0..width as usize * height as usize)
        .into_par_iter()
        .map(|i| {
            let (x, y) = (x0 + i as u32 % width, y0 + i as u32 / width);
            let direction = camera.ray(x as f32 + 0.5, y as f32 + 0.5);
            let origin = camera.eye.as_dvec3();
            Traced::new(scene, origin, direction, (only_receivers, look.mirrors))
        })
        .collect()
}

/// What the ray through a pixel's centre met.
pub(super) struct Traced {
    /// The surface to shade, if there is one.
    pub(super) point: Option<Point>,
    /// What the ray met there.
    pub(super) hit: Option<SurfaceHit>,
    /// The surface that is seen, if it is no mirror.
    pub(super) seen: Option<Point>,
    throughput: Vec3,
    mirrored: Vec3,
    emitted: Vec3,
}

impl Traced {
    fn new(
        scene: &CpuScene,
        mut origin: DVec3,
        mut direction: Vec3,
        (only_receivers, mirrors): (bool, Mirrors),
    ) -> Self {
        let mut traced = Self {
            point: None,
            hit: None,
            seen: None,
            throughput: Vec3::ONE,
            mirrored: Vec3::ONE,
            emitted: Vec3::ZERO,
        };
        let geometry = scene.all_objects();
        let mut seen_in_mirror = false;
        for _ in 0..=MIRRORS {
            let start = geometry.ray_start();
            let Some(hit) = scene.closest(geometry, origin, direction, start) else {
                let environment = scene.scene().environment.as_ref();
                let radiance = environment.map_or(Vec3::ZERO, |e| e.radiance(direction));
                traced.emitted = traced.mirrored * radiance;
                break;
            };
            if hit.material.mirror {
                traced.mirrored *= hit.material.specular;
                let shown = !only_receivers || hit.role == Role::Receiver;
                if mirrors == Mirrors::Diffuse && shown && traced.point.is_none() {
                    traced.point = Some(as_diffuse(&hit, direction));
                    traced.hit = Some(hit);
                }
                seen_in_mirror = true;
                let normal = hit.shading_normal;
                direction -= normal * (2.0 * normal.dot(direction));
                origin = hit.position;
                continue;
            }
            if hit.front {
                traced.emitted = traced.mirrored * hit.material.emission;
            }
            let here = hit.point(direction);
            traced.seen = Some(here);
            let counts = mirrors == Mirrors::Included || !seen_in_mirror;
            if counts && (!only_receivers || hit.role == Role::Receiver) {
                traced.throughput = traced.mirrored;
                traced.point = Some(here);
                traced.hit = Some(hit);
            }
            break;
        }
        traced
    }

    /// The pixel that shows this; `next_seen` counts the surfaces that are seen.
    pub(super) fn pixel(&self, taps: Option<Taps>, next_seen: &mut u32) -> Pixel {
        let seen = self.seen.map(|_| *next_seen);
        *next_seen += u32::from(seen.is_some());
        Pixel {
            seen,
            taps,
            throughput: self.throughput,
            mirrored: self.mirrored,
            emitted: self.emitted,
        }
    }
}

/// Angle in radians between the mirrored directions of pixel `i` and of its neighbours: the pixels
/// right and below, or where these show no shaded surface left and above; the larger of the two,
/// 0 without a neighbour.
pub(super) fn footprint(points: &[Option<Point>], width: usize, i: usize) -> f32 {
    let mirrored = |point: Point| point.normal * (2.0 * point.normal.dot(point.view)) - point.view;
    let direction = |i: Option<usize>| i.and_then(|i| points.get(i).copied()?).map(mirrored);
    let Some(here) = direction(Some(i)) else {
        return 0.0;
    };
    let column = i % width;
    let right = (column + 1 < width).then_some(i + 1);
    let left = (column > 0).then(|| i - 1);
    let (below, above) = (Some(i + width), i.checked_sub(width));
    [[right, left], [below, above]]
        .into_iter()
        .filter_map(|[next, previous]| direction(next).or_else(|| direction(previous)))
        // The chord's length keeps small angles, which the cosine loses.
        .map(|there| 2.0 * (0.5 * here.distance(there)).min(1.0).asin())
        .fold(0.0, f32::max)
}

/// A mirror's surface as if it were diffuse.
fn as_diffuse(hit: &SurfaceHit, direction: Vec3) -> Point {
    let mut point = hit.point(direction);
    point.material.diffuse = hit.material.specular;
    point.material.specular = Vec3::ZERO;
    point
}
