//! `report`: the page of a folder of results, made again.

use super::print_line;
use crate::cli::ReportCommand;
use crate::error::HarnessError;
use crate::output::ensure_writable;
use crate::report::Report;

pub(super) fn run(command: &ReportCommand) -> Result<(), HarnessError> {
    let mut tev = command.tev.connect()?;
    let report = Report::of_folder(&command.folder)?;
    ensure_writable(&command.folder)?;
    let page = command.folder.join("report.html");
    report.write(&page)?;
    if let Some(tev) = &mut tev {
        report.show_in(tev)?;
    }
    print_line(&page.display().to_string())
}
