//! Drawing directions by the brightness of an environment map.

use super::{
    sampling::Cdf,
    spread::{BROAD, Spread, brightness},
};
use glam::{Quat, Vec3};
use interreflect_scene::Environment;
use std::f32::consts::{PI, TAU};

/// Draws directions by the brightness of an environment map.
#[derive(Clone, Debug)]
pub(super) struct EnvironmentTable {
    environment: Environment,
    world_from_image: Quat,
    rows: Cdf,
    columns: Vec<Cdf>,
    /// ∫ brightness dω over the sphere.
    total: f32,
}

impl EnvironmentTable {
    /// `None` if the environment is black, or so even that it need not be drawn.
    pub(super) fn new(environment: &Environment) -> Option<Self> {
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

    /// ∫ brightness dω over the sphere.
    pub(super) fn total(&self) -> f32 {
        self.total
    }

    /// Radiance arriving from a unit direction.
    pub(super) fn radiance(&self, direction: Vec3) -> Vec3 {
        self.environment.radiance(direction)
    }

    /// A unit direction and its density in sr⁻¹. Within a texel, directions are uniform.
    pub(super) fn sample(&self, u: f32, v: f32) -> (Vec3, f32) {
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

    /// Density in sr⁻¹ with which a unit direction is drawn.
    pub(super) fn density(&self, direction: Vec3) -> f32 {
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
        type Integrand = fn(Vec3) -> f32;
        let integrands: [(Integrand, f32); 3] = [
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
