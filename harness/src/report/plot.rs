//! The trade itself: time of a frame against error, both logarithmic.

use crate::record::{Backend, Run, Verdict};
use serde::Serialize;

/// Inner size of the plot in SVG units.
const SIZE: (f64, f64) = (520.0, 260.0);

/// A scatter plot in SVG units, with the origin in the upper left corner.
#[derive(Serialize)]
pub(super) struct Plot {
    width: f64,
    height: f64,
    /// What the vertical axis shows.
    error_of: &'static str,
    marks: Vec<Mark>,
    time_ticks: Vec<Tick>,
    error_ticks: Vec<Tick>,
    /// Runs without a time or an error above 0, which no logarithmic axis can show.
    left_out: usize,
}

/// A run.
#[derive(Serialize)]
struct Mark {
    x: f64,
    y: f64,
    number: usize,
    label: String,
    gpu: bool,
    software: bool,
    conclusive: bool,
}

/// A power of ten on an axis.
#[derive(Serialize)]
struct Tick {
    at: f64,
    label: String,
}

/// A logarithmic axis over whole decades.
struct Axis {
    first: i32,
    last: i32,
}

impl Plot {
    /// The plot of a section's runs, numbered as in its table; `None` if there are fewer than two
    /// points to show. The error is the truth's, or the own model's where no run has a truth.
    pub(super) fn of(runs: &[&Run]) -> Option<Self> {
        let has_truth = runs.iter().any(|r| r.truth.is_some());
        let error_of = if has_truth {
            "the truth"
        } else {
            "the own model"
        };
        let comparison = |r: &Run| {
            if has_truth {
                r.truth.clone()
            } else {
                r.own_model.clone()
            }
        };
        let mut points = Vec::new();
        for (i, run) in runs.iter().copied().enumerate() {
            let Some(comparison) = comparison(run) else {
                continue;
            };
            let error = comparison.relmse.filter(|e| *e > 0.0);
            let time = run.phases_ms.frame_ms().filter(|t| *t > 0.0);
            if let (Some(time), Some(error)) = (time, error) {
                points.push((i + 1, run, time, error, comparison.verdict));
            }
        }
        if points.len() < 2 {
            return None;
        }
        let times = Axis::around(points.iter().map(|p| p.2));
        let errors = Axis::around(points.iter().map(|p| p.3));
        let mark = |&(number, run, time, error, verdict): &(usize, &Run, f64, f64, Verdict)| Mark {
            x: SIZE.0 * times.fraction(time),
            y: SIZE.1 * (1.0 - errors.fraction(error)),
            number,
            label: format!("{}, {}", run.label(), run.backend),
            gpu: run.backend == Backend::Gpu,
            software: run.software,
            conclusive: verdict == Verdict::Conclusive,
        };
        Some(Self {
            width: SIZE.0,
            height: SIZE.1,
            error_of,
            marks: points.iter().map(mark).collect(),
            time_ticks: times.ticks(|f| SIZE.0 * f),
            error_ticks: errors.ticks(|f| SIZE.1 * (1.0 - f)),
            left_out: runs.iter().filter(|r| r.skipped.is_none()).count() - points.len(),
        })
    }
}

impl Axis {
    /// The decades that hold all of some positive values; at least one.
    fn around(values: impl Iterator<Item = f64> + Clone) -> Self {
        let low = values.clone().fold(f64::INFINITY, f64::min).log10().floor() as i32;
        let high = values.fold(0.0, f64::max).log10().ceil() as i32;
        Self {
            first: low,
            last: high.max(low + 1),
        }
    }

    /// Position of a positive value along the axis, 0 to 1.
    fn fraction(&self, value: f64) -> f64 {
        (value.log10() - f64::from(self.first)) / f64::from(self.last - self.first)
    }

    /// Powers of ten, at most about eight of them.
    fn ticks(&self, place: impl Fn(f64) -> f64) -> Vec<Tick> {
        let step = ((self.last - self.first + 7) / 8).max(1) as usize;
        let tick = |exponent: i32| Tick {
            at: place(self.fraction(10_f64.powi(exponent))),
            label: match exponent {
                -3..=4 => 10_f64.powi(exponent).to_string(),
                _ => format!("1e{exponent}"),
            },
        };
        (self.first..=self.last).step_by(step).map(tick).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_span_whole_decades() {
        let axis = Axis::around([0.02, 3.0].into_iter());
        assert_eq!((axis.first, axis.last), (-2, 1));
        assert_eq!(axis.fraction(0.01), 0.0);
        assert_eq!(axis.fraction(10.0), 1.0);
        let labels: Vec<_> = axis.ticks(|f| f).into_iter().map(|t| t.label).collect();
        assert_eq!(labels, ["0.01", "0.1", "1", "10"]);
        let one = Axis::around([1.0].into_iter());
        assert_eq!((one.first, one.last), (0, 1));
        assert!(Axis::around([1e-30, 1e30].into_iter()).ticks(|f| f).len() <= 9);
    }
}
