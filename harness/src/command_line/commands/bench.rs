//! `bench`: estimators on scenes, timed and compared with what is true.

use super::concluded::write;
use super::watcher::Watcher;
use super::{failed, print_json, print_line, warn};
use crate::command_line::cli::Bench;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::domain::files::ensure_writable;
use crate::presenting::gallery::Gallery;
use crate::presenting::output::Header;
use crate::presenting::terminal;
use crate::running::campaign::{Campaign, Journal, Plan, Settings, Shard};
use crate::running::context::Context;
use interreflect_estimators::Registry;
use interreflect_scene::library::library;
use std::path::PathBuf;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(
    command: &Bench,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    let what = &command.what;
    let context = Context::new(registry, &what.run.context())?;
    let plan = Plan::new(&context, &scenes(command), &what.selection(), &[])?;
    plan.check_gpu(&context)?.iter().for_each(warn);
    let mut tev = command.tev.connect()?;
    let out = match (&command.out, command.json) {
        (Some(folder), _) => Some(folder.clone()),
        (None, true) => None,
        (None, false) => Some(PathBuf::from(OUT)),
    };
    if let Some(folder) = &out {
        ensure_writable(folder)?;
    }
    let settings = Settings {
        sampling: what.timing.sampling(),
        budget: what.budget.budget(),
        references: None,
        shard: Shard::WHOLE,
        axes: &[],
        concluding: out.is_some(),
        program: String::new(),
        command: &invoked.line,
        invocation: invoked.parts.as_ref(),
    };
    let header = Header::of_program(&invoked.line, &context.machine(), context.seed);
    let gallery = Gallery::new(out.as_deref(), header);
    let mut campaign = Campaign::new(&context, &plan, settings, &gallery, Journal::in_memory());
    campaign.run(&mut Watcher::writing(out.as_deref()))?;
    let results = campaign.results();
    let written = out.map(|folder| write(&results, &folder)).transpose()?;
    if let (Some((report, _)), Some(tev)) = (&written, &mut tev) {
        report.show_in(tev)?;
    }
    if command.json {
        print_json(&results)?;
    } else {
        print_line(&terminal::runs(&results.runs, None))?;
        if let Some((_, page)) = &written {
            print_line(&page.display().to_string())?;
        }
    }
    failed(&campaign.failures, results.runs.len())
}

/// Those that are given, or all of the library's that are small.
fn scenes(command: &Bench) -> Vec<String> {
    if !command.scenes.is_empty() {
        return command.scenes.clone();
    }
    let benched = library().iter().filter(|s| s.benched);
    benched.map(|s| s.name.to_owned()).collect()
}
