//! Which method, with which parameters, within a time or up to an error.

use super::candidate::{Candidate, Choice, grouped};
use super::{Metric, Problem};
use crate::domain::record::{Backend, Run};
use serde::Serialize;

/// What an answer has to keep to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Budget {
    /// Most milliseconds of a frame.
    pub ms: Option<f64>,
    /// Largest error.
    pub max_error: Option<f64>,
    /// By which error.
    pub metric: Metric,
}

impl Budget {
    fn in_time(&self, c: &Candidate<'_>) -> bool {
        self.ms.is_none_or(|ms| c.time.ms <= ms)
    }

    fn accurate_enough(&self, c: &Candidate<'_>) -> bool {
        self.max_error.is_none_or(|most| c.error.value <= most)
    }

    /// Whether no noise of the candidate's puts in doubt that it keeps to the limits.
    fn surely_holds(&self, c: &Candidate<'_>) -> bool {
        let (slowest, largest) = (c.time.high, c.error.value + c.error.noise);
        self.ms.is_none_or(|ms| slowest <= ms) && self.max_error.is_none_or(|most| largest <= most)
    }

    /// Only an error is limited: the time is to be small. Else the error is.
    fn seeks_time(&self) -> bool {
        self.ms.is_none() && self.max_error.is_some()
    }
}

/// The answer for one place and backend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Advice {
    /// What was asked.
    pub budget: Budget,
    /// What is estimated.
    #[serde(flatten)]
    pub problem: Problem,
    /// Where the runs took place.
    pub backend: Backend,
    /// It was a software adapter: its times say nothing about a GPU.
    pub software: bool,
    /// What to use.
    pub answer: Answer,
}

/// What keeps to the limits, or what comes nearest.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Answer {
    /// Something does.
    Use {
        /// The most accurate run within the time (and up to the error, if both are limited); the fastest
        /// up to the error, if only that is.
        choice: Box<Choice>,
        /// Whether no noise puts in doubt that it keeps to the limits.
        sure: bool,
        /// Other runs within the limits that can't be told apart from it by what is sought, best first.
        alike: Vec<Choice>,
    },
    /// Nothing does. The nearest miss on each side, which can be the same run.
    Nothing {
        /// The most accurate of the runs within the time; the fastest of all, if there is none.
        by_time: Box<Choice>,
        /// The fastest of the runs up to the error; the most accurate of all, if there is none.
        by_error: Box<Choice>,
    },
}

/// Answers for each place and backend, in the order in which they first appear: with a time the
/// most accurate run, with an error the fastest, with both the most accurate that keeps to both, with
/// neither the most accurate of all.
///
/// Backends are kept apart, since the times of a software adapter say nothing about a GPU.
pub fn advise(runs: &[Run], budget: Budget) -> Vec<Advice> {
    let candidates = Candidate::all(runs, budget.metric);
    let key = |r: &Run| (Problem::of(r), r.backend, r.software);
    let advice = |((problem, backend, software), group): (_, Vec<_>)| {
        Some(Advice {
            budget,
            problem,
            backend,
            software,
            answer: answer(&group, &budget)?,
        })
    };
    let groups = grouped(&candidates, key);
    groups.into_iter().filter_map(advice).collect()
}

/// `None` without candidates.
fn answer(group: &[Candidate<'_>], budget: &Budget) -> Option<Answer> {
    let name = |c: &Candidate<'_>| Choice::of(c, group);
    let time = |c: &Candidate<'_>| (c.time.ms, c.error.value);
    let error = |c: &Candidate<'_>| (c.error.value, c.time.ms);
    let in_time = sorted(group, |c| budget.in_time(c), error);
    let accurate_enough = sorted(group, |c| budget.accurate_enough(c), time);
    let both = match budget.seeks_time() {
        true => accurate_enough.clone(),
        false => sorted(&in_time, |c| budget.accurate_enough(c), error),
    };
    let Some((best, others)) = both.split_first() else {
        let fastest = sorted(group, |_| true, time);
        let most_accurate = sorted(group, |_| true, error);
        return Some(Answer::Nothing {
            by_time: Box::new(name(in_time.first().or(fastest.first())?)),
            by_error: Box::new(name(accurate_enough.first().or(most_accurate.first())?)),
        });
    };
    let alike = others.iter().filter(|c| match budget.seeks_time() {
        true => c.time.alike(best.time),
        false => c.error.alike(best.error),
    });
    Some(Answer::Use {
        choice: Box::new(name(best)),
        sure: budget.surely_holds(best),
        alike: alike.map(name).collect(),
    })
}

/// Those that are kept, by rising keys.
fn sorted<'a>(
    group: &[Candidate<'a>],
    keep: impl Fn(&Candidate<'_>) -> bool,
    key: impl Fn(&Candidate<'_>) -> (f64, f64),
) -> Vec<Candidate<'a>> {
    let mut kept: Vec<_> = group.iter().filter(|c| keep(c)).copied().collect();
    kept.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    kept
}
