//! How far an estimate is from a reference, in linear HDR, and whether the reference can tell.
//!
//! With estimate e, reference r and the reference's standard error s, over the n values (three
//! channels of every point that has a surface; black points count like any other):
//!
//! - RMSE = √(Σ(e−r)²/n);
//! - relMSE = Σ (e−r)²/(r²+ε) / n with ε = (0.01·mean|r|)²: a relative error, which turns into an
//!   absolute one below a hundredth of the mean, so that black values neither divide by zero nor
//!   are left out. The mean, not the maximum, sets ε, since one bright pixel must not hide the
//!   errors of all dark ones; being relative to r, ε makes relMSE independent of the unit;
//! - energy ratio = Σe/Σr, signs kept, all channels alike;
//! - 99.9th percentile and maximum of |e−r|, the percentile by nearest rank;
//! - noise floor = Σ s²/(r²+ε) / n, the relMSE that a perfect estimate would show, since
//!   E(e−r)² = s² where r errs independently of e;
//! - FLIP, for images only: what a viewer notices once both are tone-mapped alike ([`flip`]). It has no
//!   floor: noise in the reference shows in it like any other difference.
//!
//! A difference is *conclusive* if relMSE is more than [`NOISE_FACTOR`] times the floor, and exceeds
//! the floor by more than [`NOISE_DEVIATIONS`] standard deviations of what noise alone would give.
//! The first guards against a standard error that is itself uncertain, the second against few
//! points. The RMSE has to exceed its own floor too: at dark points whose samples all happened to
//! agree the standard error is too small, and relMSE gives such points most weight. An exact
//! reference (s = 0) is always conclusive: even a difference of zero is then a result.

mod formulas;

pub use formulas::{FORMULAS, Formula};
mod flip;

pub use flip::{FLIP_REACH, Flip, PIXELS_PER_DEGREE, flip};

use crate::record::{Comparison, Verdict};
use glam::{DVec3, Vec3};
use interreflect_scene::{Estimate, Points};

/// relMSE's √ε as a fraction of the reference's mean magnitude.
pub const EPSILON_FRACTION: f64 = 0.01;

/// How many times the noise floor a conclusive relMSE is at least.
pub const NOISE_FACTOR: f64 = 2.0;

/// By how many standard deviations of pure noise a conclusive relMSE exceeds the floor.
pub const NOISE_DEVIATIONS: f64 = 3.0;

/// What an estimate is compared with.
#[derive(Clone, Copy, Debug)]
pub struct Reference<'a> {
    /// The values.
    pub values: &'a Estimate,
    /// Standard error of each value; `None` if they are exact.
    pub standard_error: Option<&'a Estimate>,
    /// What it is, its sample count and seed where it has them; recorded with the numbers.
    pub description: &'a str,
}

/// Compares an estimate with a reference at the points that have a surface, or at all points if
/// `points` is `None` (an image).
///
/// # Errors
/// [`MetricsError`] if the lengths differ, no point has a surface, or a value is not finite.
pub fn compare(
    estimate: &Estimate,
    reference: Reference<'_>,
    points: Option<&Points>,
) -> Result<Comparison, MetricsError> {
    check_lengths(estimate, &reference, points)?;
    check_finite("estimate", estimate, points)?;
    check_finite("reference", reference.values, points)?;
    if let Some(error) = reference.standard_error {
        check_finite("reference's standard error", error, points)?;
    }
    let samples: Vec<Sample> = surfaces(points, estimate.len())
        .map(|i| Sample {
            estimate: estimate.get(i).as_dvec3(),
            reference: reference.values.get(i).as_dvec3(),
            standard_error: reference
                .standard_error
                .map_or(DVec3::ZERO, |e| e.get(i).as_dvec3()),
        })
        .collect();
    if samples.is_empty() {
        return Err(MetricsError::NoPoints {
            points: estimate.len(),
        });
    }
    let mut comparison = summarise(&samples);
    comparison.reference = Some(reference.description.into()).filter(|d: &String| !d.is_empty());
    Ok(comparison)
}

/// Checks that every value at a point with a surface is finite.
///
/// `what` names the values in the message.
///
/// # Errors
/// [`MetricsError::NonFinite`] with the first point that is not.
pub fn check_finite(
    what: &'static str,
    values: &Estimate,
    points: Option<&Points>,
) -> Result<(), MetricsError> {
    match surfaces(points, values.len()).find(|&i| !values.get(i).is_finite()) {
        None => Ok(()),
        Some(point) => Err(MetricsError::NonFinite {
            what,
            point,
            place: match points.and_then(|p| p.get(point)) {
                Some(p) => format!(" at position {}, normal {}", p.position, p.normal),
                None => String::new(),
            },
            value: values.get(point),
        }),
    }
}

/// Why an estimate could not be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MetricsError {
    /// Two lists that should hold one value per point differ in length.
    #[error("the estimate has {estimate} values and the {what} {other}: compare the same points")]
    Length {
        /// Values of the estimate.
        estimate: usize,
        /// The other list.
        what: &'static str,
        /// Its length.
        other: usize,
    },
    /// No point has a surface.
    #[error("none of the {points} points has a surface: nothing can be compared")]
    NoPoints {
        /// Number of points.
        points: usize,
    },
    /// A value is infinite or not a number.
    #[error("the {what} is not finite at point {point}{place}: {value}")]
    NonFinite {
        /// Which values.
        what: &'static str,
        /// Index of the point.
        point: usize,
        /// Its position and normal, where known.
        place: String,
        /// The value.
        value: Vec3,
    },
}

