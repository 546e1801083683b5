//! Whether path-traced estimates are what they should be.
//!
//! A mean of [`REPLICATES`] independent replicates, less what it should be and over its spread, is
//! Student's t with 31 degrees of freedom, as far as replicates are normal. Every t is turned into
//! the normal score z of the same probability; then the largest |z| is held to Šidák's bound, and
//! the mean square of all z to the quantiles of χ² on both sides.

mod score;

pub use score::{largest_bound, score, score_of};

use glam::DVec3;
use interreflect_cpu::path_tracer::{REPLICATES, Traced};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Probability that one of the three tests rejects what is right: one in a thousand, as a suite has
/// about a hundred of them. Seeds are fixed, so that a trial that passed passes again.
pub const FAMILY_ERROR: f64 = 1e-3;

/// Spreads below this part of the estimate are rounding to f32, not randomness.
const ROUNDING: f64 = 1e-5;

/// Why estimates are not what they should be.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Disagreement {
    /// Something is not a number.
    #[error("point {point} is not a number")]
    NotANumber {
        /// Its place in the list.
        point: usize,
    },
    /// One value is off by more than chance allows.
    #[error("point {point} is off: |z| = {z:.2}, and {bound:.2} is the bound for {values} values")]
    Outlier {
        /// Its place in the list.
        point: usize,
        /// The largest |z|.
        z: f64,
        /// Šidák's bound.
        bound: f64,
        /// How many there are.
        values: usize,
    },
    /// All together they are off by more than their errors, or their errors are too small.
    #[error("the mean of z² is {mean_square:.3}, above {bound:.3}")]
    Off {
        /// Mean of z².
        mean_square: f64,
        /// Quantile of χ² over its degrees of freedom.
        bound: f64,
    },
    /// They agree better than their errors allow: the errors are too large, or not independent.
    #[error("the mean of z² is {mean_square:.3}, below {bound:.3}: errors are overstated")]
    TooGood {
        /// Mean of z².
        mean_square: f64,
        /// Quantile of χ² over its degrees of freedom.
        bound: f64,
    },
    /// No value has an error, or is off.
    #[error("no value has a usable standard error")]
    Nothing,
}

/// Normal scores of Σ weight × estimate less its exact value, in every channel of every point.
pub struct Scores {
    /// Point and z over all that is known of its error: none of these may be large.
    cautious: Vec<(usize, f64)>,
    /// The same over the spread alone: the mean square of these is not to be small.
    bare: Vec<(usize, f64)>,
    /// Root mean square of the spread over that of the estimates.
    noise: f64,
}

impl Scores {
    /// Of a weighted sum of estimates at the same points, made with different seeds. `known` is how far
    /// off they may be for a known reason (a mesh in a sphere's place), relative to the exact value.
    ///
    /// Values without spread that are exactly right tell nothing and are left out.
    pub fn new(
        terms: &[(f64, &Traced)],
        exact: impl Fn(usize) -> DVec3,
        known: f64,
    ) -> Result<Self, Disagreement> {
        let points = terms.first().map_or(0, |(_, traced)| traced.mean.len());
        let mut scores = Self {
            cautious: Vec::new(),
            bare: Vec::new(),
            noise: 0.0,
        };
        let (mut variance, mut square) = (0.0, 0.0);
        for point in 0..points {
            let exact = exact(point);
            for channel in 0..3 {
                let value = Deviation::new(terms, point, channel, exact[channel]);
                if !value.difference.is_finite() {
                    return Err(Disagreement::NotANumber { point });
                }
                variance += value.variance;
                square += value.size * value.size;
                scores.add(point, &value, known * exact[channel]);
            }
        }
        scores.noise = (variance / square).sqrt();
        Ok(scores)
    }

    /// Of one estimate less its exact value in every channel.
    pub fn against(traced: &Traced, exact: impl Fn(usize) -> f64) -> Result<Self, Disagreement> {
        Self::new(&[(1.0, traced)], |i| DVec3::splat(exact(i)), 0.0)
    }

    /// Of the difference of two estimates.
    pub fn between(a: &Traced, b: &Traced) -> Result<Self, Disagreement> {
        Self::new(&[(1.0, a), (-1.0, b)], |_| DVec3::ZERO, 0.0)
    }

