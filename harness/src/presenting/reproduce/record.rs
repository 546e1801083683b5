//! What a session leaves behind: the JSON contract of `reproduce --json` and `reproduce.json`.

use super::pictures::Shown;
use crate::domain::machine::Machine;
use crate::domain::record::Run;
use crate::presenting::error::PresentError;
use crate::running::error::RunError;
use crate::running::reproduce::{Experiment, Finding, Measure, Paper, Trial, Verdict, conclude};
use serde::Serialize;
use std::path::Path;

/// Everything that one `reproduce` produced.
#[derive(Serialize)]
pub struct Reproduced<'a> {
    /// Where it was measured, and with which build.
    pub machine: Machine,
    /// Whether fewer points, samples and cases were taken.
    pub quick: bool,
    /// Why the GPU's half is missing; `None` if it is there or was not asked for.
    pub gpu_missing: Option<&'a str>,
    /// One record an experiment.
    pub experiments: Vec<&'a Record>,
}

/// An experiment as a file has it.
#[derive(Serialize)]
pub struct Record {
    /// Its name on the command line.
    pub id: &'static str,
    /// The paper.
    pub paper: &'static str,
    /// Its place there.
    pub item: &'static str,
    /// What it is.
    pub title: &'static str,
    /// What the paper claims.
    pub claim: &'static str,
    /// When a trial holds.
    pub rule: &'static str,
    /// What becomes of the claim.
    pub verdict: &'static str,
    /// Why nothing ran or nothing was decided; `None` otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// One sentence from the numbers.
    pub why: String,
    /// Seconds that it took.
    pub seconds: f64,
    /// The command that runs it alone.
    pub command: String,
    /// What stands in for something, and what was left out.
    pub notes: Vec<String>,
    /// The numbers.
    pub measured: Vec<Measure>,
    /// What the verdict follows from.
    pub trials: Vec<Trial>,
    /// What ran.
    pub runs: Vec<Run>,
    /// Folder of the pictures, relative to that of the results; `None` without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pictures: Option<&'static str>,
}

/// An experiment that is over: its record, and its pictures for the page.
pub struct Entry {
    /// What goes into files.
    pub record: Record,
    pub(super) pictures: Vec<Shown>,
    pub(super) paper: Paper,
    pub(super) verdict: Verdict,
    failed: bool,
}

impl Entry {
    /// What came of an experiment; its pictures are written below `out`, if there is a folder.
    ///
    /// # Errors
    /// [`PresentError`] if they can't be written. That the experiment failed is a result.
    pub fn new(
        experiment: &Experiment,
        result: Result<Finding, RunError>,
        (command, seconds): (String, f64),
        out: Option<&Path>,
    ) -> Result<Self, PresentError> {
        let failed = result.is_err();
        let (finding, (verdict, why)) = match result {
            Ok(finding) => {
                let (verdict, mut why) = conclude(&finding.trials);
                if finding.measured.iter().any(|m| m.software) {
                    why += "; times on gpu are a software adapter's";
                }
                (finding, (verdict, why))
            }
            Err(error) => {
                let why = error.to_string();
                (Finding::default(), (Verdict::NotRun(why.clone()), why))
            }
        };
        let mut pictures = Vec::new();
        for row in &finding.pictures {
            if let Some(out) = out {
                row.write(&out.join(experiment.id))?;
            }
            pictures.push(row.shown()?);
        }
        let record = Record {
            id: experiment.id,
            paper: experiment.paper.title(),
            item: experiment.item,
            title: experiment.title,
            claim: experiment.claim,
            rule: experiment.rule,
            verdict: verdict.name(),
            reason: verdict.reason().map(str::to_owned),
            why,
            seconds,
            command,
            notes: finding.notes,
            measured: finding.measured,
            trials: finding.trials,
            runs: finding.runs,
            pictures: (!pictures.is_empty()).then_some(experiment.id),
        };
        Ok(Self {
            record,
            pictures,
            paper: experiment.paper,
            verdict,
            failed,
        })
    }

    /// Why the experiment failed, if it did: not that it decided nothing.
    pub fn failure(&self) -> Option<&str> {
        self.failed.then_some(&self.record.why)
    }

    /// The verdict's words.
    pub fn line(&self) -> String {
        let Record {
            id,
            item,
            verdict,
            why,
            ..
        } = &self.record;
        format!("{id:<24} {item:<9} {verdict:<14} {why}")
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::running::reproduce::experiments;

    #[test]
    fn an_experiment_that_fails_is_not_run_and_one_that_decides_nothing_does_not_fail() {
        let experiment = experiments()[0];
        let entry = |result| Entry::new(&experiment, result, (String::new(), 0.0), None).unwrap();
        let failed = entry(Err(RunError::Usage("no light".into())));
        assert_eq!(failed.failure(), Some("no light"));
        assert_eq!(failed.record.verdict, "not run");
        assert_eq!(failed.record.reason.as_deref(), Some("no light"));
        let open = entry(Ok(Finding::default()));
        assert_eq!(open.failure(), None);
        assert!(open.record.reason.unwrap().starts_with("inconclusive"));
    }
}
