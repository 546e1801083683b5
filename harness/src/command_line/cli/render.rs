//! The words of `render`.

use super::values::{choice, rate, setting};
use super::{Backends, RunOptions, SceneOptions};
use crate::running::settings::Setting;
use crate::running::view::{Look, Mirrors, ShadedAt};
use clap::Args;
use interreflect_estimators::Quantity;
use interreflect_scene::params::Choice;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// `interreflect render`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(
    after_help = "Examples:\n  interreflect render cornell-box --estimator \
localized_cubemap --width 512 --height 512\n  interreflect render studio --estimator \
classic_envmap --backend gpu --environment sky.hdr --out images\n  interreflect render studio \
--estimator directional_ao --shade-at vertices --frames 30 --set scene.camera.orbit_deg_per_s=20"
)]
pub struct Render {
    /// Library name, .toml or .obj
    #[arg(value_name = "SCENE")]
    pub scene: String,
    /// Estimator to render with
    #[arg(long, value_name = "ID")]
    pub estimator: String,
    /// Quantity to show; reflected light in the scene's own colours if none is given
    #[arg(long, value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantity: Option<Quantity>,
    /// Parameter of the estimator; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backends to run on
    #[arg(long, value_enum, default_value = "cpu")]
    pub backend: Backends,
    /// Width in pixels; the scene's own if not given
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub width: Option<u32>,
    /// Height in pixels; the scene's own if not given
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub height: Option<u32>,
    /// Where the estimator is asked: at each pixel's surface, or at the vertices of the meshes
    #[arg(long = "shade-at", value_name = "WHERE", default_value = "pixels")]
    #[arg(value_parser = choice::<ShadedAt>())]
    pub shaded_at: ShadedAt,
    /// What the image shows: the camera's view, or the pictures from the lights that the estimator takes
    #[arg(long, value_name = "WHAT", default_value = "camera", value_parser = choice::<Show>())]
    pub show: Show,
    /// What mirrors show of indirect light: nothing, their own as if they were diffuse, or that of the
    /// surfaces in them
    #[arg(long, value_name = "WHAT", default_value = "included")]
    #[arg(value_parser = choice::<Mirrors>())]
    pub mirrors: Mirrors,
    /// Number of images of a scene that moves, numbered; a single one of the scene at rest if not given
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: Option<u32>,
    /// Images per second of the scene's time
    #[arg(long, value_name = "RATE", default_value = "30", value_parser = rate)]
    pub fps: f32,
    /// Changes to the scene.
    #[command(flatten)]
    pub scene_options: SceneOptions,
    /// How to run.
    #[command(flatten)]
    pub run: RunOptions,
    /// Print times and file names as JSON
    #[arg(long)]
    pub json: bool,
    /// Folder for the EXR and PNG files
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// What `interreflect render` shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Show {
    /// The scene, as the camera sees it.
    Camera,
    /// The estimator's pictures from the lights.
    LightView,
}

impl Choice for Show {}

impl Render {
    /// How the view is made.
    pub fn look(&self) -> Look {
        Look {
            at: self.shaded_at,
            mirrors: self.mirrors,
        }
    }
}
