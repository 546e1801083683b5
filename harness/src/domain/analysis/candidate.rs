//! Runs that have a time and an error, how two of them compare, and how one is named.

use super::{Measured, Metric};
use crate::domain::record::{Backend, ParamMap, Run};
use interreflect_scene::params::FIDELITY;
use serde::Serialize;

/// What a frame takes, in milliseconds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FrameTime {
    /// Median.
    pub ms: f64,
    /// Lower end of the median's 95 % interval.
    pub low: f64,
    /// Upper end of it.
    pub high: f64,
}

impl FrameTime {
    /// What a run's frame takes; `None` if it has no such time.
    pub fn of(run: &Run) -> Option<Self> {
        let frame = run.phases_ms.frame()?;
        let numbers = [frame.median, frame.low, frame.high];
        numbers.iter().all(|t| t.is_finite()).then_some(Self {
            ms: frame.median,
            low: frame.low,
            high: frame.high,
        })
    }

    /// Whether this is the shorter time beyond doubt: the intervals do not touch.
    pub fn surely_less(self, other: Self) -> bool {
        self.high < other.low
    }

    /// Whether this is beyond doubt not the longer time.
    pub(super) fn surely_at_most(self, other: Self) -> bool {
        self.high <= other.low
    }

    /// Whether neither time is the shorter one beyond doubt.
    pub fn alike(self, other: Self) -> bool {
        !self.surely_less(other) && !other.surely_less(self)
    }
}

/// A run that took place and has both numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate<'a> {
    pub(super) index: usize,
    pub(super) run: &'a Run,
    pub(super) time: FrameTime,
    pub(super) error: Measured,
}

impl<'a> Candidate<'a> {
    fn of(index: usize, run: &'a Run, metric: Metric) -> Option<Self> {
        Some(Self {
            index,
            run: Some(run).filter(|r| r.skipped.is_none())?,
            time: FrameTime::of(run)?,
            error: metric.value(run)?,
        })
    }

    /// All of them among these runs, in their order.
    pub(super) fn all(runs: &'a [Run], metric: Metric) -> Vec<Self> {
        let numbered = runs.iter().enumerate();
        numbered
            .filter_map(|(i, run)| Self::of(i, run, metric))
            .collect()
    }

    /// As good in both time and error, and better in one.
    pub(super) fn beats(&self, other: &Self) -> bool {
        let (time, error) = (self.time.ms, self.error.value);
        let (other_time, other_error) = (other.time.ms, other.error.value);
        time <= other_time && error <= other_error && (time < other_time || error < other_error)
    }

    /// Beats the other whatever the noise did.
    pub(super) fn surely_beats(&self, other: &Self) -> bool {
        self.surely_as_good(other)
            && (self.time.surely_less(other.time) || self.error.surely_less(other.error))
    }

    /// Beats the other, or might if the noise went that way.
    pub(super) fn may_beat(&self, other: &Self) -> bool {
        self.beats(other)
            || !(other.time.surely_less(self.time)
                || other.error.surely_less(self.error)
                || other.surely_as_good(self))
    }

    fn surely_as_good(&self, other: &Self) -> bool {
        self.time.surely_at_most(other.time) && self.error.surely_at_most(other.error)
    }
}

/// Candidates by a key, in the order in which the keys first appear.
pub(super) fn grouped<'a, K: PartialEq>(
    candidates: &[Candidate<'a>],
    key: impl Fn(&'a Run) -> K,
) -> Vec<(K, Vec<Candidate<'a>>)> {
    let mut groups: Vec<(K, Vec<Candidate<'a>>)> = Vec::new();
    for candidate in candidates {
        let key = key(candidate.run);
        match groups.iter_mut().find(|(k, _)| *k == key) {
            Some((_, members)) => members.push(*candidate),
            None => groups.push((key, vec![*candidate])),
        }
    }
    groups
}

/// A run as an answer names it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Choice {
    /// Its index among the runs.
    pub run: usize,
    /// Identifier of the estimator.
    pub estimator: String,
    /// `published` or `corrected`; `None` where the method has no fidelity.
    pub fidelity: Option<String>,
    /// Where it ran.
    pub backend: Backend,
    /// It ran on a software adapter: its times say nothing about a GPU.
    pub software: bool,
    /// The parameters that vary among the estimator's runs considered, fidelity apart.
    pub params: ParamMap,
    /// What a frame takes.
    pub frame: FrameTime,
    /// Its error.
    pub error: Measured,
    /// Options that run it again: the estimator with all its parameters.
    pub options: String,
}

impl Choice {
    /// Names a candidate among those considered.
    pub(super) fn of(candidate: &Candidate<'_>, considered: &[Candidate<'_>]) -> Self {
        let run = candidate.run;
        let others = || {
            let same = |c: &&Candidate<'_>| c.run.estimator == run.estimator;
            considered.iter().filter(same).map(|c| &c.run.params)
        };
        let all = run.params.0.iter();
        let varying = all.filter(|(name, value)| {
            name != FIDELITY && others().any(|p| p.get(name) != Some(value))
        });
        Self {
            run: candidate.index,
            estimator: run.estimator.clone(),
            fidelity: run.fidelity.clone(),
            backend: run.backend,
            software: run.software,
            params: ParamMap(varying.cloned().collect()),
            frame: candidate.time,
            error: candidate.error,
            options: options(run),
        }
    }

    /// Estimator, fidelity and varying parameters, such as `localized_cubemap, corrected, resolution=4`.
    pub fn label(&self) -> String {
        let mut words = vec![self.estimator.clone()];
        words.extend(self.fidelity.clone());
        words.extend(self.params.0.iter().map(|(n, v)| format!("{n}={v}")));
        words.join(", ")
    }
}

/// Defaults may change, and a record does not know them: every parameter is said.
fn options(run: &Run) -> String {
    let id = &run.estimator;
    let mut words = format!("--estimator {id}");
    for (name, value) in &run.params.0 {
        words += &format!(" --set {id}.{name}={value}");
    }
    words
}
