//! Scores of single values, and the bound for the largest of many.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

/// The normal score of the same probability as Student's t with these degrees of freedom.
pub fn score(t: f64, freedom: f64) -> f64 {
    let student = StudentsT::new(0.0, 1.0, freedom).expect("positive degrees of freedom");
    // The tail keeps its digits where 1 less the tail has none.
    -Normal::standard().inverse_cdf(student.sf(t.abs())) * t.signum()
}

/// The normal score of the mean of independent values, all of one distribution, less what it should
/// be.
pub fn score_of(values: &[f64], exact: f64) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
    let spread = (squares / (count * (count - 1.0))).sqrt();
    score((mean - exact) / spread, count - 1.0)
}

/// What |z| of none of `values` independent normal variables exceeds, but with the probability
/// `family_error` (Šidák: each is tested at 1 − (1 − α)^(1/n)); dependent ones do so less often.
pub fn largest_bound(values: usize, family_error: f64) -> f64 {
    // ln(1 − α)/n is small, and 1 − exp of it would cancel.
    let each = -((-family_error).ln_1p() / values as f64).exp_m1();
    -Normal::standard().inverse_cdf(0.5 * each)
}
