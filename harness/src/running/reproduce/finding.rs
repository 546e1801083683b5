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
    /// What the claim comes down to.
    pub trials: Vec<Trial>,
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

    /// Adds a note, once.
    pub fn note(&mut self, note: impl Into<String>) {
        let note = note.into();
        if !self.notes.contains(&note) {
            self.notes.push(note);
        }
    }
}
