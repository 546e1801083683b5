//! Measures real-time indirect-illumination estimators: bench, render, probe, reference,
//! compare, verify.
//!
//! [`run`] is the whole program: hand it a registry with methods of your own and they get the
//! command line, the comparison and the report.

pub mod campaign;
pub mod cli;
pub mod clock;
mod commands;
pub mod conclude;
pub mod error;
mod footprint;
mod format;
pub mod frames;
mod gallery;
pub mod lab;
pub mod machine;
pub mod measure;
pub mod metrics;
pub mod output;
mod progress;
mod quiet;
pub mod record;
pub mod report;
pub mod reproduce;
pub mod stages;
pub mod table;
pub mod truth;
pub mod view;

use interreflect_estimators::Registry;
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

/// Runs the program with these methods and the process's arguments.
///
/// Exit code 0 on success, 2 on bad usage or input with one line on standard error, 1 on anything
/// else.
pub fn run(registry: Registry) -> ExitCode {
    quiet::restart_without_driver_chatter();
    run_with(registry, std::env::args_os())
}

/// As [`run`], with arguments of the caller's (the program's own name first).
pub fn run_with(registry: Registry, arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let words: Vec<_> = arguments.iter().map(|a| a.to_string_lossy()).collect();
    let words = words.iter().map(AsRef::as_ref);
    // Only a NUL can't be quoted, which no argument holds.
    let command_line = shlex::try_join(words).unwrap_or_default();
    let parsed = cli::expand(arguments).and_then(cli::Cli::parse_arguments);
    let cli = match parsed {
        Ok(cli) => cli,
        Err(cli::Stop::Information(text)) => {
            // A reader that went away has seen enough.
            let _ = std::io::stdout().write_all(text.as_bytes());
            return ExitCode::SUCCESS;
        }
        Err(cli::Stop::Usage(line)) => {
            eprintln!("error: {line}");
            return ExitCode::from(2);
        }
    };
    match commands::run(cli, registry, &command_line) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}
