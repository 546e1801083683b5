//! `merge`: the parts of a sweep as one.

use super::concluded::conclude;
use crate::command_line::cli::Merge;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::domain::files::{FileError, ensure_writable, write_atomically};
use crate::domain::machine::Machine;
use crate::domain::record::{Results, Run};
use crate::presenting::gallery::{TRUTH, folder_of};
use crate::presenting::output::read_results;
use crate::running::campaign::{Done, Entry, Journal};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

pub(super) fn run(command: &Merge, invoked: &Invoked) -> Result<(), CommandError> {
    let mut parts = Vec::new();
    let mut machines: Vec<Machine> = Vec::new();
    let mut of_first = None;
    for part in &command.parts {
        let (entries, on) = Journal::entries_of(part)?;
        let results = read_results(part)?;
        of_first.get_or_insert((results.machine, results.seed));
        for machine in on {
            if !machines.contains(&machine) {
                machines.push(machine);
            }
        }
        parts.push((part, entries));
    }
    ensure_writable(&command.out)?;
    let mut whole: BTreeMap<(usize, Option<String>), Done> = BTreeMap::new();
    for (part, entries) in parts {
        for Entry { at, mut done, .. } in entries {
            let machine = machine_of(&mut done, machines.len() > 1);
            if let Done::Run(run) = &done {
                copy_images(part, &command.out, run)?;
            }
            whole.entry((at, machine)).or_insert(done);
        }
    }
    let (machine, seed) = of_first.unwrap_or_default();
    let mut results = Results {
        machine,
        seed,
        command: invoked.line.clone(),
        invocation: invoked.parts.clone(),
        ..Results::default()
    };
    results.take(whole.values());
    results.of_machines(&machines);
    conclude(&results, &command.out, command.asked, command.json)
}

/// The machine whose times a result has: what is computed is the same wherever it was. Among `several`, the
/// scene is named with it, so that times of one are never held against another's.
fn machine_of(done: &mut Done, several: bool) -> Option<String> {
    let (Done::Run(run) | Done::Baseline(run)) = done else {
        return None;
    };
    let machine = run.machine.clone();
    if let (true, Some(machine)) = (several, &machine) {
        run.scene += &format!(" on {machine}");
    }
    machine
}

/// The image of a run, and the truth that belongs to it.
fn copy_images(from: &Path, to: &Path, run: &Run) -> Result<(), CommandError> {
    let Some(image) = &run.image else {
        return Ok(());
    };
    let truth = Path::new(image).with_file_name(TRUTH);
    let shown = Path::new(&folder_of(&run.scene, &run.quantity)).join(TRUTH);
    for (old, new) in [(Path::new(image), Path::new(image)), (&truth, &shown)] {
        let (old, new) = (from.join(old), to.join(new));
        if new.exists() {
            continue;
        }
        let bytes = fs::read(&old).map_err(|source| FileError::Read {
            path: old.clone(),
            reason: source.to_string(),
        })?;
        write_atomically(&new, &bytes)?;
    }
    Ok(())
}
