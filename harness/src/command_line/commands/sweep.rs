//! `sweep`: what every setting costs and gives.

use super::concluded::conclude;
use super::watcher::Watcher;
use super::{failed, warn};
use crate::command_line::cli::Sweep;
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::presenting::gallery::Gallery;
use crate::presenting::output::Header;
use crate::running::campaign::{Campaign, Journal, Plan, Settings, Shard, program};
use crate::running::context::Context;
use interreflect_estimators::Registry;

/// Folder of the references within that of the results.
const REFERENCES: &str = "references";

pub(super) fn run(
    command: &Sweep,
    registry: Registry,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    let what = &command.what;
    let context = Context::new(registry, &what.run.context())?;
    let plan = Plan::new(&context, &command.scenes, &what.selection(), &command.vary)?;
    plan.check_gpu(&context)?.iter().for_each(warn);
    let settings = Settings {
        sampling: what.timing.sampling(),
        budget: what.budget.budget(),
        references: Some(command.out.join(REFERENCES)),
        shard: command.shard.unwrap_or(Shard::WHOLE),
        axes: &command.vary,
        concluding: true,
        program: program(),
        command: &invoked.line,
        invocation: invoked.parts.as_ref(),
    };
    let journal = Journal::open(&command.out)?;
    let header = Header::of_program(&invoked.line, &context.machine(), context.seed);
    let gallery = Gallery::new(Some(&command.out), header);
    let mut campaign = Campaign::new(&context, &plan, settings, &gallery, journal);
    campaign.run(&mut Watcher::default())?;
    let others = campaign.journal.others();
    if others > 0 {
        let folder = command.out.display();
        eprintln!(
            "note: {folder} holds {others} results of other sweeps or builds; they are left out"
        );
    }
    let results = campaign.results();
    conclude(&results, &command.out, command.asked, command.json)?;
    failed(&campaign.failures, results.runs.len())
}
