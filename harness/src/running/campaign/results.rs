//! What tasks gave, sorted.

use super::Done;
use crate::domain::machine::Machine;
use crate::domain::record::Results;

impl Results {
    /// Keeps the machines apart, where there are several.
    pub(crate) fn of_machines(&mut self, machines: &[Machine]) {
        let by_id = machines.iter().map(|m| (m.id(), m.clone()));
        self.machines = by_id.collect();
        if self.machines.len() < 2 {
            self.machines.clear();
        }
    }

    /// Sorts what was done to its kind.
    pub(crate) fn take<'d>(&mut self, done: impl Iterator<Item = &'d Done>) {
        for done in done {
            match done {
                Done::Run(run) => self.runs.push((**run).clone()),
                Done::Baseline(run) => self.baselines.push((**run).clone()),
                Done::Floor(floor) => self.floors.push((**floor).clone()),
                Done::Split(split) => self.splits.push((**split).clone()),
            }
        }
    }
}
