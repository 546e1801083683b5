//! What the camera sees, as a list of points: what is measured is what is shown.

mod look;
mod pixel;
mod traced;
mod vertices;

use crate::domain::image::HdrImage;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::VisibleTriangles;
use interreflect_scene::{Camera, Estimate, Point, PointLayout, Points};
pub use look::{Look, Mirrors, Shade, ShadedAt};
use pixel::{Pixel, Taps};
use std::f32::consts::FRAC_1_PI;
use traced::{Traced, footprint, traced};
use vertices::Vertices;

/// An image as a list of points: what indirect light is estimated for, and the pixels that show it.
pub struct View {
    /// Width and height in pixels.
    pub resolution: [u32; 2],
    points: Vec<Option<Point>>,
    pixels: Vec<Pixel>,
    /// The surfaces that pixels see, shaded or not.
    seen: Vec<Point>,
    /// What is seen of the points where they are vertices; none where they are the pixels'.
    vertices: Option<SeenVertices>,
}

/// Triangles between points, and what is seen of both.
struct SeenVertices {
    triangles: Vec<[u32; 3]>,
    /// Those that some pixel shows.
    visible: Vec<u32>,
    visible_points: Vec<u32>,
}

/// Width in pixels of the image that finds out how much of it is shaded.
const TRIAL: f64 = 96.0;

/// Most pixels of an image: a few gigabytes while it is traced.
pub const MAX_PIXELS: u64 = 1 << 24;

impl View {
    /// What `camera` sees, made as asked.
    ///
    /// # Errors
    /// [`RunError::Usage`] if the image has more than [`MAX_PIXELS`] pixels.
    pub fn new(scene: &CpuScene, camera: &Camera, look: Look) -> Result<Self, RunError> {
        let [width, height] = camera.resolution;
        match look.at {
            ShadedAt::Pixels => Self::cropped(scene, camera, [0, 0, width, height], look),
            ShadedAt::Vertices => Self::at_vertices(scene, camera, look),
        }
    }

    /// A view of about `count` shaded points: the camera's image cropped to what is shaded.
    ///
    /// # Errors
    /// [`RunError::Usage`] if the camera sees nothing that is shaded, or if the window has more
    /// than [`MAX_PIXELS`] pixels.
    pub fn of_about(
        scene: &CpuScene,
        camera: &Camera,
        (count, shade): (usize, Shade),
    ) -> Result<Self, RunError> {
        let look = Look {
            shade,
            ..Look::default()
        };
        let scaled = |width: f64| {
            let [w, h] = camera.resolution.map(f64::from);
            let size = |v: f64| (v.round() as u32).max(1);
            Camera {
                resolution: [size(width), size(width * h / w)],
                ..*camera
            }
        };
        let trial = Self::new(scene, &scaled(TRIAL), look)?;
        if trial.points.is_empty() {
            return Err(RunError::Usage(format!(
                "{}: the camera sees no surface to shade; move it in the scene file",
                scene.scene().name
            )));
        }
        let factor = (count as f64 / trial.points.len() as f64).sqrt();
        let camera = scaled(TRIAL * factor);
        // A trial pixel on each side: what is shaded may reach a little beyond.
        let [x0, y0, x1, y1] = trial.shaded_window();
        let low = |v: u32| (f64::from(v.saturating_sub(1)) * factor).floor() as u32;
        let high = |v: u32, end: u32| ((f64::from(v + 1) * factor).ceil() as u32).min(end);
        let [width, height] = camera.resolution;
        let (x0, y0) = (low(x0).min(width - 1), low(y0).min(height - 1));
        let window = [
            x0,
            y0,
            high(x1, width).max(x0 + 1),
            high(y1, height).max(y0 + 1),
        ];
        Self::cropped(scene, &camera, window, look)
    }

    /// The window [left, top, right, bottom) of the camera's image, in pixels.
    fn cropped(
        scene: &CpuScene,
        camera: &Camera,
        window: [u32; 4],
        look: Look,
    ) -> Result<Self, RunError> {
        let [x0, y0, x1, y1] = window;
        let (width, height) = (x1 - x0, y1 - y0);
        check_size(width, height)?;
        let traced = traced(scene, camera, window, look);
        let traced_points: Vec<_> = traced.iter().map(|traced| traced.point).collect();
        let (mut points, mut next_seen) = (Vec::new(), 0);
        let pixels = traced.iter().enumerate().map(|(i, traced)| {
            let taps = traced.point.map(|point| {
                points.push(Some(Point {
                    footprint: footprint(&traced_points, width as usize, i),
                    ..point
                }));
                Taps::one(points.len() - 1)
            });
            traced.pixel(taps, &mut next_seen)
        });
        Ok(Self {
            resolution: [width, height],
            pixels: pixels.collect(),
            seen: seen(&traced),
            points,
            vertices: None,
        })
    }

