//! Times of a phase: their middle, their spread, and how far they can be believed.

use crate::domain::statistics::median;
use interreflect_gpu::Mistimed;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How phases were timed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TimeSource {
    /// Host clock around submission and wait.
    WallClock,
    /// Timestamps written by the device: what the host does to record the work is not in them.
    GpuTimestamps,
}

impl fmt::Display for TimeSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::WallClock => "wall clock",
            Self::GpuTimestamps => "GPU timestamps",
        })
    }
}

/// Why a device's times were not taken though it has a clock, or none.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "why", rename_all = "snake_case")]
pub enum Fallback {
    /// The device has no timestamps.
    NoClock,
    /// An end lay before its start.
    Backwards,
    /// Work ran in no time.
    Still,
    /// Longer than the host waited for it.
    TooLong,
    /// The clock's step is a large part of the times.
    Coarse {
        /// The step, in milliseconds.
        step_ms: f64,
    },
}

impl From<Mistimed> for Fallback {
    fn from(why: Mistimed) -> Self {
        match why {
            Mistimed::NoClock => Self::NoClock,
            Mistimed::Backwards => Self::Backwards,
            Mistimed::Still => Self::Still,
            Mistimed::TooLong => Self::TooLong,
        }
    }
}

impl fmt::Display for Fallback {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoClock => Mistimed::NoClock.fmt(f),
            Self::Backwards => Mistimed::Backwards.fmt(f),
            Self::Still => Mistimed::Still.fmt(f),
            Self::TooLong => Mistimed::TooLong.fmt(f),
            Self::Coarse { step_ms } => {
                write!(f, "the device's clock goes in steps of {step_ms} ms")
            }
        }
    }
}

/// Spread of repeated times in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// Median; the mean of the middle two for an even count.
    pub median: f64,
    /// Median absolute deviation from the median, unscaled.
    pub mad: f64,
    /// Number of repetitions.
    pub n: usize,
    /// Lower end of the median's 95 % interval, by bootstrap.
    pub low: f64,
    /// Upper end of it.
    pub high: f64,
    /// Whether the interval was narrow enough before the patience ended; `None` for what is done once.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub settled: Option<bool>,
    /// The clock.
    pub source: TimeSource,
    /// Why it is not the device's, where the device did the work.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fallback: Option<Fallback>,
    /// By which part of the median the times rose (fell, if negative) from first to last, where that is
    /// more than chance and more than the spread that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub drift: Option<f64>,
}

impl Timing {
    /// Summary of times in milliseconds by the host's clock, without an interval; `None` without any.
    pub fn of(times_ms: &[f64]) -> Option<Self> {
        let middle = median(times_ms.iter().copied())?;
        let mad = median(times_ms.iter().map(|t| (t - middle).abs()))?;
        Some(Self {
            median: middle,
            mad,
            n: times_ms.len(),
            low: middle,
            high: middle,
            settled: None,
            source: TimeSource::WallClock,
            fallback: None,
            drift: None,
        })
    }

    /// One after the other: medians add up, and independent deviations by their squares.
    pub(super) fn and(self, other: Self) -> Self {
        let median = self.median + other.median;
        let low = (self.median - self.low).hypot(other.median - other.low);
        let high = (self.high - self.median).hypot(other.high - other.median);
        Self {
            median,
            mad: self.mad.hypot(other.mad),
            n: self.n.min(other.n),
            low: median - low,
            high: median + high,
            settled: self.settled.zip(other.settled).map(|(a, b)| a && b),
            source: self.source,
            fallback: self.fallback.or(other.fallback),
            drift: self.drift.or(other.drift),
        }
    }
}

#[cfg(test)]
mod tests;
