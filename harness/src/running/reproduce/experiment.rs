//! An experiment: what of a paper it is, in which setup it runs, and what it judges.

use super::experiment_context::ExperimentContext;
use super::finding::Finding;
use super::paper::{Item, Paper};
use super::setup::Setup;
use super::verdict::{Trial, Verdict, conclude};
use crate::running::error::RunError;
use serde_json::Value;

/// Something that a paper says of an item, or that an experiment of no paper asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Claim {
    /// Its name within the experiment: C1, C2 and so on.
    pub id: &'static str,
    /// What is claimed.
    pub says: &'static str,
    /// When a trial of it holds.
    pub rule: &'static str,
}

/// An experiment of a paper.
#[derive(Clone, Copy)]
pub struct Experiment {
    /// Name on the command line: the paper's, a point, and the number of a figure, `table` and its number, or a
    /// name.
    pub id: &'static str,
    /// Where it is from.
    pub paper: Paper,
    /// Its place there.
    pub item: Item,
    /// What it is, in a few words.
    pub title: &'static str,
    /// What it runs in, and how.
    pub setup: &'static dyn Setup,
    /// What is claimed of it; nothing where pictures are shown that no claim is about.
    pub claims: &'static [Claim],
}

impl Experiment {
    /// The scenes and values that it runs with.
    pub fn described(&self) -> Value {
        self.setup.described()
    }

    /// Carries it out.
    ///
    /// # Errors
    /// [`RunError`] if a scene or a method is refused or fails, or if a trial is of a claim that the experiment
    /// does not have.
    pub fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let finding = self.setup.run(context)?;
        let known = |id: &str| self.claims.iter().any(|claim| claim.id == id);
        let unknown = finding.claims().find(|id| !known(id));
        if let Some(id) = unknown {
            return Err(RunError::Usage(format!(
                "{} has a trial of {id}, which it does not claim",
                self.id
            )));
        }
        Ok(finding)
    }

    /// The verdict on a claim, one sentence why, and the trials that it follows from.
    pub fn judge<'f>(
        &self,
        claim: &Claim,
        finding: &'f Finding,
    ) -> (Verdict, String, Vec<&'f Trial>) {
        let trials: Vec<&Trial> = finding.trials_of(claim.id).collect();
        let (verdict, why) = match finding.not_judged(claim.id) {
            Some(reason) if trials.is_empty() => (Verdict::NotRun(reason.into()), reason.into()),
            _ => conclude(&trials),
        };
        (verdict, why, trials)
    }
}
