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
    after_help = "Every estimator, in each fidelity, is checked against the API contract, the other \
backend, the closed-form answers of its own model and its own claims, these in random scenes. \
Captures and maps are small unless --set says otherwise. A failure reports a shrunk counterexample \
and the command that repeats it; the exit code is then 1.\n\nExamples:\n  interreflect verify\n  \
interreflect verify --estimator polygon_form_factor --backend cpu\n  interreflect verify --estimator \
localized_cubemap --check bounded --cases 200 --json\n  interreflect verify --extremes --out extremes"
)]
pub struct Verify {
    /// Estimator to check; repeatable; default: all
    #[arg(long = "estimator", value_name = "ID")]
    pub estimators: Vec<String>,
    /// Quantity to check; repeatable; default: all that an estimator offers
    #[arg(long = "quantity", value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantities: Vec<Quantity>,
    /// Check to run; repeatable; default: all
    #[arg(long = "check", value_name = "NAME")]
    pub checks: Vec<String>,
    /// Parameter, as `name=value`, or `id.name=value` where several estimators are checked
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backends to check
    #[arg(long, value_enum, default_value = "both")]
    pub backend: Backends,
    /// Random scenes in which each claim is tried
    #[arg(long, value_name = "N", default_value = "8", value_parser = count)]
    pub cases: usize,
    /// Run one scene instead of random ones: the counterexample that a failed check printed
    #[arg(long, value_name = "JSON")]
    pub case: Option<Case>,
    /// Measure instead how far each estimator departs from the same formula in float64 for extreme
    /// scenes, light, points and maps
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
