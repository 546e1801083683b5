//! Times that can be trusted: repeated until their median is known well enough, or until the patience
//! ends, and judged before they are believed.

mod throttle;

pub use throttle::Throttle;

use crate::domain::record::{Fallback, TimeSource, Timing};
use crate::domain::statistics::{drift, interval, quantum};
use interreflect_estimators::execution::Elapsed;

/// How often a phase is timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// At least so many times, if the first of them leaves the patience for it.
    pub least: usize,
    /// At most so many times.
    pub most: usize,
    /// Good enough is a median whose interval reaches no further than this fraction to either side.
    pub spread: f64,
    /// Milliseconds after which a phase is not repeated further.
    pub patience_ms: f64,
}

impl Default for Sampling {
    fn default() -> Self {
        Self {
            least: 5,
            most: 256,
            spread: 0.05,
            patience_ms: 250.0,
        }
    }
}

impl Sampling {
    /// Once, whatever it takes: for estimates whose time does not matter.
    pub const ONCE: Self = Self {
        least: 1,
        most: 1,
        spread: 0.0,
        patience_ms: 0.0,
    };

    /// Repeats a phase after its first run, which warms up and took `first`. The times that count; the
    /// first alone, where there is no patience for another.
    ///
    /// # Errors
    /// The phase's own.
    pub fn repeat<E>(
        &self,
        first: Elapsed,
        mut phase: impl FnMut() -> Result<Elapsed, E>,
    ) -> Result<Vec<Elapsed>, E> {
        let mut times: Vec<Elapsed> = Vec::new();
        // A device's first run compiles: it says nothing of what the next will take.
        let mut spent_ms = first.device_ms.map_or(first.wall_ms, |_| 0.0);
        // Looked at when the count has grown by a third: each look costs more than a short phase.
        let mut look = self.least;
        while times.len() < self.most && spent_ms < self.patience_ms {
            let elapsed = phase()?;
            spent_ms += elapsed.wall_ms;
            times.push(elapsed);
            if times.len() >= look {
                look += look.div_ceil(3);
                if self.is_settled(&judge(&times).0) {
                    break;
                }
            }
        }
        if times.is_empty() {
            times.push(first);
        }
        Ok(times)
    }

    /// Summary of a phase's times; `None` without any.
    pub fn timing(&self, times: &[Elapsed]) -> Option<Timing> {
        let (times_ms, source, fallback) = judge(times);
        let summary = Timing::of(&times_ms)?;
        let (low, high) = interval(&times_ms).unwrap_or((summary.median, summary.median));
        Some(Timing {
            low,
            high,
            settled: Some(self.is_settled(&times_ms)),
            source,
            fallback,
            drift: drift(&times_ms).filter(|d| d.abs() > self.spread),
            ..summary
        })
    }

    fn is_settled(&self, times_ms: &[f64]) -> bool {
        let enough = times_ms.len() >= self.least.max(2);
        let known = interval(times_ms).zip(Timing::of(times_ms));
        enough && known.is_some_and(|((low, high), t)| high - low <= 2.0 * self.spread * t.median)
    }
}

/// The times by the clock that can be trusted, and why it is not the device's where it is not: one
/// clock for all, since the host's counts more than the device's.
fn judge(times: &[Elapsed]) -> (Vec<f64>, TimeSource, Option<Fallback>) {
    let wall = || times.iter().map(|t| t.wall_ms).collect();
    let device: Option<Vec<_>> = times.iter().map(|t| t.device_ms).collect();
    let Some(device) = device else {
        return (wall(), TimeSource::WallClock, None);
    };
    let fallback = match device.iter().copied().collect::<Result<Vec<f64>, _>>() {
        Ok(device_ms) => match quantum(&device_ms) {
            None => return (device_ms, TimeSource::GpuTimestamps, None),
            Some(step_ms) => Fallback::Coarse { step_ms },
        },
        Err(why) => why.into(),
    };
    (wall(), TimeSource::WallClock, Some(fallback))
}

#[cfg(test)]
mod tests;
