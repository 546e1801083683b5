//! Progress: bars on a terminal, plain lines elsewhere.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::fmt;
use std::io::IsTerminal;

/// A bar on standard error that counts to `length`.
pub(crate) fn bar(what: &'static str, length: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(length), target()).with_message(what);
    match ProgressStyle::with_template("{msg:<40!} {wide_bar} {percent:>3} % {elapsed}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Where there is no terminal for a bar, a line on standard error says what begins.
pub(crate) fn begin(what: fmt::Arguments<'_>) {
    if !std::io::stderr().is_terminal() {
        eprintln!("{what}");
    }
}

fn target() -> ProgressDrawTarget {
    match std::io::stderr().is_terminal() {
        true => ProgressDrawTarget::stderr(),
        false => ProgressDrawTarget::hidden(),
    }
}
