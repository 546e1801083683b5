//! The Pareto front: the runs that no other beats in both time and error.

use super::candidate::{Candidate, Choice, grouped};
use super::{Metric, Problem};
use crate::domain::record::Run;
use serde::Serialize;

/// The front of one place.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Front {
    /// What is estimated.
    #[serde(flatten)]
    pub problem: Problem,
    /// The runs on the front, fastest first. `rivals` are those inside the noise that could displace it.
    pub members: Vec<Standing>,
    /// Runs beside the front that could belong to it, since none beats them beyond doubt, fastest first.
    /// `rivals` are those that beat them by the numbers.
    pub contenders: Vec<Standing>,
}

/// A run and the doubt about its place.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Standing {
    /// The run.
    pub choice: Choice,
    /// Indices of the runs that make its place uncertain, rising; none for a certain one.
    pub rivals: Vec<usize>,
}

impl Standing {
    /// Whether no noise puts its place in doubt.
    pub fn certain(&self) -> bool {
        self.rivals.is_empty()
    }
}

/// Indices, rising, of the runs that no other run of the same [`Problem`] beats: none is as good in
/// both frame time and relMSE against the truth, and better in one. Runs that tie in both stay; runs that
/// were skipped or lack a number never belong.
pub fn fronts(runs: &[Run]) -> Vec<usize> {
    let fronts = pareto(runs, Metric::Truth);
    let members = fronts.iter().flat_map(|f| &f.members);
    let mut indices: Vec<usize> = members.map(|m| m.choice.run).collect();
    indices.sort_unstable();
    indices
}

/// The front of each place, with what noise leaves in doubt, in the order in which places first appear.
///
/// Runs of all backends are held against each other: hand over one backend's runs for its own front.
pub fn pareto(runs: &[Run], metric: Metric) -> Vec<Front> {
    let candidates = Candidate::all(runs, metric);
    let groups = grouped(&candidates, Problem::of);
    let front = |(problem, mut group): (Problem, Vec<Candidate<'_>>)| {
        group.sort_by(|a, b| a.time.ms.total_cmp(&b.time.ms));
        let (members, others): (Vec<_>, Vec<_>) = group
            .iter()
            .partition(|c| !group.iter().any(|other| other.beats(c)));
        let standing = |c: &Candidate<'_>, rival: &dyn Fn(&Candidate<'_>) -> bool| Standing {
            choice: Choice::of(c, &group),
            rivals: indices(&group, |other| other.index != c.index && rival(other)),
        };
        let in_doubt = others
            .iter()
            .filter(|c| !group.iter().any(|other| other.surely_beats(c)));
        Front {
            problem,
            members: members
                .iter()
                .map(|c| standing(c, &|other| other.may_beat(c)))
                .collect(),
            contenders: in_doubt
                .map(|c| standing(c, &|other| other.beats(c)))
                .collect(),
        }
    };
    groups.into_iter().map(front).collect()
}

fn indices(group: &[Candidate<'_>], keep: impl Fn(&Candidate<'_>) -> bool) -> Vec<usize> {
    let mut kept: Vec<usize> = group.iter().filter(|c| keep(c)).map(|c| c.index).collect();
    kept.sort_unstable();
    kept
}
