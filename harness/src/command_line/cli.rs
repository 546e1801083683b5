//! The command line: what can be asked for, and one clear line where it can't.

mod bench;
mod options;
mod render;
mod report;
mod reproduce;
mod sweep;
mod sweep_file;
mod values;
mod verify;

pub use bench::{Bench, What};
pub use options::{Backends, ReferenceOptions, RunOptions, SceneOptions, TimingOptions};
pub use render::{Render, Show};
pub use report::{ReportCommand, TevOption};
pub use reproduce::Reproduce;
pub use sweep::{Asked, Merge, Sweep};
pub use sweep_file::expand;
pub use values::MaterialArg;
pub use verify::Verify;

use crate::domain::record::Backend;
use crate::running::settings::Setting;
use crate::running::view::Shade;
use clap::{Args, Parser, Subcommand, error::ErrorKind};
use interreflect_estimators::Quantity;
use std::{ffi::OsString, path::PathBuf};
use values::{choice, count, material, setting};

/// Measures methods for real-time indirect illumination: time, error against a path-traced ground
/// truth, and error against the value that each method claims to compute.
#[derive(Clone, Debug, PartialEq, Parser)]
#[command(name = "interreflect", version, disable_help_subcommand = true)]
#[command(after_help = EXAMPLES, arg_required_else_help = false)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

const EXAMPLES: &str = "\
SCENE is the name of a library scene (see `interreflect list`), a .toml or an .obj file.

Examples:
  interreflect bench
  interreflect bench cornell-box --estimator localized_cubemap --set resolution=8 --out results
  interreflect sweep cornell-box --vary localized_cubemap.resolution=2..32:log2
  interreflect render studio --estimator classic_envmap --environment sky.hdr --receiver bunny.obj
  interreflect probe room.obj --estimator localized_cubemap --points points.csv --json
  interreflect compare a.exr b.exr
  interreflect verify --estimator polygon_form_factor";

/// The commands.
#[derive(Clone, Debug, PartialEq, Subcommand)]
pub enum Command {
    /// List scenes, estimators with their parameters, and Vulkan adapters
    List(List),
    /// Time estimators on scenes, compare them with their references, write a report
    Bench(Bench),
    /// Vary parameters of estimators, scenes and the run; show cost and error of each setting
    Sweep(Sweep),
    /// Merge the shards of a sweep
    Merge(Merge),
    /// Render an image with one estimator
    Render(Render),
    /// Estimate at the points of a file
    Probe(Probe),
    /// Path-trace the ground truth at points on the receivers
    Reference(ReferenceCommand),
    /// Compare two linear HDR images
    Compare(Compare),
    /// Rebuild the report of a bench from its results and images
    Report(ReportCommand),
    /// Check the API contract, agreement of both backends, closed-form answers and each method's claims
    Verify(Verify),
    /// Repeat the papers' experiments and judge their claims
    Reproduce(Reproduce),
}

