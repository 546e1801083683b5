//! How well a median is known, and whether its clock is fine enough.

use super::median;

/// Resamples of the bootstrap: the ends of a 95 % interval lie on the 5th and the 195th.
const RESAMPLES: usize = 200;

/// Seed of the resamples: the same times have the same interval.
const SEED: u64 = 0x5eed;

/// 95 % interval of the median by the percentile bootstrap (Efron 1979); `None` for fewer than two
/// times.
pub(crate) fn interval(times: &[f64]) -> Option<(f64, f64)> {
    if times.len() < 2 {
        return None;
    }
    let mut random = fastrand::Rng::with_seed(SEED);
    let mut medians: Vec<f64> = (0..RESAMPLES)
        .filter_map(|_| median((0..times.len()).map(|_| times[random.usize(..times.len())])))
        .collect();
    medians.sort_by(f64::total_cmp);
    let tail = RESAMPLES / 40;
    Some((medians[tail - 1], medians[RESAMPLES - tail]))
}

/// The part of the median that a clock's step may be.
const FINE: f64 = 0.05;

/// The step of a clock that is too coarse for these times: the least difference of two of them, where
/// it is a large part of the median and some times are equal, as no two times of a fine clock are.
pub(crate) fn quantum(times_ms: &[f64]) -> Option<f64> {
    let mut sorted = times_ms.to_vec();
    sorted.sort_by(f64::total_cmp);
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]);
    let (equal, apart): (Vec<f64>, Vec<f64>) = steps.partition(|step| *step == 0.0);
    let step = match apart.iter().copied().min_by(f64::total_cmp) {
        Some(step) => step,
        // All are equal: one step or many, nothing tells.
        None => *sorted.first()?,
    };
    let middle = median(times_ms.iter().copied())?;
    let coarse = sorted.len() > 2 && equal.len() * 4 >= sorted.len();
    (coarse && step > FINE * middle).then_some(step)
}

#[cfg(test)]
mod tests;
