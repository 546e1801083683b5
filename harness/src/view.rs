//! What the camera sees, as a list of points: what is measured is what is shown.

use crate::output::HdrImage;
use glam::{DVec3, Vec3};
use interreflect_cpu::direct::captured_radiance;
use interreflect_cpu::scene::{CpuScene, SurfaceHit};
use interreflect_scene::{Camera, Estimate, Point, PointLayout, Points, Role, SurfaceMaterial};
use rayon::prelude::*;

/// An image as a list of points: what indirect light is estimated for, and the pixels that show it.
pub struct View {
    /// Width and height in pixels.
    pub resolution: [u32; 2],
    points: Vec<Point>,
    pixels: Vec<Pixel>,
}

/// What a pixel shows.
#[derive(Clone, Copy)]
struct Pixel {
    /// The point that it sees, none if it sees no shaded surface.
    point: Option<usize>,
    /// Product of the mirrors' reflectances between camera and point.
    throughput: Vec3,
    /// Radiance that needs no estimate: emission, reflected direct light, environment at infinity.
    direct: Vec3,
}

/// Mirrors that a pixel's ray is followed through.
const MIRRORS: usize = 8;

impl View {
    /// What `camera` sees. Receivers are shaded if the scene has any, else every surface.
    pub fn new(scene: &CpuScene, camera: &Camera) -> Self {
        let [width, height] = camera.resolution;
        let only_receivers = scene.scene().objects_of(Role::Receiver).next().is_some();
        let traced: Vec<Traced> = (0..width as usize * height as usize)
            .into_par_iter()
            .map(|i| {
                let (x, y) = (i as u32 % width, i as u32 / width);
                let direction = camera.ray(x as f32 + 0.5, y as f32 + 0.5);
                Traced::new(scene, camera.eye.as_dvec3(), direction, only_receivers)
            })
            .collect();
        let mut points = Vec::new();
        let pixels = traced.iter().map(|traced| Pixel {
            point: traced.point.map(|point| {
                points.push(point);
                points.len() - 1
            }),
            throughput: traced.throughput,
            direct: traced.direct,
        });
        Self {
            resolution: camera.resolution,
            pixels: pixels.collect(),
            points,
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
        let seen = trial.points.len().max(1);
        Self::new(scene, &scaled(96.0 * (count as f64 / seen as f64).sqrt()))
    }

    /// The points in a layout.
    pub fn points(&self, layout: PointLayout) -> Points {
        Points::new(layout, self.points.iter().copied().map(Some))
    }

    /// An estimate as an image, through the mirrors in between; black where no surface is shaded.
    pub fn image(&self, estimate: &Estimate) -> HdrImage {
        self.pixels(|pixel| {
            let value = pixel.point.map_or(Vec3::ZERO, |point| estimate.get(point));
            value * pixel.throughput
        })
    }

    /// All light that reaches the camera, from an estimate of what each point reflects.
    pub fn lit(&self, reflected: &Estimate) -> HdrImage {
        let mut image = self.image(reflected);
        for (value, pixel) in image.pixels.iter_mut().zip(&self.pixels) {
            *value += pixel.direct;
        }
        image
    }

    /// Whether each pixel sees a shaded surface.
    pub fn surfaces(&self) -> Vec<bool> {
        self.pixels.iter().map(|p| p.point.is_some()).collect()
    }

    fn pixels(&self, value: impl Fn(&Pixel) -> Vec3) -> HdrImage {
        let [width, height] = self.resolution.map(|v| v as usize);
        HdrImage {
            width,
            height,
            pixels: self.pixels.iter().map(value).collect(),
        }
    }
}

/// What the ray through a pixel's centre met.
struct Traced {
    point: Option<Point>,
    throughput: Vec3,
    direct: Vec3,
}

impl Traced {
    fn new(scene: &CpuScene, mut origin: DVec3, mut direction: Vec3, only_receivers: bool) -> Self {
        let mut traced = Self {
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
                traced.direct = traced.throughput * radiance;
                break;
            };
            if hit.material.mirror {
                traced.throughput *= hit.material.specular;
                let normal = hit.shading_normal;
                direction -= normal * (2.0 * normal.dot(direction));
                origin = hit.position;
                continue;
            }
            traced.direct = traced.throughput * captured_radiance(scene, geometry, &hit);
            if !only_receivers || hit.role == Role::Receiver {
                traced.point = Some(shaded(&hit, direction));
            }
            break;
        }
        traced
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
