//! Low-discrepancy numbers and the mappings from them to directions.

use glam::{Quat, Vec3};
use std::f32::consts::{PI, TAU};

/// Samples of one sequence before it repeats; the limit of `sobol_burley`.
pub(super) const SEQUENCE_LENGTH: u32 = 1 << 16;

/// Dimension sets of one sequence that are used before another is padded on.
const SETS: u32 = 16;

/// One sample of an Owen-scrambled Sobol sequence (Burley, Practical Hash-based Owen Scrambling,
/// JCGT 2020), handed out in sets of four dimensions.
///
/// Sequences of different seeds are independent randomisations. Sets beyond the sixteenth
/// come from another sequence (padding), which keeps every set stratified in itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    index: u32,
    seed: u32,
}

impl Sample {
    pub(super) fn new(index: u32, seed: u32) -> Self {
        Self { index, seed }
    }

    /// Four numbers in [0, 1).
    #[inline]
    pub(super) fn set(self, set: u32) -> [f32; 4] {
        let seed = match set / SETS {
            0 => self.seed,
            padding => hash(u64::from(self.seed) << 32 | u64::from(padding)) as u32,
        };
        sobol_burley::sample_4d(self.index, set % SETS, seed)
    }
}

/// A 64-bit hash: the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
pub(super) fn hash(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Direction around +z with density cos θ/π (sr⁻¹).
///
/// Malley's method on the concentric disc of Shirley and Chiu.
pub(super) fn cosine_hemisphere(u: f32, v: f32) -> Vec3 {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let (radius, phi) = if x == 0.0 && y == 0.0 {
        (0.0, 0.0)
    } else if x.abs() > y.abs() {
        (x, PI / 4.0 * (y / x))
    } else {
        (y, PI / 2.0 - PI / 4.0 * (x / y))
    };
    // Never on the horizon itself, where the density is 0 and the sample would be lost.
    let z = (1.0 - radius * radius).max(f32::EPSILON).sqrt();
    Vec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Direction around +z with density (n+1)/(2π)·cosⁿ θ.
pub(super) fn cosine_power(n: f32, u: f32, v: f32) -> Vec3 {
    // 1 − u > 0 keeps the direction off the horizon, where the density is 0.
    let z = (1.0 - u).powf(1.0 / (n + 1.0));
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let phi = TAU * v;
    Vec3::new(radius * phi.cos(), radius * phi.sin(), z)
}

/// Barycentric weights of a uniformly distributed point of a triangle.
pub(super) fn triangle(u: f32, v: f32) -> [f32; 3] {
    let root = u.sqrt();
    [1.0 - root, root * (1.0 - v), root * v]
}

/// The rotation that takes +z to a unit normal.
pub(super) fn world_from_normal(normal: Vec3) -> Quat {
    Quat::from_rotation_arc(Vec3::Z, normal)
}

/// Cumulated weights from which indices are drawn in proportion.
#[derive(Clone, Debug, Default)]
pub(crate) struct Cdf {
    /// Sum of the weights up to and with each index, the last one 1.
    cumulated: Vec<f32>,
}

impl Cdf {
    /// A table over weights ≥ 0, and their sum; `None` if nothing has weight.
    pub(crate) fn new(weights: impl Iterator<Item = f64>) -> Option<(Self, f64)> {
        let mut sum = 0.0;
        let sums: Vec<f64> = weights
            .map(|w| {
                sum += w;
                sum
            })
            .collect();
        let usable = sum > 0.0 && sum.is_finite();
        usable.then(|| {
            let cumulated = sums.iter().map(|s| (s / sum) as f32).collect();
            (Self { cumulated }, sum)
        })
    }

    /// The index at `u` ∈ [0, 1) and how far `u` is through its interval, in [0, 1).
    pub(super) fn sample(&self, u: f32) -> (usize, f32) {
        let index = self.cumulated.partition_point(|&c| c <= u);
        let index = index.min(self.cumulated.len() - 1);
        let (low, width) = (self.low(index), self.probability(index));
        let rest = if width > 0.0 { (u - low) / width } else { 0.5 };
        (index, rest.clamp(0.0, 1.0 - f32::EPSILON / 2.0))
    }

    /// Probability of an index.
    pub(super) fn probability(&self, index: usize) -> f32 {
        self.cumulated[index] - self.low(index)
    }

    fn low(&self, index: usize) -> f32 {
        if index == 0 {
            0.0
        } else {
            self.cumulated[index - 1]
        }
    }
}