    fn add(&mut self, point: usize, value: &Deviation, known: f64) {
        if value.variance == 0.0 && value.difference == 0.0 {
            return;
        }
        let spread = value.variance.sqrt();
        if spread > ROUNDING * value.size {
            let t = value.difference / spread;
            self.bare.push((point, score(t, value.freedom)));
        }
        let whole = (value.variance + value.floor + known * known).sqrt();
        let t = value.difference / whole;
        self.cautious.push((point, score(t, value.freedom)));
    }

    /// Root mean square of the spread over that of the estimates: above it, a trial sees nothing.
    pub fn noise(&self) -> f64 {
        self.noise
    }

    /// Whether all of it is chance.
    ///
    /// # Errors
    /// The first [`Disagreement`] that is found.
    pub fn check(&self) -> Result<(), Disagreement> {
        let values = self.cautious.len();
        let larger = |a: &(usize, f64), b: &(usize, f64)| a.1.abs().total_cmp(&b.1.abs());
        let &(point, z) =
            (self.cautious.iter().max_by(|a, b| larger(a, b))).ok_or(Disagreement::Nothing)?;
        let (z, bound) = (z.abs(), largest_bound(values, FAMILY_ERROR));
        if z > bound {
            return Err(Disagreement::Outlier {
                point,
                z,
                bound,
                values,
            });
        }
        let (mean_square, freedom) = mean_of_squares(&self.cautious);
        let bound = quantile(1.0 - FAMILY_ERROR, freedom);
        if mean_square > bound {
            return Err(Disagreement::Off { mean_square, bound });
        }
        if self.bare.is_empty() {
            return Ok(());
        }
        let (mean_square, freedom) = mean_of_squares(&self.bare);
        let bound = quantile(FAMILY_ERROR, freedom);
        if mean_square < bound {
            return Err(Disagreement::TooGood { mean_square, bound });
        }
        Ok(())
    }
}

/// Mean of z², and its degrees of freedom: one a point. The channels of a point share their paths, so
/// that three of them may be worth no more than one.
fn mean_of_squares(scores: &[(usize, f64)]) -> (f64, usize) {
    let sum: f64 = scores.iter().map(|(_, z)| z * z).sum();
    let mut points: Vec<usize> = scores.iter().map(|s| s.0).collect();
    points.dedup();
    (sum / scores.len() as f64, points.len())
}

/// Quantile of the mean square of independent normal variables.
fn quantile(probability: f64, freedom: usize) -> f64 {
    let freedom = freedom as f64;
    let chi_squared = ChiSquared::new(freedom).expect("at least one degree of freedom");
    chi_squared.inverse_cdf(probability) / freedom
}

/// How far a weighted sum is off at one point.
struct Deviation {
    difference: f64,
    /// Square of the standard deviation, from the spreads of the terms.
    variance: f64,
    /// Square of what the terms' spreads can't tell.
    floor: f64,
    /// Degrees of freedom of the variance (Welch & Satterthwaite).
    freedom: f64,
    /// Root of Σ (weight × estimate)², or the exact value if that is larger.
    size: f64,
}

impl Deviation {
    fn new(terms: &[(f64, &Traced)], point: usize, channel: usize, exact: f64) -> Self {
        let each = f64::from(REPLICATES - 1);
        let (mut sum, mut size) = (0.0, exact * exact);
        let (mut variance, mut floor, mut uncertainty) = (0.0, 0.0, 0.0);
        for &(weight, traced) in terms {
            let of = |e: &interreflect_scene::Estimate| weight * f64::from(e.get(point)[channel]);
            let (mean, spread) = (of(&traced.mean), of(&traced.spread));
            sum += mean;
            size = size.max(mean * mean);
            let term = spread * spread;
            variance += term;
            uncertainty += term * term / each;
            floor += of(&traced.unseen).powi(2);
        }
        let freedom = match variance * variance / uncertainty {
            ratio if ratio.is_finite() => ratio,
            _ => each,
        };
        Self {
            difference: sum - exact,
            variance,
            floor,
            freedom,
            size: size.sqrt(),
        }
    }
}

#[cfg(test)]
mod tests;
