//! The papers' own experiments, run again: what each claims, what was measured, and a verdict on each claim by
//! a rule that is stated beside it.
//!
//! An experiment makes a [`Finding`]: numbers, pictures and trials, each of which compares two numbers
//! with their uncertainty and belongs to one claim. A claim's [`Verdict`] follows from its trials alone
//! (`verdict.rs`). What an experiment runs in is data (`setup.rs`), which a test holds against a table of what
//! the papers show (`papers.toml`).

mod assets;
mod experiment;
mod experiment_context;
mod experiment_scene;
mod finding;
mod frisvad;
mod heights;
mod judge;
mod kautz;
mod measured_run;
mod paper;
mod pictures;
mod sattler;
mod scene_setup;
mod setup;
#[cfg(test)]
mod synthetic;
mod szirmay_kalos;
mod umenhoffer;
mod verdict;
mod viewer;

pub use assets::Assets;
pub use experiment::{Claim, Experiment};
pub use experiment_context::ExperimentContext;
pub use finding::{Finding, Measure};
pub use paper::{Item, Paper};
pub use pictures::Row;
pub use verdict::{Amount, Outcome, Trial, Verdict, conclude};

use crate::running::error::RunError;
use interreflect_scene::params::nearest;

/// All experiments, paper by paper.
pub fn experiments() -> Vec<Experiment> {
    [
        szirmay_kalos::EXPERIMENTS,
        kautz::EXPERIMENTS,
        frisvad::EXPERIMENTS,
        umenhoffer::EXPERIMENTS,
        sattler::EXPERIMENTS,
    ]
    .concat()
}

/// What stands for every experiment.
const ALL: &str = "all";

/// The experiments that are meant by these names, each once, in the order in which they run: an
/// experiment's id, a paper's, or `all`.
///
/// # Errors
/// [`RunError::Usage`] if a name is none of these, with the nearest one.
pub fn chosen(names: &[String]) -> Result<Vec<Experiment>, RunError> {
    let all = experiments();
    let known = || {
        let papers = Paper::ALL.iter().map(|paper| paper.id());
        all.iter().map(|e| e.id).chain(papers).chain([ALL])
    };
    for name in names {
        if !known().any(|k| k == name) {
            let near = nearest(name, known());
            let near = near.map_or(String::new(), |n| format!(", did you mean `{n}`?"));
            return Err(RunError::Usage(format!(
                "there is no experiment `{name}`{near}; `interreflect reproduce --list` lists them"
            )));
        }
    }
    let meant = |e: &Experiment| {
        let by = |name: &String| name == ALL || name == e.id || name == e.paper.id();
        names.iter().any(by)
    };
    Ok(all.into_iter().filter(meant).collect())
}

#[cfg(test)]
mod tests;
