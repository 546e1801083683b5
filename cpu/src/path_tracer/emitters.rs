//! Sampling what emits: triangles by area times radiance, and the environment map.
//!
//! Sources that fill much of the view are found well enough by directions drawn from the lobe;
//! drawing them as sources too would only add noise. They are left out of the tables, and have
//! density 0 there.

use super::sampling::{Cdf, triangle};
use crate::scene::geometric_normal;
use glam::{DVec3, Quat, Vec3};
use interreflect_scene::{Environment, Scene};
use std::f32::consts::{PI, TAU};

/// Sources whose light comes from more than this part of all surfaces, or of the sphere, are not
/// drawn.
const BROAD: f64 = 0.3;

/// Everything in a scene that can be drawn as a source of light, but for its delta lights.
#[derive(Clone, Debug, Default)]
pub(crate) struct Emitters {
    triangles: Vec<Emitter>,
    environment: Option<EnvironmentTable>,
    /// Over the triangles, then the environment; `None` if nothing emits.
    choice: Option<Cdf>,
    /// Sum of area × brightness, the environment's share included.
    total: f32,
}

#[derive(Clone, Copy, Debug)]
struct Emitter {
    corners: [Vec3; 3],
    normal: Vec3,
    radiance: Vec3,
}

/// A direction in which a source was drawn, with what arrives if nothing is between.
pub(super) struct Source {
    /// Unit, in f64: a shadow ray that grazes the source has to end before it.
    pub(super) direction: DVec3,
    /// Metres; +∞ for the environment.
    pub(super) distance: f64,
    pub(super) radiance: Vec3,
    /// Density in sr⁻¹.
    pub(super) density: f32,
}

/// What sources are weighted by.
fn brightness(radiance: Vec3) -> f32 {
    radiance.element_sum()
}

impl Emitters {
    /// Collects the emitting triangles of a soup, and the scene's environment.
    pub(crate) fn new(scene: &Scene, soup: &[[Vec3; 3]], emission: impl Fn(u32) -> Vec3) -> Self {
        let (mut weights, mut triangles) = (Vec::new(), Vec::new());
        let mut spread = Spread::default();
        for (index, &corners) in soup.iter().enumerate() {
            let radiance = emission(index as u32);
            let [a, b, c] = corners.map(Vec3::as_dvec3);
            let area = 0.5 * (b - a).cross(c - a).length();
            spread.add(area, brightness(radiance));
            if brightness(radiance) > 0.0 && area > 0.0 {
                weights.push(area * f64::from(brightness(radiance)));
                let normal = geometric_normal(corners);
                triangles.push(Emitter {
                    corners,
                    normal,
                    radiance,
                });
            }
        }
        if spread.part() > BROAD {
            weights.clear();
            triangles.clear();
        }
        let environment = scene.environment.as_ref().and_then(EnvironmentTable::new);
        if let Some(table) = &environment {
            // The environment shines through a disc as wide as the scene: π r² ∫ L dω against π A L.
            weights.push(f64::from(table.total) * squared_radius(soup));
        }
        let (choice, total) = Cdf::new(weights.into_iter()).unzip();
        Self {
            triangles,
            environment,
            choice,
            total: total.unwrap_or(0.0) as f32,
        }
    }

    /// Draws a source as seen from `x`; `None` if nothing emits or the source faces away.
    pub(super) fn sample(&self, x: DVec3, [choice, u, v, _]: [f32; 4]) -> Option<Source> {
        let (index, _) = self.choice.as_ref()?.sample(choice);
        let Some(emitter) = self.triangles.get(index) else {
            let table = self.environment.as_ref()?;
            let (direction, density) = table.sample(u, v);
            return Some(Source {
                direction: direction.as_dvec3(),
                distance: f64::INFINITY,
                radiance: table.environment.radiance(direction),
                density: density * self.probability(index),
            });
        };
        let at: DVec3 = emitter
            .corners
            .iter()
            .zip(triangle(u, v))
            .map(|(corner, weight)| corner.as_dvec3() * f64::from(weight))
            .sum();
        let distance = (at - x).length();
        let direction = (at - x) / distance;
        let cos_source = -emitter.normal.dot(direction.as_vec3());
        (cos_source > 0.0 && distance > 0.0).then(|| Source {
            direction,
            distance,
            radiance: emitter.radiance,
            density: self.density_of_surface(emitter.radiance, distance, cos_source),
        })
    }

