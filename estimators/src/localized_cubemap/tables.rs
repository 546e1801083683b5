//! Tables of the average reflectivity over angle and solid angle (P1 §3).
//!
//! The paper leaves open what a texel's solid angle means to a lobe about the half vector. Here a
//! texel is a cap of directions: the cosine is averaged over that cap, and the lobe over the half
//! vectors that it makes with the view direction, a cap of half the radius.

use super::math::{cap_mean, table_place};
use interreflect_cpu::lane::{Lane, Scalar};
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

    /// Which table belongs to a lobe of this exponent: its number.
    #[inline(always)]
    pub(super) fn of_lobe<S: Scalar>(&self, shininess: S) -> S {
        // Without lobes nothing shines, and any table will do.
        let later = self.lobes.iter().position(|e| S::from(*e) >= shininess);
        S::splat(later.map_or(self.lobes.len(), |place| 1 + place) as f64)
    }

    /// Bilinear values of a table for each lane.
    #[inline(always)]
    pub(super) fn averaged_over<L: Lane>(&self, table: L, cos_theta: L, omega: L) -> L {
        let (first, second) = table_place(cos_theta, omega);
        let mut means = L::from(0.0);
        // A loop: a closure is not sure to be inlined, which the kernel's instructions need.
        for (i, mean) in means.lanes_mut().iter_mut().enumerate() {
            let (table, first, second) = (table.lanes()[i], first.lanes()[i], second.lanes()[i]);
            *mean = self.bilinear(table.whole(), first, second);
        }
        means
    }

    /// Bilinear value of a table at a place in [0, 1]².
    #[inline(always)]
    fn bilinear<S: Scalar>(&self, table: usize, first: S, second: S) -> S {
        let one = S::from(1.0);
        let x = first * S::from((ANGLES - 1) as f32);
        let y = second * S::from((SOLID_ANGLES - 1) as f32);
        let (column, row) = (x.whole().min(ANGLES - 2), y.whole().min(SOLID_ANGLES - 2));
        let (u, v) = (x - S::from(column as f32), y - S::from(row as f32));
        let at = (table * SOLID_ANGLES + row) * ANGLES + column;
        let above = at + ANGLES;
        let nodes = [at, at + 1, above, above + 1].map(|at| S::from(self.values[at]));
        let low = nodes[0] * (one - u) + nodes[1] * u;
        let high = nodes[2] * (one - u) + nodes[3] * u;
        low * (one - v) + high * v
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