    /// What `camera` sees, shaded at the vertices of all objects that are shaded and interpolated
    /// over their triangles.
    ///
    /// # Errors
    /// As [`View::new`].
    fn at_vertices(scene: &CpuScene, camera: &Camera, look: Look) -> Result<Self, RunError> {
        let [width, height] = camera.resolution;
        check_size(width, height)?;
        let vertices = Vertices::new(scene.scene(), camera.eye, look.shade);
        let traced = traced(scene, camera, [0, 0, width, height], look);
        let (mut visible, mut next_seen) = (Vec::new(), 0);
        let pixels = traced.iter().map(|traced| {
            let hit = traced.hit.filter(|_| traced.point.is_some());
            let taps = hit.map(|hit| {
                let (object, triangle) = scene.all_objects().locate(hit.triangle);
                let triangle = vertices.first_triangle[object] + triangle as u32;
                visible.push(triangle);
                let [v, w] = hit.barycentric;
                Taps {
                    points: vertices.triangles[triangle as usize],
                    weights: [1.0 - v - w, v, w],
                }
            });
            traced.pixel(taps, &mut next_seen)
        });
        let pixels = pixels.collect();
        let seen = seen(&traced);
        visible.sort_unstable();
        visible.dedup();
        Ok(Self {
            resolution: camera.resolution,
            pixels,
            seen,
            vertices: Some(SeenVertices {
                visible_points: vertices.visible_points(scene, camera),
                triangles: vertices.triangles,
                visible,
            }),
            points: vertices.points,
        })
    }

    /// Triangles between the points and what is seen of both, where the points are vertices.
    pub fn visible(&self) -> Option<VisibleTriangles<'_>> {
        let seen = self.vertices.as_ref()?;
        Some(VisibleTriangles {
            triangles: &seen.triangles,
            visible: &seen.visible,
            visible_points: &seen.visible_points,
        })
    }

    /// The smallest window [left, top, right, bottom) around all shaded pixels; the whole image if
    /// there are none.
    fn shaded_window(&self) -> [u32; 4] {
        let [width, height] = self.resolution;
        let shaded = self
            .pixels
            .iter()
            .enumerate()
            .filter(|(_, p)| p.taps.is_some());
        let at = shaded.map(|(i, _)| (i as u32 % width, i as u32 / width));
        at.map(|(x, y)| [x, y, x + 1, y + 1])
            .reduce(|a, b| {
                [
                    a[0].min(b[0]),
                    a[1].min(b[1]),
                    a[2].max(b[2]),
                    a[3].max(b[3]),
                ]
            })
            .unwrap_or([0, 0, width, height])
    }

    /// The points in a layout.
    pub fn points(&self, layout: PointLayout) -> Points {
        Points::new(layout, self.points.iter().copied())
    }

    /// An estimate as an image, through the mirrors in between; black where no surface is shaded.
    pub fn image(&self, estimate: &Estimate) -> HdrImage {
        self.pixels(|pixel| {
            let value = pixel.taps.map_or(Vec3::ZERO, |taps| taps.of(estimate));
            value * pixel.throughput
        })
    }

    /// The surfaces that pixels see, shaded or not, pixel by pixel: what reflects direct light.
    pub fn seen(&self) -> Points {
        Points::new(PointLayout::Material, self.seen.iter().copied().map(Some))
    }

    /// All light that reaches the camera, from estimates of what each point reflects of indirect light and each
    /// of [`Self::seen`] of direct light.
    pub fn lit(&self, reflected: &Estimate, direct: &Estimate) -> HdrImage {
        let mut image = self.image(reflected);
        for (value, pixel) in image.pixels.iter_mut().zip(&self.pixels) {
            let direct = pixel.seen.map_or(Vec3::ZERO, |i| direct.get(i as usize));
            *value += pixel.emitted + pixel.mirrored * direct;
        }
        image
    }

    /// Whether each pixel sees a shaded surface.
    pub fn surfaces(&self) -> Vec<bool> {
        self.pixels.iter().map(|p| p.taps.is_some()).collect()
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

/// The surfaces that are seen, in the order of pixels.
fn seen(traced: &[Traced]) -> Vec<Point> {
    traced.iter().filter_map(|traced| traced.seen).collect()
}

/// What Lambertian points reflect of an irradiance, k_d/π·E in W·m⁻²·sr⁻¹; points have the layout with materials.
pub fn lambertian(points: &Points, irradiance: &Estimate) -> Estimate {
    let mut all = Estimate::new(irradiance.len());
    for (i, point) in points.iter().enumerate() {
        let albedo = point.map_or(Vec3::ZERO, |p| p.material.diffuse);
        all.set(i, irradiance.get(i) * albedo * FRAC_1_PI);
    }
    all
}

fn check_size(width: u32, height: u32) -> Result<(), RunError> {
    match u64::from(width) * u64::from(height) > MAX_PIXELS {
        true => Err(RunError::Usage(format!(
            "an image of {width} × {height} pixels is too large: use {MAX_PIXELS} at most, or \
             fewer points"
        ))),
        false => Ok(()),
    }
}

#[cfg(test)]
mod tests;
