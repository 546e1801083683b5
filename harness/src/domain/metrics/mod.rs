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
//! Whether the reference resolves the difference, [`super::significance`] says.

mod formulas;

pub use formulas::{FORMULAS, Formula};
mod flip;

pub use flip::{FLIP_REACH, Flip, PIXELS_PER_DEGREE, flip};

use super::record::Comparison;
use super::significance::{Difference, verdict};
use super::statistics::nearest_rank;
use glam::{DVec3, Vec3};
use interreflect_scene::{Estimate, Points};

/// relMSE's √ε as a fraction of the reference's mean magnitude.
pub const EPSILON_FRACTION: f64 = 0.01;

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
    let mse = Difference {
        squared: mean(&|s| square(s.estimate - s.reference)),
        floor: mean(&|s| square(s.standard_error)),
    };
    let weight = |s: &Sample| (square(s.reference) + epsilon).recip();
    let relmse = (epsilon > 0.0).then(|| Difference {
        squared: mean(&|s| square(s.estimate - s.reference) * weight(s)),
        floor: mean(&|s| square(s.standard_error) * weight(s)),
    });
    let errors = sorted_errors(samples);
    Comparison {
        relmse: relmse.map(|r| r.squared),
        rmse: mse.squared.sqrt(),
        energy_ratio: (energy != 0.0).then(|| mean(&|s| s.estimate) / energy),
        p999: nearest_rank(&errors, 0.999),
        max: nearest_rank(&errors, 1.0),
        noise_floor: relmse.map(|r| r.floor),
        verdict: verdict(mse, relmse.map(|r| (r, noise_deviation(samples, weight)))),
        relmse_above_noise: relmse.map(|r| (r.squared - r.floor).max(0.0)),
        noise_floor_rmse: mse.floor.sqrt(),
        epsilon,
        flip: None,
        compared: samples.len(),
        reference: None,
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

#[cfg(test)]
mod tests;
