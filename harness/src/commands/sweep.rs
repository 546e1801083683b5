//! `sweep`: what every setting costs and gives.

use super::concluded::conclude;
use crate::campaign::{Campaign, Journal, Plan, Settings, Shard, program};
use crate::cli::Sweep;
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::lab::Lab;
use crate::output::Header;
use interreflect_estimators::Registry;

/// Folder of the references within that of the results.
const REFERENCES: &str = "references";

pub(super) fn run(
    command: &Sweep,
    registry: Registry,
    command_line: &str,
) -> Result<(), HarnessError> {
    let what = &command.what;
    let lab = Lab::new(registry, &what.run)?;
    let plan = Plan::new(&lab, &command.scenes, what, &command.vary)?;
    plan.check_gpu(&lab)?;
    let settings = Settings {
        sampling: what.timing.sampling(),
        budget: what.budget,
        references: Some(command.out.join(REFERENCES)),
        shard: command.shard.unwrap_or(Shard::WHOLE),
        axes: &command.vary,
        concluding: true,
        program: program(),
        command_line,
    };
    let journal = Journal::open(&command.out)?;
    let header = Header::of_program(command_line, &lab.machine(), lab.seed);
    let gallery = Gallery::new(Some(&command.out), header);
    let mut campaign = Campaign::new(&lab, &plan, settings, gallery, journal);
    campaign.run(|_| Ok(()))?;
    let others = campaign.journal.others();
    if others > 0 {
        let folder = command.out.display();
        eprintln!(
            "note: {folder} holds {others} results of other sweeps or builds; they are left out"
        );
    }
    let results = campaign.results();
    conclude(&results, &command.out, command.asked, command.json)?;
    campaign.failed(&results.runs)
}
