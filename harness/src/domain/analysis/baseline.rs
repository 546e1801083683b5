//! What any scene can have at any time: path tracing, and rays gathered at each point.

use super::candidate::{Candidate, FrameTime, grouped};
use super::{Measured, Metric, Problem};
use crate::domain::record::{ParamValue, Run};
use interreflect_estimators::Method as _;
use interreflect_estimators::path_reference::PathReference;
use interreflect_scene::params::values;
use serde::Serialize;
use std::fmt;

/// An unbiased method that every other is held against: `path_reference` with so many samples a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Baseline {
    /// All reflections: `bounces` = 0.
    PathTracing,
    /// n rays a point, light reflected once: `bounces` = 1.
    NRayGathering,
}

impl fmt::Display for Baseline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::PathTracing => "path tracing",
            Self::NRayGathering => "n-ray gathering",
        })
    }
}

const SAMPLES: &str = "samples";
const BOUNCES: &str = "bounces";
const SEED: &str = "seed";

impl Baseline {
    /// In the order of tables.
    pub const ALL: [Self; 2] = [Self::PathTracing, Self::NRayGathering];

    /// Which baseline a run is: the path tracer with one of their numbers of reflections, and nothing else
    /// but samples and seed changed.
    pub fn of(run: &Run) -> Option<Self> {
        let path_traced = run.estimator == PathReference::INFO.id;
        let bounces = run.params.get(BOUNCES).filter(|_| path_traced)?;
        let usual = values(&PathReference::default());
        let mut fixed = usual
            .into_iter()
            .filter(|(field, _)| ![SAMPLES, BOUNCES, SEED].contains(&field.name));
        let unchanged = fixed.all(|(field, value)| {
            let found = run.params.get(field.name);
            found.is_none_or(|found| *found == ParamValue::from(value))
        });
        match bounces {
            ParamValue::U32(0) if unchanged => Some(Self::PathTracing),
            ParamValue::U32(1) if unchanged => Some(Self::NRayGathering),
            _ => None,
        }
    }
}

/// What a baseline reaches between two sample counts that were measured, by straight lines in log–log.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Interpolated {
    /// Samples a point; between the measured counts it is no whole number.
    pub samples: f64,
    /// What a frame takes.
    pub frame: FrameTime,
    /// The error; its noise is that of the noisier end.
    pub error: Measured,
}

/// Where a limit lies on a baseline's curve. Nothing is extrapolated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Reach {
    /// At a measured count, or between two.
    At(Interpolated),
    /// All that was measured is within the limit. This end of it comes nearest: what the baseline reaches
    /// is at least as good.
    Within(Interpolated),
    /// Nothing that was measured is within the limit; this end of it comes nearest.
    Outside(Interpolated),
}

/// A baseline at rising sample counts; never empty.
pub(super) struct Curve {
    pub(super) baseline: Baseline,
    points: Vec<Interpolated>,
}

impl Curve {
    /// The baselines' curves in one place, in the order of tables. Of several runs with the
    /// same count the first holds.
    pub(super) fn all(runs: &[Run], problem: &Problem, metric: Metric) -> Vec<Self> {
        let mut here = Candidate::all(runs, metric);
        here.retain(|c| Problem::of(c.run) == *problem);
        let mut curves: Vec<Self> = grouped(&here, Baseline::of)
            .into_iter()
            .filter_map(|(baseline, group)| Self::of(baseline?, &group))
            .collect();
        curves.sort_by_key(|c| Baseline::ALL.iter().position(|b| *b == c.baseline));
        curves
    }

    fn of(baseline: Baseline, group: &[Candidate<'_>]) -> Option<Self> {
        let mut points: Vec<Interpolated> = group.iter().filter_map(point).collect();
        points.sort_by(|a, b| a.samples.total_cmp(&b.samples));
        points.dedup_by_key(|p| p.samples);
        (!points.is_empty()).then_some(Self { baseline, points })
    }

    /// The least error that is reached in this time.
    ///
    /// Neither times nor errors go by the number of samples without fail, so that what was measured within
    /// the limit counts wherever it does better than the line.
    pub(super) fn at_time(&self, ms: f64) -> Reach {
        let Some(last) = self.points.iter().rposition(|p| p.frame.ms <= ms) else {
            return Reach::Outside(self.points[0]);
        };
        let on_line = match self.points.get(last + 1) {
            Some(next) => on_segment(&self.points[last], next, |p| p.frame.ms, ms),
            None if self.points[last].frame.ms == ms => Reach::At(self.points[last]),
            None => Reach::Within(self.points[last]),
        };
        let measured = self.points.iter().filter(|p| p.frame.ms <= ms);
        on_line.or_better(measured, |p| p.error.value)
    }

    /// The least time that it takes to come to this error; see [`Self::at_time`].
    pub(super) fn at_error(&self, error: f64) -> Reach {
        let Some(first) = self.points.iter().position(|p| p.error.value <= error) else {
            return Reach::Outside(self.points[self.points.len() - 1]);
        };
        let here = &self.points[first];
        let on_line = match first.checked_sub(1) {
            Some(before) => on_segment(&self.points[before], here, |p| p.error.value, error),
            None if here.error.value == error || here.samples <= 1.0 => Reach::At(*here),
            None => Reach::Within(*here),
        };
        let measured = self.points.iter().filter(|p| p.error.value <= error);
        on_line.or_better(measured, |p| p.frame.ms)
    }
}

impl Reach {
    /// The same kind of answer with the best of these, where one does better by `key`.
    fn or_better<'a>(
        self,
        measured: impl Iterator<Item = &'a Interpolated>,
        key: impl Fn(&Interpolated) -> f64,
    ) -> Self {
        let best = |found: Interpolated| {
            measured.fold(found, |best, p| if key(p) < key(&best) { *p } else { best })
        };
        match self {
            Self::At(found) => Self::At(best(found)),
            Self::Within(found) => Self::Within(best(found)),
            Self::Outside(end) => Self::Outside(end),
        }
    }
}

/// Between two neighbours, where `key` has this value.
fn on_segment(
    a: &Interpolated,
    b: &Interpolated,
    key: impl Fn(&Interpolated) -> f64,
    value: f64,
) -> Reach {
    // An error of zero has no logarithm: only the end that has it is known to reach it.
    let fraction = match key(b) > 0.0 {
        true => (value / key(a)).ln() / (key(b) / key(a)).ln(),
        false => 1.0,
    };
    Reach::At(between(a, b, fraction))
}

fn point(candidate: &Candidate<'_>) -> Option<Interpolated> {
    let ParamValue::U32(samples) = *candidate.run.params.get(SAMPLES)? else {
        return None;
    };
    (samples > 0 && candidate.time.low > 0.0).then_some(Interpolated {
        samples: samples.into(),
        frame: candidate.time,
        error: candidate.error,
    })
}

fn between(a: &Interpolated, b: &Interpolated, fraction: f64) -> Interpolated {
    let log = |a: f64, b: f64| a * (b / a).powf(fraction);
    Interpolated {
        samples: log(a.samples, b.samples),
        frame: FrameTime {
            ms: log(a.frame.ms, b.frame.ms),
            low: log(a.frame.low, b.frame.low),
            high: log(a.frame.high, b.frame.high),
        },
        error: Measured {
            value: match a.error.value > 0.0 && b.error.value > 0.0 {
                true => log(a.error.value, b.error.value),
                // Without a logarithm, what fewer samples reached.
                false if fraction < 1.0 => a.error.value,
                false => b.error.value,
            },
            noise: a.error.noise.max(b.error.noise),
            conclusive: a.error.conclusive && b.error.conclusive,
        },
    }
}