    /// Density in sr⁻¹ with which [`Emitters::sample`] draws a direction to a surface point that
    /// emits `radiance`: brightness/total per area, times d²/cos θ.
    pub(super) fn density_of_surface(&self, radiance: Vec3, distance: f64, cos_source: f32) -> f32 {
        if self.total <= 0.0 || cos_source <= 0.0 {
            return 0.0;
        }
        let per_area = brightness(radiance) / self.total;
        per_area * (distance * distance / f64::from(cos_source)) as f32
    }

    /// Density in sr⁻¹ with which [`Emitters::sample`] draws a direction to the environment.
    pub(super) fn density_of_environment(&self, direction: Vec3) -> f32 {
        match &self.environment {
            Some(table) => table.density(direction) * self.probability(self.triangles.len()),
            None => 0.0,
        }
    }

    fn probability(&self, index: usize) -> f32 {
        self.choice.as_ref().map_or(0.0, |c| c.probability(index))
    }
}

/// Over how large a part of its domain a brightness is spread: (∫ b)² / (∫ b² · ∫ 1), 1 if it is
/// constant, the covered part if it is constant there and 0 elsewhere.
#[derive(Default)]
struct Spread {
    measure: f64,
    first: f64,
    second: f64,
}

impl Spread {
    fn add(&mut self, measure: f64, brightness: f32) {
        let b = f64::from(brightness);
        self.measure += measure;
        self.first += measure * b;
        self.second += measure * b * b;
    }

    fn part(&self) -> f64 {
        let whole = self.second * self.measure;
        if whole > 0.0 {
            self.first * self.first / whole
        } else {
            0.0
        }
    }
}

/// Squared radius of the sphere around a soup's bounding box; 1 without triangles.
fn squared_radius(soup: &[[Vec3; 3]]) -> f64 {
    let mut corners = soup.iter().flatten().copied();
    let Some(first) = corners.next() else {
        return 1.0;
    };
    let (low, high) = corners.fold((first, first), |(l, h), c| (l.min(c), h.max(c)));
    0.25 * (high - low).as_dvec3().length_squared()
}

/// Draws directions by the brightness of an environment map.
#[derive(Clone, Debug)]
struct EnvironmentTable {
    environment: Environment,
    world_from_image: Quat,
    rows: Cdf,
    columns: Vec<Cdf>,
    /// ∫ brightness dω.
    total: f32,
}

impl EnvironmentTable {
    /// `None` if the environment is black, or so even that it need not be drawn.
    fn new(environment: &Environment) -> Option<Self> {
        let image = &environment.image;
        let (width, height) = (image.width as i64, image.height as i64);
        // Bilinear filtering spreads a texel over its neighbours, so the density does as well.
        let blurred = |column: i64, row: i64| -> f64 {
            let mut sum = 0.0;
            for r in row - 1..=row + 1 {
                for c in column - 1..=column + 1 {
                    let r = r.clamp(0, height - 1);
                    let at = (r * width + c.rem_euclid(width)) as usize;
                    sum += f64::from(brightness(image.texels[at])).max(0.0);
                }
            }
            sum / 9.0
        };
        let mut spread = Spread::default();
        let mut columns = Vec::new();
        let mut row_weights = Vec::new();
        for row in 0..height {
            let table = Cdf::new((0..width).map(|column| blurred(column, row)));
            let (cdf, sum) = table.unwrap_or_default();
            columns.push(cdf);
            let solid_angle = f64::from(texel_solid_angle(image.width, image.height, row));
            row_weights.push(sum * solid_angle);
            (0..width).for_each(|column| spread.add(solid_angle, blurred(column, row) as f32));
        }
        let (rows, total) = Cdf::new(row_weights.into_iter())?;
        (spread.part() <= BROAD && environment.scale > 0.0).then(|| Self {
            world_from_image: Quat::from_rotation_y(environment.rotate_deg.to_radians()),
            environment: environment.clone(),
            rows,
            columns,
            total: total as f32 * environment.scale,
        })
    }

