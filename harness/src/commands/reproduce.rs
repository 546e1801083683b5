//! `reproduce`: the papers' own experiments.

use super::{print_json, print_line};
use crate::cli::Reproduce;
use crate::error::HarnessError;
use crate::lab::Lab;
use crate::output::{ensure_writable, write_json};
use crate::progress;
use crate::record::Backend;
use crate::reproduce::{Assets, Desk, Entry, Experiment, Page, Reproduced, chosen, experiments};
use interreflect_estimators::Registry;
use interreflect_gpu::GpuError;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(
    command: &Reproduce,
    registry: Registry,
    command_line: &str,
) -> Result<(), HarnessError> {
    if command.list {
        return list(command.json);
    }
    let chosen = chosen(&command.experiments)?;
    let lab = Lab::new(registry, &command.run)?;
    let out = match (&command.out, command.json) {
        (Some(folder), _) => Some(folder.clone()),
        (None, true) => None,
        (None, false) => Some(PathBuf::from(OUT)),
    };
    if let Some(folder) = &out {
        ensure_writable(folder)?;
    }
    let (backends, gpu_missing) = backends(command, &lab)?;
    let session = Session {
        desk: Desk::new(&lab, backends, Assets::find(), command.quick),
        lab: &lab,
        command,
        command_line,
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
    item: &'static str,
    title: &'static str,
    claim: &'static str,
    rule: &'static str,
}

fn list(json: bool) -> Result<(), HarnessError> {
    let listed = experiments().into_iter().map(|e| Listed {
        id: e.id,
        paper: e.paper.title(),
        item: e.item,
        title: e.title,
        claim: e.claim,
        rule: e.rule,
    });
    if json {
        return print_json(&listed.collect::<Vec<_>>());
    }
    let mut paper = "";
    for e in listed {
        if e.paper != paper {
            paper = e.paper;
            print_line(paper)?;
        }
        print_line(&format!("  {:<24} {:<9} {}", e.id, e.item, e.title))?;
    }
    Ok(())
}

/// The backends that there are, and why the GPU is missing where it was asked for beside the CPU.
fn backends(
    command: &Reproduce,
    lab: &Lab,
) -> Result<(Vec<Backend>, Option<String>), HarnessError> {
    let asked = command.backend.list().to_vec();
    let error = match asked.contains(&Backend::Gpu).then(|| lab.gpu()) {
        Some(Err(error)) => error,
        _ => return Ok((asked, None)),
    };
    if asked == [Backend::Gpu] || matches!(error, GpuError::UnknownAdapter { .. }) {
        return Err(error.into());
    }
    let why = format!("no GPU runs: {error}");
    eprintln!("warning: {why}");
    Ok((vec![Backend::Cpu], Some(why)))
}

struct Session<'a> {
    desk: Desk<'a>,
    lab: &'a Lab,
    command: &'a Reproduce,
    command_line: &'a str,
    gpu_missing: Option<String>,
    out: Option<PathBuf>,
}

impl Session<'_> {
    fn run(&self, chosen: &[Experiment]) -> Result<(), HarnessError> {
        let mut entries = Vec::new();
        let bar = progress::bar("", chosen.len() as u64);
        for experiment in chosen {
            bar.set_message(experiment.id);
            let start = Instant::now();
            let result = (experiment.run)(&self.desk);
            let seconds = start.elapsed().as_secs_f64();
            let about = (self.command_for(experiment.id), seconds);
            let entry = Entry::new(experiment, result, about, self.out.as_deref())?;
            bar.inc(1);
            if !self.command.json {
                bar.suspend(|| print_line(&entry.line()))?;
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
            Some((entry, why)) => Err(HarnessError::Failed {
                failed: failures.len(),
                runs: entries.len(),
                first: format!("{}: {why}", entry.record.id),
            }),
        }
    }

    fn results<'b>(&'b self, entries: &'b [Entry]) -> Reproduced<'b> {
        Reproduced {
            machine: self.lab.machine(),
            quick: self.command.quick,
            gpu_missing: self.gpu_missing.as_deref(),
            experiments: entries.iter().map(|e| &e.record).collect(),
        }
    }

    fn save(&self, entries: &[Entry]) -> Result<(), HarnessError> {
        let Some(folder) = &self.out else {
            return Ok(());
        };
        let results = self.results(entries);
        write_json(&folder.join("reproduce.json"), &results)?;
        Page::new(self.command_line, &results, entries).write(&folder.join("reproduce.html"))
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
