//! Tables of the average reflectivity over angle and solid angle (P1 §3).
//!
//! The paper leaves open what a texel's solid angle means to a lobe about the half vector. Here a
//! texel is a cap of directions: the cosine is averaged over that cap, and the lobe over the half
//! vectors that it makes with the view direction, a cap of half the radius.

use super::math::{cap_mean, table_place};
use interreflect_cpu::lane::{WIDTH, Wide};
use std::f64::consts::PI;

/// Nodes along the axis of the angle.
pub(super) const ANGLES: usize = 128;

/// Nodes along the axis of the solid angle.
pub(super) const SOLID_ANGLES: usize = 16;

/// The table of the cosine, then one for each lobe.
#[derive(Clone, Debug, Default)]
pub(super) struct Tables {
    /// Exponents of the lobes, ascending.
    pub(super) lobes: Vec<f32>,
    /// Tables one after the other: rows of equal solid angle.
    pub(super) values: Vec<f32>,
}

impl Tables {
    pub(super) fn new(lobes: Vec<f32>) -> Self {
        let mut values = table(1.0, 1.0);
        for exponent in &lobes {
            values.extend(table(f64::from(*exponent), 0.5));
        }
        Self { lobes, values }
    }

    /// Which table belongs to a lobe of this exponent.
    #[inline(always)]
    pub(super) fn of_lobe(&self, shininess: f32) -> usize {
        // Without lobes nothing shines, and any table will do.
        let later = self.lobes.iter().position(|e| *e >= shininess);
        later.map_or(self.lobes.len(), |place| 1 + place)
    }

    /// Bilinear values of a table for each lane.
    #[inline(always)]
    pub(super) fn averaged_over(
        &self,
        table: [usize; WIDTH],
        cos_theta: Wide,
        omega: Wide,
    ) -> Wide {
        let (first, second) = table_place(cos_theta, omega);
        let mut result = [0.0; WIDTH];
        for lane in 0..WIDTH {
            let x = first.0[lane] * (ANGLES - 1) as f32;
            let y = second.0[lane] * (SOLID_ANGLES - 1) as f32;
            let (column, row) = (
                (x as usize).min(ANGLES - 2),
                (y as usize).min(SOLID_ANGLES - 2),
            );
            let (u, v) = (x - column as f32, y - row as f32);
            let at = (table[lane] * SOLID_ANGLES + row) * ANGLES + column;
            let low = self.values[at] * (1.0 - u) + self.values[at + 1] * u;
            let above = at + ANGLES;
            let high = self.values[above] * (1.0 - u) + self.values[above + 1] * u;
            result[lane] = low * (1.0 - v) + high * v;
        }
        Wide(result)
    }
}

/// Mean powers over caps of `share` times a texel's radius.
fn table(exponent: f64, share: f64) -> Vec<f32> {
    let mut values = Vec::with_capacity(ANGLES * SOLID_ANGLES);
    for row in 0..SOLID_ANGLES {
        let second = row as f64 / (SOLID_ANGLES - 1) as f64;
        // Δω = 2π(1 − cos α) = 4π·sin²(α/2).
        let radius = 2.0 * (0.5 * second).asin();
        for column in 0..ANGLES {
            let first = column as f64 / (ANGLES - 1) as f64;
            let theta = (1.0 - 2.0 * first.powi(4)).clamp(-1.0, 1.0).acos();
            values.push(cap_mean(theta, (share * radius).min(PI), exponent) as f32);
        }
    }
    values
}
