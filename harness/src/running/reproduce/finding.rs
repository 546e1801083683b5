//! What an experiment brings back.

use super::pictures::Row;
use super::verdict::{Amount, Trial};
use crate::domain::record::{Backend, Run};
use serde::Serialize;

/// A measured number.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measure {
    /// In which case: scene, model, parameters. Numbers of one case stand in one line of a table.
    pub case: String,
    /// What was measured.
    pub name: String,
    /// Where it ran.
    pub backend: Backend,
    /// The number.
    pub value: f64,
    /// How far it may be off; `None` where a repeated run gives the same.
    pub spread: Option<f64>,
    /// Its unit, empty for a ratio.
    pub unit: &'static str,
    /// A time of an adapter that runs on the CPU, or a ratio of such times.
    pub software: bool,
}

/// Numbers, trials and pictures of an experiment.
#[derive(Default)]
pub struct Finding {
    /// All numbers.
    pub measured: Vec<Measure>,
    /// What claims come down to, each trial with the claim's id.
    trials: Vec<(&'static str, Trial)>,
    /// Claims that were not judged, and why.
    not_judged: Vec<(&'static str, String)>,
    /// Pictures, rows of those that belong together.
    pub pictures: Vec<Row>,
    /// What ran.
    pub runs: Vec<Run>,
    /// What stands in for something that is not there, and what was left out.
    pub notes: Vec<String>,
}

impl Finding {
    /// Adds a number that is no time.
    pub fn measure(
        &mut self,
        (case, name): (impl Into<String>, impl Into<String>),
        backend: Backend,
        amount: Amount,
        unit: &'static str,
    ) {
        self.measured.push(Measure {
            case: case.into(),
            name: name.into(),
            backend,
            value: amount.value,
            spread: Some(amount.spread).filter(|s| *s > 0.0),
            unit,
            software: false,
        });
    }

    /// Adds a number that follows from times, on a software adapter or not.
    pub fn time(
        &mut self,
        (case, name): (impl Into<String>, impl Into<String>),
        backend: Backend,
        amount: Amount,
        (unit, software): (&'static str, bool),
    ) {
        self.measure((case, name), backend, amount, unit);
        if let Some(last) = self.measured.last_mut() {
            last.software = software;
        }
    }

    /// Adds trials of a claim.
    pub fn judge(&mut self, claim: &'static str, trials: impl IntoIterator<Item = Trial>) {
        self.trials
            .extend(trials.into_iter().map(|trial| (claim, trial)));
    }

    /// Says why a claim has no trials.
    pub fn leave_out(&mut self, claim: &'static str, why: impl Into<String>) {
        self.not_judged.push((claim, why.into()));
    }

    /// The trials of a claim.
    pub fn trials_of<'a>(&'a self, claim: &'a str) -> impl Iterator<Item = &'a Trial> {
        let of_claim = self.trials.iter().filter(move |(id, _)| *id == claim);
        of_claim.map(|(_, trial)| trial)
    }

    /// Why a claim was not judged; `None` where nothing was said.
    pub fn not_judged(&self, claim: &str) -> Option<&str> {
        let mut of_claim = self.not_judged.iter().filter(|(id, _)| *id == claim);
        of_claim.next().map(|(_, why)| why.as_str())
    }

    /// Whether a claim has trials, or a reason why not.
    pub fn tries(&self, claim: &str) -> bool {
        self.claims().any(|id| id == claim)
    }

    /// Ids of the claims that something was found or said about.
    pub fn claims(&self) -> impl Iterator<Item = &'static str> {
        let judged = self.trials.iter().map(|(id, _)| *id);
        judged.chain(self.not_judged.iter().map(|(id, _)| *id))
    }

    /// Adds a note, once.
    pub fn note(&mut self, note: impl Into<String>) {
        let note = note.into();
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }
}
