//! The papers' own experiments, run again: what each claims, what was measured, and a verdict by a
//! rule that is stated beside the claim.
//!
//! An experiment makes a [`Finding`]: numbers, pictures and trials, each of which compares two numbers
//! with their uncertainty. Its [`Verdict`] follows from the trials alone (`verdict.rs`).

mod assets;
mod experiment_context;
mod experiment_scene;
mod finding;
mod frisvad;
mod judge;
mod kautz;
mod measured_run;
mod pictures;
mod sattler;
#[cfg(test)]
mod synthetic;
mod szirmay_kalos;
mod umenhoffer;
mod verdict;

pub use assets::Assets;
pub use experiment_context::ExperimentContext;
pub use finding::{Finding, Measure};
pub use pictures::Row;
pub use verdict::{Amount, Outcome, Trial, Verdict, conclude};

use crate::running::error::RunError;
use interreflect_scene::params::nearest;

/// The papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// Szirmay-Kalos and Lazányi.
    SzirmayKalos,
    /// Kautz, Daubert and Seidel.
    Kautz,
    /// Frisvad, Frisvad, Christensen and Falster.
    Frisvad,
    /// Umenhoffer and Szirmay-Kalos.
    Umenhoffer,
    /// Sattler, Sarlette, Zachmann and Klein.
    Sattler,
}

impl Paper {
    /// All of them, in the order in which they run.
    pub const ALL: [Self; 5] = [
        Self::SzirmayKalos,
        Self::Kautz,
        Self::Frisvad,
        Self::Umenhoffer,
        Self::Sattler,
    ];

    /// What its experiments' ids begin with.
    pub fn id(self) -> &'static str {
        match self {
            Self::SzirmayKalos => "szirmay-kalos",
            Self::Kautz => "kautz",
            Self::Frisvad => "frisvad",
            Self::Umenhoffer => "umenhoffer",
            Self::Sattler => "sattler",
        }
    }

    /// Authors and title.
    pub fn title(self) -> &'static str {
        match self {
            Self::SzirmayKalos => {
                "Szirmay-Kalos and Lazányi: Indirect Diffuse and Glossy Illumination on the GPU"
            }
            Self::Kautz => {
                "Kautz, Daubert and Seidel: Advanced Environment Mapping in VR Applications"
            }
            Self::Frisvad => "Frisvad, Frisvad, Christensen and Falster: Direct Radiance Mapping",
            Self::Umenhoffer => {
                "Umenhoffer and Szirmay-Kalos: Robust Diffuse Final Gathering on the GPU"
            }
            Self::Sattler => {
                "Sattler, Sarlette, Zachmann and Klein: Hardware-accelerated Ambient Occlusion \
                 Computation"
            }
        }
    }
}

/// An experiment of a paper.
#[derive(Clone, Copy, Debug)]
pub struct Experiment {
    /// Name on the command line: the paper's, a point, and the item.
    pub id: &'static str,
    /// Where it is from.
    pub paper: Paper,
    /// Its place there, such as `Figure 3`.
    pub item: &'static str,
    /// What it is, in a few words.
    pub title: &'static str,
    /// The paper's claim, and what it is taken to show where that is not sure.
    pub claim: &'static str,
    /// When a trial of it holds.
    pub rule: &'static str,
    /// Carries it out.
    pub run: fn(&ExperimentContext<'_>) -> Result<Finding, RunError>,
}

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