/// `interreflect list`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(after_help = "Examples:\n  interreflect list\n  interreflect list --needs --json")]
pub struct List {
    /// Also show the captures that each estimator declares
    #[arg(long)]
    pub needs: bool,
    /// Print how the figure of each estimator's limits is made: id, then arguments of `bench`
    #[arg(long, hide = true)]
    pub figures: bool,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `interreflect probe`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "FILE is a CSV with the columns x,y,z,nx,ny,nz and, for glossy radiance, \
vx,vy,vz; others are ignored.\n\nExamples:\n  interreflect probe room.obj --reference-point \
.2,-.1,.3 --estimator localized_cubemap --set resolution=4 --points room.csv --json\n  \
interreflect probe room.obj --estimator localized_cubemap --backend gpu --quantity \
glossy_radiance --material .5,.5,5 --points room.csv --json"
)]
pub struct Probe {
    /// Library name, .toml or .obj
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Estimator to run
    #[arg(long, value_name = "ID")]
    pub estimator: String,
    /// Points, as CSV
    #[arg(long, value_name = "FILE")]
    pub points: PathBuf,
    /// Quantity to estimate; irradiance where the estimator offers it
    #[arg(long, value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantity: Option<Quantity>,
    /// Material for glossy radiance: diffuse and specular albedo, Blinn-Phong exponent
    #[arg(long, value_name = "KD,KS,SHININESS", allow_hyphen_values = true, value_parser = material)]
    pub material: Option<MaterialArg>,
    /// Parameter of the estimator; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backend to run on
    #[arg(long, value_enum, default_value = "cpu")]
    pub backend: Backend,
    /// Changes to the scene.
    #[command(flatten)]
    pub scene_options: SceneOptions,
    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,
    /// Print JSON instead of a table
    #[arg(long)]
    pub json: bool,
    /// Folder to write the values to
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `interreflect reference`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Sampling stops when the first of --samples, --error and --seconds is \
reached, after a whole round of samples.\n\nExamples:\n  interreflect reference divided-room --error .01 \
--seconds 60\n  interreflect reference cornell-box --points 4096 --samples 1024 --seed 7 --json"
)]
pub struct ReferenceCommand {
    /// Library name, .toml or .obj
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Quantity to path-trace
    #[arg(long, value_name = "QUANTITY", default_value = "irradiance")]
    #[arg(value_parser = choice::<Quantity>())]
    pub quantity: Quantity,
    /// Number of points on the receivers
    #[arg(long, value_name = "COUNT", value_parser = count)]
    pub points: Option<usize>,
    /// Surfaces to shade: receivers (every surface where there are none), or all
    #[arg(long, value_name = "WHAT", default_value = "receivers", value_parser = choice::<Shade>())]
    pub shade: Shade,
    /// Parameter of the path tracer; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// How precise it is.
    #[command(flatten)]
    pub budget: ReferenceOptions,
    /// Changes to the scene.
    #[command(flatten)]
    pub scene_options: SceneOptions,
    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,
    /// Print the values with their standard errors as JSON
    #[arg(long)]
    pub json: bool,
    /// Folder to write the values to
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// `interreflect compare`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(after_help = "Example:\n  interreflect compare estimate.exr reference.exr --out diff")]
pub struct Compare {
    /// Estimate, EXR or HDR
    #[arg(value_name = "A")]
    pub estimate: PathBuf,
    /// Reference image, EXR or HDR
    #[arg(value_name = "B")]
    pub reference: PathBuf,
    /// Standard error of B as an image; if not given, B counts as exact
    #[arg(long, value_name = "FILE")]
    pub standard_error: Option<PathBuf>,
    /// Print JSON instead of a table
    #[arg(long)]
    pub json: bool,
    /// Folder for the map of signed errors
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// A command line that leads nowhere: text to print, where, and the exit code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Help or version was asked for: print to standard output and exit with 0.
    Information(String),
    /// Bad usage: one line for standard error; exit with 2.
    Usage(String),
}

impl Cli {
    /// Reads a command line, whose first argument is the program's name.
    ///
    /// # Errors
    /// [`Stop`] if help was asked for or the usage is bad.
    pub fn parse_arguments<T>(arguments: impl IntoIterator<Item = T>) -> Result<Self, Stop>
    where
        T: Into<OsString> + Clone,
    {
        Self::try_parse_from(arguments).map_err(|error| match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                Stop::Information(error.render().to_string())
            }
            _ => Stop::Usage(one_line(&error.render().to_string())),
        })
    }
}

/// The parser's message without its paragraphs on usage, as one line: the reason, what is near it,
/// and where help is.
fn one_line(message: &str) -> String {
    let reason = message.split("\nUsage:").next().unwrap_or_default();
    let reason = reason
        .split("\nFor more information")
        .next()
        .unwrap_or_default();
    let paragraphs = reason.trim_start_matches("error:").split("\n\n");
    let joined: Vec<String> = paragraphs
        .map(|p| p.split_whitespace().collect::<Vec<_>>().join(" "))
        .filter(|p| !p.is_empty())
        .map(|p| p.strip_prefix("tip: ").map(str::to_owned).unwrap_or(p))
        .collect();
    format!("{}; see --help", joined.join("; "))
}

#[cfg(test)]
mod tests;
