//! One file a command.

mod bench;
mod compare;
mod concluded;
mod list;
mod merge;
mod probe;
mod reference;
mod render;
mod report;
mod reproduce;
mod rsm;
mod sequence;
mod sweep;
mod verify;
mod watcher;

use crate::command_line::cli::{Cli, Command, RunOptions, SceneOptions, Show};
use crate::command_line::error::CommandError;
use crate::command_line::invocation::Invoked;
use crate::running::context::{Context, GpuUse, remarkable};
use crate::running::settings::Setting;
use crate::running::warning::Warning;
use interreflect_conformance::verify::Check;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Registry};
use interreflect_scene::Scene;

/// Runs a command; what it prints goes to standard output.
///
/// # Errors
/// [`CommandError`], one line that says what is wrong and what to do.
pub(crate) fn run(
    cli: Cli,
    registry: Registry,
    checks: Vec<Check>,
    invoked: &Invoked,
) -> Result<(), CommandError> {
    match cli.command {
        Command::List(command) => list::run(&command, registry),
        Command::Bench(command) => bench::run(&command, registry, invoked),
        Command::Sweep(command) => sweep::run(&command, registry, invoked),
        Command::Merge(command) => merge::run(&command, invoked),
        Command::Render(command) if command.show == Show::Rsm => {
            rsm::run(&command, registry, invoked)
        }
        Command::Render(command) if command.frames.is_some() => sequence::run(&command, registry),
        Command::Render(command) => render::run(&command, registry, invoked),
        Command::Probe(command) => probe::run(&command, registry),
        Command::Reference(command) => reference::run(&command, registry, invoked),
        Command::Compare(command) => compare::run(&command),
        Command::Report(command) => report::run(&command),
        Command::Verify(command) => verify::run(&command, registry, checks),
        Command::Reproduce(command) => reproduce::run(&command, registry, invoked),
    }
}

/// What a command that runs a single method works with: the context, and the method with its settings.
fn with_method(
    registry: Registry,
    run: &RunOptions,
    estimator: &str,
    settings: &[Setting],
) -> Result<(Context, Box<dyn Configured>), CommandError> {
    let context = Context::new(registry, &run.context())?;
    context.check_owners(&[estimator.to_owned()], settings)?;
    let method = context.configure(estimator, settings)?;
    Ok((context, method))
}

/// Opens a scene with its changes on the CPU and, if asked for, on the GPU, and remarks what is strange.
fn load(
    context: &Context,
    (source, options): (&str, &SceneOptions),
    settings: &[Setting],
    gpu: GpuUse,
) -> Result<LoadedScene, CommandError> {
    let loaded = context.load(source, &options.changes(), settings, gpu)?;
    remark_on(loaded.scene());
    Ok(loaded)
}

/// Prints what is strange about a scene, if anything is, on standard error.
fn remark_on(scene: &Scene) {
    if let Some(warning) = remarkable(scene) {
        warn(&warning);
    }
}

/// Prints a remark on standard error.
fn warn(warning: &Warning) {
    eprintln!("warning: {warning}");
}

/// The error that tells of what failed, if anything did.
fn failed(failures: &[String], runs: usize) -> Result<(), CommandError> {
    match failures.first() {
        None => Ok(()),
        Some(first) => Err(CommandError::Failed {
            failed: failures.len(),
            runs,
            first: first.clone(),
        }),
    }
}

/// Prints a value as JSON.
fn print_json(value: &impl serde::Serialize) -> Result<(), CommandError> {
    let text = serde_json::to_string(value).map_err(std::io::Error::from)?;
    print_line(&text)
}

/// Prints a line; a reader that went away ends the program quietly.
fn print_line(text: &str) -> Result<(), CommandError> {
    use std::io::Write;
    match writeln!(std::io::stdout(), "{text}") {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.into()),
        _ => Ok(()),
    }
}
