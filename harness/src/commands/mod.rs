//! One file a command.

mod bench;
mod compare;
mod concluded;
mod light_view;
mod list;
mod merge;
mod probe;
mod reference;
mod render;
mod report;
mod reproduce;
mod sequence;
mod sweep;
mod verify;

pub(crate) use reference::stop as reference_stop;

use crate::cli::{Cli, Command, Show};
use crate::error::HarnessError;
use interreflect_estimators::Registry;

/// Runs a command; what it prints goes to standard output.
///
/// # Errors
/// [`HarnessError`], one line that says what is wrong and what to do.
pub(crate) fn run(cli: Cli, registry: Registry, command_line: &str) -> Result<(), HarnessError> {
    match cli.command {
        Command::List(command) => list::run(&command, registry),
        Command::Bench(command) => bench::run(&command, registry, command_line),
        Command::Sweep(command) => sweep::run(&command, registry, command_line),
        Command::Merge(command) => merge::run(&command, command_line),
        Command::Render(command) if command.show == Show::LightView => {
            light_view::run(&command, registry, command_line)
        }
        Command::Render(command) if command.frames.is_some() => sequence::run(&command, registry),
        Command::Render(command) => render::run(&command, registry, command_line),
        Command::Probe(command) => probe::run(&command, registry),
        Command::Reference(command) => reference::run(&command, registry, command_line),
        Command::Compare(command) => compare::run(&command),
        Command::Report(command) => report::run(&command),
        Command::Verify(command) => verify::run(&command, registry),
        Command::Reproduce(command) => reproduce::run(&command, registry, command_line),
    }
}

/// Prints a value as JSON.
fn print_json(value: &impl serde::Serialize) -> Result<(), HarnessError> {
    let text = serde_json::to_string(value).map_err(std::io::Error::from)?;
    print_line(&text)
}

/// Prints a line; a reader that went away ends the program quietly.
fn print_line(text: &str) -> Result<(), HarnessError> {
    use std::io::Write;
    match writeln!(std::io::stdout(), "{text}") {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}
