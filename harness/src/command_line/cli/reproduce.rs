//! Options of `reproduce`.

use super::{Backends, RunOptions};
use clap::Args;
use std::path::PathBuf;

/// `interreflect reproduce`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Each experiment states the paper's claims and, for each, the rule by which it \
holds, holds in part or does not hold; one without claims is shown. Models are read from assets/ (or $INTERREFLECT_ASSETS); `make assets` \
downloads them.\n\nExamples:\n  interreflect reproduce --list\n  interreflect \
reproduce all --quick --out results\n  interreflect reproduce szirmay-kalos.3 kautz.4\n  \
interreflect reproduce sattler --backend cpu --json"
)]
pub struct Reproduce {
    /// Experiments, papers, or `all`
    #[arg(value_name = "ID", required_unless_present = "list")]
    pub experiments: Vec<String>,

    /// Print the experiments instead of running any
    #[arg(long)]
    pub list: bool,

    /// Use fewer points, samples and cases: all experiments take some ten minutes
    #[arg(long)]
    pub quick: bool,

    /// Which backends to run on
    #[arg(long, value_enum, default_value = "both")]
    pub backend: Backends,

    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,

    /// Print the results as JSON instead of a table
    #[arg(long)]
    pub json: bool,

    /// Folder for reproduce.json, reproduce.html and images
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
