//! `interreflect bench`, and what it shares with `sweep`.

use super::TevOption;
use super::options::{Backends, ReferenceOptions, RunOptions, SceneOptions, TimingOptions};
use super::values::{choice, count, setting};
use crate::running::campaign::Selection;
use crate::running::settings::Setting;
use crate::running::view::Shade;
use clap::Args;
use interreflect_estimators::Quantity;
use std::path::PathBuf;

/// `interreflect bench`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Without SCENE and --estimator: every estimator, fidelity, quantity and \
backend on the small library scenes.\n\nExamples:\n  interreflect bench --out results\n  \
interreflect bench colored-room --receiver bunny.obj --estimator localized_cubemap \
--set fidelity=corrected\n  interreflect bench --backend cpu --json > results.json"
)]
pub struct Bench {
    /// Scenes; default: the small library scenes
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<String>,
    /// What runs, and how.
    #[command(flatten)]
    pub what: What,
    /// Print the results as JSON instead of a table
    #[arg(long)]
    pub json: bool,
    /// Folder for results.json, images and report.html
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Where images are shown while it runs.
    #[command(flatten)]
    pub tev: TevOption,
}

/// What runs on the scenes, and how.
#[derive(Clone, Debug, Default, PartialEq, Args)]
pub struct What {
    /// Estimator to run; repeatable; default: all
    #[arg(long = "estimator", value_name = "ID")]
    pub estimators: Vec<String>,
    /// Quantity to estimate; repeatable; default: all that an estimator offers
    #[arg(long = "quantity", value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantities: Vec<Quantity>,
    /// Parameter, as `name=value`, or `id.name=value` where several estimators run; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backends to run on
    #[arg(long, value_enum, default_value = "both")]
    pub backend: Backends,
    /// Number of points on the surfaces that are shaded
    #[arg(long, value_name = "COUNT", value_parser = count)]
    pub points: Option<usize>,
    /// Surfaces to shade: receivers (every surface where there are none), or all
    #[arg(long, value_name = "WHAT", default_value = "receivers", value_parser = choice::<Shade>())]
    pub shade: Shade,
    /// How long each run is timed.
    #[command(flatten)]
    pub timing: TimingOptions,
    /// How precise the references are.
    #[command(flatten)]
    pub budget: ReferenceOptions,
    /// Changes to the scenes.
    #[command(flatten)]
    pub scene: SceneOptions,
    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,
}

impl What {
    /// What runs, as a campaign takes it.
    pub(crate) fn selection(&self) -> Selection {
        Selection {
            estimators: self.estimators.clone(),
            quantities: self.quantities.clone(),
            settings: self.settings.clone(),
            backends: self.backend.list(),
            points: self.points,
            shade: self.shade,
            threads: self.run.threads,
            scene_changes: self.scene.changes(),
        }
    }
}
