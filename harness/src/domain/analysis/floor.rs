//! The floor of each method: the error that more time does not lower.

use super::candidate::{Candidate, Choice, grouped};
use super::{Metric, Problem};
use crate::domain::record::Run;
use serde::Serialize;

/// The least error of a method in one place on one backend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Floor {
    /// What is estimated.
    #[serde(flatten)]
    pub problem: Problem,
    /// The run with the least error.
    pub least: Choice,
    /// The fastest run whose error can't be told apart from it: further time buys nothing.
    pub soonest: Choice,
    /// Whether a slower run than `soonest` was measured. If not, the method may do better still: its floor
    /// is not above the least error, but can be below.
    pub reached: bool,
}

/// The floor of each method, fidelity and backend, by place.
pub fn floors(runs: &[Run], metric: Metric) -> Vec<Floor> {
    let candidates = Candidate::all(runs, metric);
    let key = |r| (Run::label(r), r.backend, r.software);
    let mut floors = Vec::new();
    for (problem, here) in grouped(&candidates, Problem::of) {
        let methods = grouped(&here, key);
        floors.extend(methods.iter().filter_map(|(_, runs)| {
            let least = runs
                .iter()
                .min_by(|a, b| a.error.value.total_cmp(&b.error.value))?;
            let as_good = runs.iter().filter(|c| c.error.alike(least.error));
            let soonest = as_good.min_by(|a, b| a.time.ms.total_cmp(&b.time.ms))?;
            Some(Floor {
                problem: problem.clone(),
                least: Choice::of(least, runs),
                soonest: Choice::of(soonest, runs),
                reached: runs.iter().any(|c| soonest.time.surely_less(c.time)),
            })
        }));
    }
    floors
}
