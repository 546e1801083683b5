//! What a session leaves behind: the JSON contract of `reproduce --json` and `reproduce.json`.

use super::pictures::Shown;
use crate::domain::machine::Machine;
use crate::domain::record::Run;
use crate::presenting::error::PresentError;
use crate::running::error::RunError;
use crate::running::reproduce::{Claim, Experiment, Finding, Item, Measure, Paper, Trial, Verdict};
use serde::Serialize;
use serde_json::Value;
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
    pub item: Item,
    /// What it is.
    pub title: &'static str,
    /// The scenes and values that it ran with; `null` where they are no data.
    pub setup: Value,
    /// What is claimed, one by one.
    pub claims: Vec<ClaimRecord>,
    /// What becomes of an experiment without claims: `shown` or `not run`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verdict: Option<&'static str>,
    /// Why an experiment without claims did not run; `None` otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Seconds that it took.
    pub seconds: f64,
    /// The command that runs it alone.
    pub command: String,
    /// What stands in for something, and what was left out.
    pub notes: Vec<String>,
    /// The numbers.
    pub measured: Vec<Measure>,
    /// What ran.
    pub runs: Vec<Run>,
    /// Folder of the pictures, relative to that of the results; `None` without any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pictures: Option<&'static str>,
}

/// A claim as a file has it.
#[derive(Serialize)]
pub struct ClaimRecord {
    /// Its name within the experiment.
    pub id: &'static str,
    /// What is claimed.
    pub says: &'static str,
    /// When a trial holds.
    pub rule: &'static str,
    /// What becomes of it.
    pub verdict: &'static str,
    /// Why nothing was tried; `None` otherwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// One sentence from the numbers.
    pub why: String,
    /// What the verdict follows from.
    pub trials: Vec<Trial>,
}

/// An experiment that is over: its record, and its pictures for the page.
pub struct Entry {
    /// What goes into files.
    pub record: Record,
    pub(super) pictures: Vec<Shown>,
    pub(super) paper: Paper,
    /// A verdict for each claim; one where nothing is claimed.
    pub(super) verdicts: Vec<Verdict>,
    failure: Option<String>,
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
        let (mut finding, error) = match result {
            Ok(finding) => (finding, None),
            Err(error) => (Finding::default(), Some(error.to_string())),
        };
        for claim in experiment.claims {
            if let Some(error) = &error {
                finding.leave_out(claim.id, error.as_str());
            }
        }
        let judged = experiment.claims.iter();
        let judged = judged.map(|claim| judged_claim(experiment, claim, &finding));
        let (mut verdicts, claims): (Vec<Verdict>, Vec<ClaimRecord>) = judged.unzip();
        let whole = claims.is_empty().then(|| match &error {
            Some(error) => Verdict::NotRun(error.clone()),
            None => Verdict::Shown,
        });
        let untried = experiment
            .claims
            .iter()
            .find(|claim| !finding.tries(claim.id));
        let untried = untried.map(|claim| format!("no trial of {}", claim.id));
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
            setup: experiment.described(),
            claims,
            verdict: whole.as_ref().map(Verdict::name),
            reason: whole.as_ref().and_then(Verdict::reason).map(str::to_owned),
            seconds,
            command,
            notes: finding.notes,
            measured: finding.measured,
            runs: finding.runs,
            pictures: (!pictures.is_empty()).then_some(experiment.id),
        };
        verdicts.extend(whole);
        Ok(Self {
            record,
            pictures,
            paper: experiment.paper,
            verdicts,
            failure: error.or(untried),
        })
    }

    /// Why the experiment failed, if it did: not that a claim does not hold, or was left out for a reason.
    pub fn failure(&self) -> Option<&str> {
        self.failure.as_deref()
    }

    /// The verdicts in words: a line for each claim, or one where nothing is claimed.
    pub fn lines(&self) -> Vec<String> {
        let Record { id, claims, .. } = &self.record;
        let line = |claim: &str, verdict: &str, why: &str| {
            let name = format!("{id} {claim}");
            format!("{name:<28} {verdict:<14} {why}")
                .trim_end()
                .to_owned()
        };
        let of = |claim: &ClaimRecord| line(claim.id, claim.verdict, &claim.why);
        let mut lines: Vec<String> = claims.iter().map(of).collect();
        if let Some(verdict) = self.record.verdict {
            let why = self.record.reason.as_deref().unwrap_or(self.record.title);
            lines.push(line("", verdict, why));
        }
        lines
    }
}

