//! The command that made results, taken apart, so that others can be made from it.

use serde::{Deserialize, Serialize};

/// A command as it was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Invocation {
    /// The program.
    pub program: String,
    /// What it did: `bench`, `sweep`, `merge`.
    pub verb: String,
    /// Scenes, or the folders of parts that were merged.
    pub operands: Vec<String>,
    /// Options in the order in which they were given.
    pub options: Vec<GivenOption>,
}

/// An option as it was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct GivenOption {
    /// Its name without dashes.
    pub name: String,
    /// Its value; `None` where it takes none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// What it is about.
    pub scope: Scope,
}

/// What an option is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// How every run is made: timing, changes to scenes, precision of references, threads.
    EveryRun,
    /// Which runs are made.
    Selection,
    /// Where results go.
    Output,
}