    /// A unit direction and its density in sr⁻¹. Within a texel, directions are uniform.
    fn sample(&self, u: f32, v: f32) -> (Vec3, f32) {
        let image = &self.environment.image;
        let (row, down) = self.rows.sample(u);
        let (column, across) = self.columns[row].sample(v);
        let cos_edge = |r: usize| (r as f32 * PI / image.height as f32).cos();
        let cos_theta = cos_edge(row) + (cos_edge(row + 1) - cos_edge(row)) * down;
        let sin_theta = (1.0 - cos_theta * cos_theta).max(0.0).sqrt();
        let phi = (column as f32 + across) * TAU / image.width as f32;
        let in_image = Vec3::new(sin_theta * phi.sin(), cos_theta, -sin_theta * phi.cos());
        (
            self.world_from_image * in_image,
            self.texel_density(column, row),
        )
    }

    fn density(&self, direction: Vec3) -> f32 {
        let image = &self.environment.image;
        let in_image = self.world_from_image.inverse() * direction;
        let (u, v) = image.coordinates(in_image);
        let column = (u as usize).min(image.width as usize - 1);
        self.texel_density(column, (v as usize).min(image.height as usize - 1))
    }

    fn texel_density(&self, column: usize, row: usize) -> f32 {
        let image = &self.environment.image;
        let in_row = self.rows.probability(row);
        if in_row == 0.0 {
            return 0.0; // a black row has no table
        }
        in_row * self.columns[row].probability(column)
            / texel_solid_angle(image.width, image.height, row as i64)
    }
}

/// Solid angle in sr of a latitude–longitude texel in a row.
fn texel_solid_angle(width: u32, height: u32, row: i64) -> f32 {
    let cos_edge = |r: i64| (r as f64 * std::f64::consts::PI / f64::from(height)).cos();
    ((cos_edge(row) - cos_edge(row + 1)) * std::f64::consts::TAU / f64::from(width)) as f32
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used, reason = "tests")]
    use super::*;
    use crate::path_tracer::sampling::Sample;
    use interreflect_scene::LatLongImage;

    #[test]
    fn directions_are_drawn_with_the_density_that_is_stated() {
        let (width, height) = (16, 8);
        let texels = (0..128)
            .map(|i| Vec3::splat(if i == 11 { 60.0 } else { 0.1 }))
            .collect();
        let environment = Environment {
            image: LatLongImage {
                width,
                height,
                texels,
            },
            scale: 2.0,
            rotate_deg: 30.0,
        };
        let table = EnvironmentTable::new(&environment).expect("neither black nor even");
        let integrands: [(fn(Vec3) -> f32, f32); 3] = [
            (|_| 1.0, 4.0 * PI),
            (|d| d.x * d.x, 4.0 * PI / 3.0),
            (|d| d.y.max(0.0), PI),
        ];
        for (f, exact) in integrands {
            let (mut sum, mut differing) = (0.0, 0);
            for i in 0..1 << 16 {
                let [u, v, ..] = Sample::new(i, 3).set(0);
                let (direction, density) = table.sample(u, v);
                differing += u32::from((table.density(direction) / density - 1.0).abs() > 1e-4);
                sum += f64::from(f(direction) / density);
            }
            // ∫ f dω = E[f/density]; 65 536 Sobol samples are good to better than 1e-3 here.
            let estimate = sum / 65536.0;
            assert!(
                (estimate / f64::from(exact) - 1.0).abs() < 1e-3,
                "{estimate}, {exact}"
            );
            // Rounding may move directions at the border of a texel into the next one.
            assert!(differing < 10, "{differing} densities differ");
        }
    }
}
