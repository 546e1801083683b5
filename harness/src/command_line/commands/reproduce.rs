//! `reproduce`: the papers' own experiments.

use super::{print_json, print_line, warn};
use crate::command_line::cli::Reproduce;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::command_line::progress;
use crate::domain::files::{ensure_writable, write_json};
use crate::domain::record::Backend;
use crate::presenting::reproduce::{Entry, Page, Reproduced};
use crate::running::context::Context;
use crate::running::reproduce::{
    Assets, Claim, Experiment, ExperimentContext, Item, chosen, experiments,
};
use crate::running::warning::Warning;
use interreflect_estimators::Registry;
use interreflect_gpu::GpuError;
use serde::Serialize;
use serde_json::Value;
use std::path::PathBuf;
use std::time::Instant;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(
    command: &Reproduce,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    if command.list {
        return list(command.json);
    }
    let chosen = chosen(&command.experiments)?;
    let context = Context::new(registry, &command.run.context())?;
    let out = match (&command.out, command.json) {
        (Some(folder), _) => Some(folder.clone()),
        (None, true) => None,
        (None, false) => Some(PathBuf::from(OUT)),
    };
    if let Some(folder) = &out {
        ensure_writable(folder)?;
    }
    let (backends, gpu_missing) = backends(command, &context)?;
    let session = Session {
        experiments: ExperimentContext::new(&context, backends, Assets::find(), command.quick),
        context: &context,
        command,
        invoked,
        gpu_missing,
        out,
    };
    session.run(&chosen)
}

/// What `--list` tells of an experiment.
#[derive(Serialize)]
struct Listed {
    id: &'static str,
    paper: &'static str,
    item: Item,
    title: &'static str,
    setup: Value,
    claims: Vec<ListedClaim>,
}

#[derive(Serialize)]
struct ListedClaim {
    id: &'static str,
    says: &'static str,
    rule: &'static str,
}

impl From<Experiment> for Listed {
    fn from(experiment: Experiment) -> Self {
        let claim = |claim: &Claim| ListedClaim {
            id: claim.id,
            says: claim.says,
            rule: claim.rule,
        };
        Self {
            id: experiment.id,
            paper: experiment.paper.title(),
            item: experiment.item,
            title: experiment.title,
            setup: experiment.described(),
            claims: experiment.claims.iter().map(claim).collect(),
        }
    }
}

fn list(json: bool) -> Result<(), CommandError> {
    let listed = experiments().into_iter().map(Listed::from);
    if json {
        return print_json(&listed.collect::<Vec<_>>());
    }
    let mut paper = "";
    for e in listed {
        if e.paper != paper {
            paper = e.paper;
            print_line(paper)?;
        }
        print_line(&format!("  {:<24} {:<16} {}", e.id, e.item, e.title))?;
        for claim in e.claims {
            print_line(&format!("    {:<22} {}", claim.id, claim.says))?;
        }
    }
    Ok(())
}

/// The backends that there are, and why the GPU is missing where it was asked for beside the CPU.
fn backends(
    command: &Reproduce,
    context: &Context,
) -> Result<(Vec<Backend>, Option<String>), CommandError> {
    let asked = command.backend.list().to_vec();
    let error = match asked.contains(&Backend::Gpu).then(|| context.gpu()) {
        Some(Err(error)) => error,
        _ => return Ok((asked, None)),
    };
    if asked == [Backend::Gpu] || matches!(error, GpuError::UnknownAdapter { .. }) {
        return Err(error.into());
    }
    let warning = Warning::NoGpu(error);
    warn(&warning);
    Ok((vec![Backend::Cpu], Some(warning.to_string())))
}

struct Session<'a> {
    experiments: ExperimentContext<'a>,
    context: &'a Context,
    command: &'a Reproduce,
    invoked: &'a Invoked,
    gpu_missing: Option<String>,
    out: Option<PathBuf>,
}

impl Session<'_> {
    fn run(&self, chosen: &[Experiment]) -> Result<(), CommandError> {
        let mut entries = Vec::new();
        let bar = progress::bar("", chosen.len() as u64);
        for experiment in chosen {
            bar.set_message(experiment.id);
            let start = Instant::now();
            let result = experiment.run(&self.experiments);
            let seconds = start.elapsed().as_secs_f64();
            let about = (self.command_for(experiment.id), seconds);
            let entry = Entry::new(experiment, result, about, self.out.as_deref())?;
            bar.inc(1);
            if !self.command.json {
                bar.suspend(|| print_line(&entry.lines().join("\n")))?;
            }
            entries.push(entry);
            self.save(&entries)?;
        }
        bar.finish_and_clear();
        if self.command.json {
            print_json(&self.results(&entries))?;
        } else if let Some(folder) = &self.out {
            print_line(&folder.join("reproduce.html").display().to_string())?;
        }
        let failures = entries.iter().filter_map(|e| Some((e, e.failure()?)));
        let failures: Vec<_> = failures.collect();
        match failures.first() {
            None => Ok(()),
            Some((entry, why)) => Err(CommandError::Failed {
                failed: failures.len(),
                runs: entries.len(),
                first: format!("{}: {why}", entry.record.id),
            }),
        }
    }

    fn results<'b>(&'b self, entries: &'b [Entry]) -> Reproduced<'b> {
        Reproduced {
            machine: self.context.machine(),
            quick: self.command.quick,
            gpu_missing: self.gpu_missing.as_deref(),
            experiments: entries.iter().map(|e| &e.record).collect(),
        }
    }

    fn save(&self, entries: &[Entry]) -> Result<(), CommandError> {
        let Some(folder) = &self.out else {
            return Ok(());
        };
        let results = self.results(entries);
        write_json(&folder.join("reproduce.json"), &results)?;
        let page = Page::new(&self.invoked.line, &results, entries);
        Ok(page.write(&folder.join("reproduce.html"))?)
    }

    /// The command that runs an experiment alone, with the same effort on the same backends.
    fn command_for(&self, id: &str) -> String {
        let mut words = format!("interreflect reproduce {id}");
        if self.command.quick {
            words += " --quick";
        }
        match self.command.backend.list() {
            [only] => words + &format!(" --backend {only}"),
            _ => words,
        }
    }
}
