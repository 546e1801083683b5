//! `merge`: the parts of a sweep as one.

use super::concluded::conclude;
use crate::campaign::{Done, Entry, Journal};
use crate::cli::Merge;
use crate::error::HarnessError;
use crate::gallery::{TRUTH, folder_of};
use crate::machine::Machine;
use crate::output::{OutputError, ensure_writable, read_results, write_atomically};
use crate::record::{Results, Run};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

pub(super) fn run(command: &Merge, command_line: &str) -> Result<(), HarnessError> {
    let mut entries: BTreeMap<(usize, Option<String>), Entry> = BTreeMap::new();
    let mut machines: Vec<Machine> = Vec::new();
    let mut of_first = None;
    ensure_writable(&command.out)?;
    for part in &command.parts {
        let (of_part, on) = Journal::entries_of(part)?;
        let results = read_results(part)?;
        of_first.get_or_insert((results.machine, results.seed));
        machines.extend(on.into_iter().filter(|m| !machines.contains(m)).collect::<Vec<_>>());
        for entry in of_part {
            if let Done::Run(run) = &entry.done {
                copy_images(part, &command.out, run)?;
            }
            // What is computed is the same wherever it was; times are of their machine.
            let machine = match &entry.done {
                Done::Run(run) | Done::Baseline(run) => run.machine.clone(),
                Done::Floor(_) | Done::Split(_) => None,
            };
            entries.entry((entry.at, machine)).or_insert(entry);
        }
    }
    let (machine, seed) = of_first.unwrap_or_default();
    let mut results = Results {
        machine,
        seed,
        command: command_line.into(),
        ..Results::default()
    };
    results.take(entries.values().map(|e| &e.done));
    results.of_machines(&machines);
    conclude(&results, &command.out, command.asked, command.json)
}

/// The image of a run and the truth that belongs to it.
fn copy_images(from: &Path, to: &Path, run: &Run) -> Result<(), HarnessError> {
    let Some(image) = &run.image else {
        return Ok(());
    };
    let truth = format!("{}/{TRUTH}", folder_of(&run.scene, &run.quantity));
    for file in [image, &truth] {
        let (from, to) = (from.join(file), to.join(file));
        if to.exists() {
            continue;
        }
        let bytes = fs::read(&from).map_err(|source| OutputError::Read {
            path: from.clone(),
            reason: source.to_string(),
        })?;
        write_atomically(&to, &bytes)?;
    }
    Ok(())
}
