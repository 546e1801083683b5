//! `interreflect verify`.

use super::options::{Backends, RunOptions};
use super::values::{choice, count, setting};
use crate::running::settings::Setting;
use clap::Args;
use interreflect_conformance::verify::Case;
use interreflect_estimators::Quantity;
use std::path::PathBuf;

/// `interreflect verify`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Every estimator in each fidelity faces the rules of the house, the exact answers \
that its own model has, and its own claims, tried in random worlds. Captures and maps are small \
unless --set says otherwise. A check that fails tells the smallest world in which it does, and the \
command that shows it; the exit code is then 1.\n\nExamples:\n  interreflect verify\n  \
interreflect verify --estimator polygon_form_factor --backend cpu\n  interreflect verify --estimator \
localized_cubemap --check bounded --cases 200 --json\n  interreflect verify --extremes --out extremes"
)]
pub struct Verify {
    /// Estimator to check; repeat for several, all if none is given
    #[arg(long = "estimator", value_name = "ID")]
    pub estimators: Vec<String>,
    /// Quantity to check; repeat for several, all that an estimator offers if none is given
    #[arg(long = "quantity", value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantities: Vec<Quantity>,
    /// Check to carry out; repeat for several, all if none is given
    #[arg(long = "check", value_name = "NAME")]
    pub checks: Vec<String>,
    /// Parameter, as `name=value`, or `id.name=value` where several estimators are checked
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backends to check
    #[arg(long, value_enum, default_value = "both")]
    pub backend: Backends,
    /// Random worlds that each claim is tried in
    #[arg(long, value_name = "N", default_value = "8", value_parser = count)]
    pub cases: usize,
    /// One world instead of random ones, as a failed check tells it
    #[arg(long, value_name = "JSON")]
    pub case: Option<Case>,
    /// Instead of checks: how far each estimator is from the same formula in float64 where scenes,
    /// light, points and maps are at the extremes
    #[arg(long, conflicts_with_all = ["checks", "case", "cases"])]
    pub extremes: bool,
    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,
    /// Print JSON instead of a table
    #[arg(long)]
    pub json: bool,
    /// Folder to write verify.json to; of extremes, extremes.csv and extremes.svg
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
