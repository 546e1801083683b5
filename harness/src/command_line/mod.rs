//! The `interreflect` command: what can be asked for, what each command does, what it prints, and its exit
//! code. The highest layer of the harness.

pub mod cli;
mod commands;
pub mod error;
mod invocation;
mod progress;
pub(crate) mod restart;

use interreflect_conformance::verify::Check;
use interreflect_estimators::Registry;
use invocation::Invoked;
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

/// Runs the program with these methods and the process's arguments.
///
/// Exit code 0 on success, 2 on bad usage or input with one line on standard error, 1 on anything
/// else.
pub fn run(registry: Registry) -> ExitCode {
    run_with(registry, Vec::new(), std::env::args_os())
}

/// As [`run`], with further checks for `verify`, and with arguments of the caller's (the program's own
/// name first).
pub fn run_with(
    registry: Registry,
    checks: Vec<Check>,
    arguments: impl IntoIterator<Item = OsString>,
) -> ExitCode {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let invoked = Invoked::new(&arguments);
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
    match commands::run(cli, registry, checks, &invoked) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(error.exit_code())
        }
    }
}
