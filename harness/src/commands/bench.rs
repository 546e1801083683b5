//! `bench`: estimators on scenes, timed and compared with what is true.

use super::concluded::write;
use super::{print_json, print_line};
use crate::campaign::{Campaign, Journal, Plan, Settings, Shard};
use crate::cli::Bench;
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::lab::Lab;
use crate::output::{Header, ensure_writable, write_results};
use interreflect_estimators::Registry;
use interreflect_scene::library::library;
use std::path::PathBuf;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(
    command: &Bench,
    registry: Registry,
    command_line: &str,
) -> Result<(), HarnessError> {
    let what = &command.what;
    let lab = Lab::new(registry, &what.run)?;
    let plan = Plan::new(&lab, &scenes(command), what, &[])?;
    plan.check_gpu(&lab)?;
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
        budget: what.budget,
        references: None,
        shard: Shard::WHOLE,
        axes: &[],
        concluding: out.is_some(),
        program: String::new(),
        command_line,
    };
    let header = Header::of_program(command_line, &lab.machine(), lab.seed);
    let gallery = Gallery::new(out.as_deref(), header);
    let mut campaign = Campaign::new(&lab, &plan, settings, gallery, Journal::in_memory());
    campaign.run(|so_far| match &out {
        Some(folder) => Ok(write_results(folder, &so_far.results())?),
        None => Ok(()),
    })?;
    let results = campaign.results();
    let written = out.map(|folder| write(&results, &folder)).transpose()?;
    if let (Some((report, _)), Some(tev)) = (&written, &mut tev) {
        report.show_in(tev)?;
    }
    if command.json {
        print_json(&results)?;
    } else {
        print_line(&crate::table::runs(&results.runs, None))?;
        if let Some((_, page)) = &written {
            print_line(&page.display().to_string())?;
        }
    }
    campaign.failed(&results.runs)
}

/// Those that are given, or all of the library's that are small.
fn scenes(command: &Bench) -> Vec<String> {
    if !command.scenes.is_empty() {
        return command.scenes.clone();
    }
    let benched = library().iter().filter(|s| s.benched);
    benched.map(|s| s.name.to_owned()).collect()
}
