//! Statistics of repeated times and of errors.

mod spread;
mod trend;

pub(crate) use spread::{interval, quantum};
pub(crate) use trend::drift;

/// The middle value; the mean of the middle two for an even count, `None` without any.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    let upper = *values.get(values.len() / 2)?;
    if values.len() % 2 == 1 {
        return Some(upper);
    }
    Some(0.5 * (values[values.len() / 2 - 1] + upper))
}

/// The smallest of the sorted values that a fraction of all does not exceed; 0 without values.
pub(crate) fn nearest_rank(sorted: &[f64], fraction: f64) -> f64 {
    let rank = (fraction * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.max(1) - 1).copied().unwrap_or(0.0)
}
