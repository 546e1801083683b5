//! The command line as results keep it.

use super::cli::Cli;
use crate::domain::record::{GivenOption, Invocation, Scope};
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, CommandFactory as _};
use std::ffi::OsString;

/// A command line as it was typed, and taken apart.
pub(crate) struct Invoked {
    /// Quoted for a shell.
    pub(crate) line: String,
    /// Its parts; `None` for a line that the parser refuses.
    pub(crate) parts: Option<Invocation>,
}

impl Invoked {
    /// From the program's arguments, its own name first.
    pub(crate) fn new(arguments: &[OsString]) -> Self {
        let words: Vec<_> = arguments.iter().map(|a| a.to_string_lossy()).collect();
        let words = words.iter().map(AsRef::as_ref);
        Self {
            // Only a NUL can't be quoted, which no argument holds.
            line: shlex::try_join(words).unwrap_or_default(),
            parts: taken_apart(arguments),
        }
    }
}

/// Headings of options that hold for every run alike.
const OF_EVERY_RUN: [&str; 4] = ["Timing", "Scene", "Reference", "Run"];

/// Options under no heading that hold for every run alike.
const POINTS: &str = "points";

/// Options that say where results go.
const OF_OUTPUT: [&str; 3] = ["json", "tev", "out"];

fn taken_apart(arguments: &[OsString]) -> Option<Invocation> {
    let cli = Cli::command();
    let matches = cli.clone().try_get_matches_from(arguments).ok()?;
    let (verb, given) = matches.subcommand()?;
    let mut operands = Vec::new();
    let mut options: Vec<(usize, GivenOption)> = Vec::new();
    for arg in cli.find_subcommand(verb)?.get_arguments() {
        let values = values(given, arg);
        match arg.get_long() {
            None => operands.extend(values.into_iter().filter_map(|(_, value)| value)),
            Some(name) => options.extend(values.into_iter().map(|(at, value)| {
                let name = name.to_owned();
                let scope = scope(arg, &name);
                (at, GivenOption { name, value, scope })
            })),
        }
    }
    options.sort_by_key(|(at, _)| *at);
    Some(Invocation {
        program: arguments.first()?.to_string_lossy().into_owned(),
        verb: verb.to_owned(),
        operands,
        options: options.into_iter().map(|(_, option)| option).collect(),
    })
}

/// What was given for an argument, and where.
fn values(given: &ArgMatches, arg: &Arg) -> Vec<(usize, Option<String>)> {
    let id = arg.get_id().as_str();
    if given.value_source(id) != Some(ValueSource::CommandLine) {
        return Vec::new();
    }
    let at = given.indices_of(id).into_iter().flatten();
    let values = given.get_raw(id).into_iter().flatten();
    let text = |value: &std::ffi::OsStr| value.to_string_lossy().into_owned();
    let takes_values = arg.get_action().takes_values();
    at.zip(values)
        .map(|(at, value)| (at, takes_values.then(|| text(value))))
        .collect()
}

fn scope(arg: &Arg, name: &str) -> Scope {
    let heading = arg.get_help_heading();
    if OF_OUTPUT.contains(&name) {
        Scope::Output
    } else if name == POINTS || heading.is_some_and(|h| OF_EVERY_RUN.contains(&h)) {
        Scope::EveryRun
    } else {
        Scope::Selection
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn invocation(line: &str) -> Option<Invocation> {
        let words: Vec<OsString> = line.split_whitespace().map(Into::into).collect();
        taken_apart(&words)
    }

    #[test]
    fn options_keep_their_order_values_and_scope() {
        let line = "interreflect bench room.toml cave --backend=both --set rays=4 --set scene.light=2 \
            --samples 64 --json --tev --estimator texels --points 100 --out results";
        let invocation = invocation(line).expect("a command line");
        assert_eq!(
            (&*invocation.program, &*invocation.verb),
            ("interreflect", "bench")
        );
        assert_eq!(invocation.operands, ["room.toml", "cave"]);
        let options = invocation.options.iter();
        let told: Vec<_> = options
            .filter(|o| o.name != "tev")
            .map(|o| (&*o.name, o.value.as_deref(), o.scope))
            .collect();
        assert_eq!(
            told,
            [
                ("backend", Some("both"), Scope::Selection),
                ("set", Some("rays=4"), Scope::Selection),
                ("set", Some("scene.light=2"), Scope::Selection),
                ("samples", Some("64"), Scope::EveryRun),
                ("json", None, Scope::Output),
                ("estimator", Some("texels"), Scope::Selection),
                ("points", Some("100"), Scope::EveryRun),
                ("out", Some("results"), Scope::Output),
            ]
        );
    }

    #[test]
    fn what_the_parser_refuses_has_no_parts() {
        for line in ["", "interreflect", "interreflect bench --unknown 3"] {
            assert_eq!(invocation(line), None, "{line}");
        }
    }
}
