//! `interreflect sweep` and `merge`.

use super::bench::What;
use super::values::positive_number;
use crate::running::campaign::{Axis, Shard};
use clap::Args;
use std::path::PathBuf;

/// `interreflect sweep`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    args_override_self = true,
    after_help = "Each --vary of an estimator applies to that estimator alone; two of the same estimator \
are combined, each value with each. A --vary of the scene (`scene.…`) or of the run (`run.points`, \
`run.threads`) is combined with everything. VALUES are a list `2,3,5`, or a range: `2..32:log2` \
doubles, `1..1000:log10` multiplies by ten, `0..1:5` gives five evenly spaced values, `2..6` all whole numbers.\n\n\
Every finished task is written to --out at once; the same command resumes a sweep that was killed.\n\n\
A sweep file has the same options as keys: `scenes = [\"cornell-box\"]`, \
`vary = [\"localized_cubemap.resolution=2..32:log2\"]`, \
`points = 1024`, ….\n\nExamples:\n  \
interreflect sweep cornell-box --vary localized_cubemap.resolution=2..32:log2\n  \
interreflect sweep colored-room --vary polygon_form_factor.fidelity=published,corrected \
--vary scene.receiver.gap=.2,.05,.01 --set scene.receiver.place=wall\n  \
interreflect sweep study.toml --budget-ms 2\n  \
interreflect sweep study.toml --shard 3/8 --out part3    # and then: interreflect merge part* --out all"
)]
pub struct Sweep {
    /// Scenes, or one sweep file (.toml with `scenes`)
    #[arg(value_name = "SCENE", required = true)]
    pub scenes: Vec<String>,
    /// Parameter to vary, as `id.name=VALUES`; repeatable
    #[arg(long, value_name = "NAME=VALUES")]
    pub vary: Vec<Axis>,
    /// What runs, and how.
    #[command(flatten)]
    pub what: What,
    /// Run shard I of N, from 1/N to N/N
    #[arg(long, value_name = "I/N")]
    pub shard: Option<Shard>,
    /// What the records say.
    #[command(flatten)]
    pub asked: Asked,
    /// Print the results as JSON instead of tables
    #[arg(long)]
    pub json: bool,
    /// Folder for records, references, images and report.html
    #[arg(long, value_name = "DIR", default_value = "results/sweep")]
    pub out: PathBuf,
}

/// A question to the records.
#[derive(Clone, Copy, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Advice")]
pub struct Asked {
    /// Recommend the most accurate method within this frame time
    #[arg(long, value_name = "MS", value_parser = positive_number)]
    pub budget_ms: Option<f64>,
    /// Recommend the fastest method within this relMSE against the ground truth
    #[arg(long, value_name = "RELMSE", value_parser = positive_number)]
    pub max_error: Option<f64>,
}

/// `interreflect merge`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Errors are merged; times of different machines stay separate, each with its \
machine.\n\nExample:\n  interreflect merge part1 part2 part3 --out all"
)]
pub struct Merge {
    /// Folders of the shards
    #[arg(value_name = "DIR", required = true)]
    pub parts: Vec<PathBuf>,
    /// What the records say.
    #[command(flatten)]
    pub asked: Asked,
    /// Print the results as JSON instead of tables
    #[arg(long)]
    pub json: bool,
    /// Folder for the merged results
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}
