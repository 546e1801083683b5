//! What the camera sees, as a list of points: what is measured is what is shown.

use glam::{DVec3, Vec3};
use interreflect_cpu::direct::captured_radiance;
use interreflect_cpu::scene::{CpuScene, SurfaceHit};
use interreflect_scene::{Camera, Point, PointLayout, Points, Role, SurfaceMaterial};
use rayon::prelude::*;

/// The pixels of an image, row by row, each with what indirect light is estimated for.
pub struct View {
    /// Width and height in pixels.
    pub resolution: [u32; 2],
    /// Points in pixel order; none where the pixel sees no shaded surface.
    points: Vec<Option<Point>>,
    /// Product of the mirrors' reflectances between camera and point.
    pub throughput: Vec<Vec3>,
    /// Radiance at the pixel that needs no estimate: emission, reflected direct light, environment
    /// at infinity.
    pub direct: Vec<Vec3>,
}

/// Mirrors that a pixel's ray is followed through.
const MIRRORS: usize = 8;

impl View {
    /// What `camera` sees. Receivers are shaded if the scene has any, else every surface.
    pub fn new(scene: &CpuScene, camera: &Camera) -> Self {
        let [width, height] = camera.resolution;
        let only_receivers = scene.scene().objects_of(Role::Receiver).next().is_some();
        let pixels: Vec<Pixel> = (0..width as usize * height as usize)
            .into_par_iter()
            .map(|i| {
                let (x, y) = (i as u32 % width, i as u32 / width);
                let direction = camera.ray(x as f32 + 0.5, y as f32 + 0.5);
                Pixel::trace(scene, camera.eye.as_dvec3(), direction, only_receivers)
            })
            .collect();
        Self {
            resolution: camera.resolution,
            points: pixels.iter().map(|p| p.point).collect(),
            throughput: pixels.iter().map(|p| p.throughput).collect(),
            direct: pixels.iter().map(|p| p.direct).collect(),
        }
    }

    /// A view of about `count` shaded points, with the aspect of the camera's image.
    pub fn of_about(scene: &CpuScene, camera: &Camera, count: usize) -> Self {
        let scaled = |width: f64| {
            let [w, h] = camera.resolution.map(f64::from);
            let size = |v: f64| (v.round() as u32).clamp(1, 4096);
            Camera {
                resolution: [size(width), size(width * h / w)],
                ..*camera
            }
        };
        let trial = Self::new(scene, &scaled(96.0));
        let seen = trial.points.iter().flatten().count().max(1);
        Self::new(scene, &scaled(96.0 * (count as f64 / seen as f64).sqrt()))
    }

    /// The points in a layout.
    pub fn points(&self, layout: PointLayout) -> Points {
        Points::new(layout, self.points.iter().copied())
    }

    /// Albedo of the pixel's surface, black where it has none.
    pub fn albedo(&self, pixel: usize) -> Vec3 {
        self.points[pixel].map_or(Vec3::ZERO, |p| p.material.diffuse)
    }

    /// Whether each pixel sees a shaded surface.
    pub fn surfaces(&self) -> Vec<bool> {
        self.points.iter().map(Option::is_some).collect()
    }
}

struct Pixel {
    point: Option<Point>,
    throughput: Vec3,
    direct: Vec3,
}

impl Pixel {
    fn trace(
        scene: &CpuScene,
        mut origin: DVec3,
        mut direction: Vec3,
        only_receivers: bool,
    ) -> Self {
        let mut pixel = Self {
            point: None,
            throughput: Vec3::ONE,
            direct: Vec3::ZERO,
        };
        let geometry = scene.all_objects();
        for _ in 0..=MIRRORS {
            let start = geometry.ray_start();
            let Some(hit) = scene.closest(geometry, origin, direction, start) else {
                let environment = scene.scene().environment.as_ref();
                let radiance = environment.map_or(Vec3::ZERO, |e| e.radiance(direction));
                pixel.direct = pixel.throughput * radiance;
                break;
            };
            if hit.material.mirror {
                pixel.throughput *= hit.material.specular;
                let normal = hit.shading_normal;
                direction -= normal * (2.0 * normal.dot(direction));
                origin = hit.position;
                continue;
            }
            pixel.direct = pixel.throughput * captured_radiance(scene, geometry, &hit);
            if !only_receivers || hit.role == Role::Receiver {
                pixel.point = Some(shaded(&hit, direction));
            }
            break;
        }
        pixel
    }
}

fn shaded(hit: &SurfaceHit, direction: Vec3) -> Point {
    Point {
        position: hit.position.as_vec3(),
        normal: hit.shading_normal,
        view: -direction,
        material: SurfaceMaterial {
            diffuse: hit.material.albedo,
            specular: hit.material.specular,
            shininess: hit.material.shininess,
        },
    }
}
