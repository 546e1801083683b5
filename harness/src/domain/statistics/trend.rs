//! Whether times grow or fall while they are taken.

use super::median;

/// Times below which no trend is looked for.
const LEAST: usize = 8;

/// Standard deviations beyond which a trend is no accident.
const DEVIATIONS: f64 = 3.0;

/// By which part of the median the times rose from first to last, if that is more than chance gives:
/// the slope of Theil and Sen, where Mann and Kendall's test (1945) sees a trend.
pub(crate) fn drift(times: &[f64]) -> Option<f64> {
    let n = times.len();
    if n < LEAST {
        return None;
    }
    let pairs = || (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
    let signs = pairs().map(|(i, j)| (times[j] - times[i]).partial_cmp(&0.0));
    let score: i64 = signs.map(|o| o.map_or(0, |o| o as i64)).sum();
    let count = n as f64;
    let deviation = (count * (count - 1.0) * (2.0 * count + 5.0) / 18.0).sqrt();
    if (score as f64).abs() <= DEVIATIONS * deviation {
        return None;
    }
    let slope = median(pairs().map(|(i, j)| (times[j] - times[i]) / (j - i) as f64))?;
    Some(slope * (count - 1.0) / median(times.iter().copied())?)
}

#[cfg(test)]
mod tests;
