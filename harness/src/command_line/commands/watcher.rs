//! What a command shows of a campaign while it goes on.

use super::warn;
use crate::command_line::progress;
use crate::presenting::output::write_results;
use crate::running::campaign::{Campaign, Observer};
use crate::running::error::RunError;
use crate::running::warning::Warning;
use indicatif::ProgressBar;
use interreflect_estimators::Quantity;
use std::path::Path;

/// Shows a bar for each scene and quantity, and keeps results as they come.
#[derive(Default)]
pub(super) struct Watcher<'a> {
    /// Where all results so far are written to whenever there is a new one.
    folder: Option<&'a Path>,
    bar: Option<ProgressBar>,
}

impl<'a> Watcher<'a> {
    /// One that writes all results so far into a folder, if there is one.
    pub(super) fn writing(folder: Option<&'a Path>) -> Self {
        Self { folder, bar: None }
    }
}

impl Observer for Watcher<'_> {
    fn warn(&mut self, warning: &Warning) {
        warn(warning);
    }

    fn begin(&mut self, scene: &str, quantity: Quantity, tasks: usize) {
        progress::begin(format_args!("{scene}, {}: {tasks} tasks", quantity.name()));
        self.bar = Some(progress::bar("path tracing", tasks as u64));
    }

    fn task(&mut self, label: String) {
        if let Some(bar) = &self.bar {
            bar.set_message(label);
        }
    }

    fn done(&mut self, campaign: &Campaign<'_>) -> Result<(), RunError> {
        if let Some(folder) = self.folder {
            write_results(folder, &campaign.results())?;
        }
        if let Some(bar) = &self.bar {
            bar.inc(1);
        }
        Ok(())
    }

    fn end(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}