fn judged_claim(
    experiment: &Experiment,
    claim: &Claim,
    finding: &Finding,
) -> (Verdict, ClaimRecord) {
    let (verdict, mut why, trials) = experiment.judge(claim, finding);
    let software = finding.measured.iter().any(|m| m.software);
    if software && trials.iter().any(|trial| trial.is_of_times()) {
        why += "; times on gpu are a software adapter's";
    }
    let record = ClaimRecord {
        id: claim.id,
        says: claim.says,
        rule: claim.rule,
        verdict: verdict.name(),
        reason: verdict.reason().map(str::to_owned),
        why,
        trials: trials.into_iter().cloned().collect(),
    };
    (verdict, record)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::domain::record::Backend;
    use crate::running::reproduce::experiments;

    fn entry(experiment: &Experiment, result: Result<Finding, RunError>) -> Entry {
        Entry::new(experiment, result, (String::new(), 0.0), None).unwrap()
    }

    fn two_claims() -> Experiment {
        const CLAIMS: &[Claim] = &[
            Claim {
                id: "C1",
                says: "a is small",
                rule: "below b",
            },
            Claim {
                id: "C2",
                says: "a is dear",
                rule: "above b",
            },
        ];
        Experiment {
            id: "kautz.two",
            claims: CLAIMS,
            ..experiments()[0]
        }
    }

    fn trial(a: f64) -> Trial {
        Trial::less_by("a below b", Backend::Cpu, (a, 2.0), 0.0)
    }

    #[test]
    fn claims_are_judged_one_by_one_by_their_own_trials() {
        let mut finding = Finding::default();
        finding.judge("C1", [trial(1.0)]);
        finding.judge("C2", [trial(3.0), trial(2.0)]);
        let entry = entry(&two_claims(), Ok(finding));
        let verdicts: Vec<_> = entry.record.claims.iter().map(|c| c.verdict).collect();
        assert_eq!(verdicts, ["holds", "does not hold"]);
        assert_eq!(entry.record.claims[1].trials.len(), 2);
        assert_eq!((entry.record.verdict, entry.failure()), (None, None));
        let lines = entry.lines();
        assert!(lines[0].starts_with("kautz.two C1 ") && lines[0].contains(" holds "));
        assert!(lines[1].starts_with("kautz.two C2 ") && lines[1].contains(" does not hold "));
    }

    #[test]
    fn a_claim_may_be_left_out_for_a_reason_but_not_silently() {
        let mut finding = Finding::default();
        finding.judge("C1", [trial(2.0)]);
        finding.leave_out("C2", "no rival");
        let left_out = entry(&two_claims(), Ok(finding));
        assert_eq!(left_out.failure(), None);
        let verdicts: Vec<_> = left_out.record.claims.iter().map(|c| c.verdict).collect();
        assert_eq!(verdicts, ["inconclusive", "not run"]);
        assert_eq!(
            left_out.record.claims[1].reason.as_deref(),
            Some("no rival")
        );
        let mut finding = Finding::default();
        finding.judge("C1", [trial(1.0)]);
        let forgotten = entry(&two_claims(), Ok(finding));
        assert_eq!(forgotten.failure(), Some("no trial of C2"));
        assert_eq!(forgotten.record.claims[1].verdict, "not run");
    }

    #[test]
    fn an_experiment_that_fails_is_not_run_and_one_without_claims_is_shown() {
        let failed = entry(&two_claims(), Err(RunError::Usage("no light".into())));
        assert_eq!(failed.failure(), Some("no light"));
        assert!(failed.record.claims.iter().all(|c| c.verdict == "not run"));
        let shown = Experiment {
            claims: &[],
            ..two_claims()
        };
        let there = entry(&shown, Ok(Finding::default()));
        assert_eq!(
            (there.record.verdict, there.failure()),
            (Some("shown"), None)
        );
        assert_eq!(there.lines().len(), 1);
        let failed = entry(&shown, Err(RunError::Usage("no light".into())));
        assert_eq!(failed.record.verdict, Some("not run"));
        assert_eq!(failed.record.reason.as_deref(), Some("no light"));
    }
}
