//! `report`: the page of a folder of results, made again.

use super::print_line;
use crate::command_line::cli::ReportCommand;
use crate::command_line::error::CommandError;
use crate::domain::files::ensure_writable;
use crate::presenting::report::Report;

pub(super) fn run(command: &ReportCommand) -> Result<(), CommandError> {
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