fn check_lengths(
    estimate: &Estimate,
    reference: &Reference<'_>,
    points: Option<&Points>,
) -> Result<(), MetricsError> {
    let others = [
        ("reference", Some(reference.values.len())),
        (
            "reference's standard error",
            reference.standard_error.map(Estimate::len),
        ),
        ("point list", points.map(Points::len)),
    ];
    for (what, other) in others {
        if let Some(other) = other.filter(|&len| len != estimate.len()) {
            return Err(MetricsError::Length {
                estimate: estimate.len(),
                what,
                other,
            });
        }
    }
    Ok(())
}

/// Indices of the points that have a surface.
fn surfaces(points: Option<&Points>, len: usize) -> impl Iterator<Item = usize> + '_ {
    (0..len).filter(move |&i| points.is_none_or(|p| p.get(i).is_some()))
}

/// The ε of relMSE for a reference of this mean magnitude.
pub(crate) fn epsilon(mean_magnitude: f64) -> f64 {
    (EPSILON_FRACTION * mean_magnitude).powi(2)
}

struct Sample {
    estimate: DVec3,
    reference: DVec3,
    standard_error: DVec3,
}

/// The metrics of a non-empty list of finite samples, in float64.
fn summarise(samples: &[Sample]) -> Comparison {
    let values = 3.0 * samples.len() as f64;
    let mean = |f: &dyn Fn(&Sample) -> DVec3| {
        samples.iter().map(|s| f(s).element_sum()).sum::<f64>() / values
    };
    let square = |v: DVec3| v * v;
    let energy = mean(&|s| s.reference);
    let epsilon = epsilon(mean(&|s| s.reference.abs()));
    let mse = mean(&|s| square(s.estimate - s.reference));
    let noise_mse = mean(&|s| square(s.standard_error));
    let weight = |s: &Sample| (square(s.reference) + epsilon).recip();
    let relative = (epsilon > 0.0).then(|| Relative {
        relmse: mean(&|s| square(s.estimate - s.reference) * weight(s)),
        floor: mean(&|s| square(s.standard_error) * weight(s)),
        floor_deviation: noise_deviation(samples, weight),
    });
    let errors = sorted_errors(samples);
    Comparison {
        relmse: relative.as_ref().map(|r| r.relmse),
        rmse: mse.sqrt(),
        energy_ratio: (energy != 0.0).then(|| mean(&|s| s.estimate) / energy),
        p999: nearest_rank(&errors, 0.999),
        max: nearest_rank(&errors, 1.0),
        noise_floor: relative.as_ref().map(|r| r.floor),
        verdict: match &relative {
            Some(_) if noise_mse > 0.0 && mse <= noise_mse => Verdict::Inconclusive,
            Some(r) => r.verdict(),
            None if noise_mse == 0.0 || mse > NOISE_FACTOR * noise_mse => Verdict::Conclusive,
            None => Verdict::Inconclusive,
        },
        relmse_above_noise: relative.as_ref().map(|r| (r.relmse - r.floor).max(0.0)),
        noise_floor_rmse: noise_mse.sqrt(),
        epsilon,
        flip: None,
        compared: samples.len(),
        reference: None,
    }
}

struct Relative {
    relmse: f64,
    floor: f64,
    floor_deviation: f64,
}

impl Relative {
    fn verdict(&self) -> Verdict {
        let factor = NOISE_FACTOR * self.floor;
        let deviations = self.floor + NOISE_DEVIATIONS * self.floor_deviation;
        if self.floor == 0.0 || self.relmse > factor.max(deviations) {
            Verdict::Conclusive
        } else {
            Verdict::Inconclusive
        }
    }
}

/// Standard deviation of the relMSE that noise alone gives.
///
/// The square of a normal error of deviation s has variance 2s⁴. The channels of a point share
/// their light paths, so they count as one: a point's deviation is √2 times its weighted sum of s²;
/// points are independent.
fn noise_deviation(samples: &[Sample], weight: impl Fn(&Sample) -> DVec3) -> f64 {
    let variance: f64 = samples
        .iter()
        .map(|s| {
            2.0 * (s.standard_error * s.standard_error * weight(s))
                .element_sum()
                .powi(2)
        })
        .sum();
    variance.sqrt() / (3.0 * samples.len() as f64)
}

/// Absolute errors of all values in rising order.
fn sorted_errors(samples: &[Sample]) -> Vec<f64> {
    let channels = |s: &Sample| (s.estimate - s.reference).abs().to_array();
    let mut errors: Vec<f64> = samples.iter().flat_map(channels).collect();
    errors.sort_by(f64::total_cmp);
    errors
}

/// The smallest of the sorted values that a fraction of all does not exceed; 0 without values.
pub(crate) fn nearest_rank(sorted: &[f64], fraction: f64) -> f64 {
    let rank = (fraction * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests;
