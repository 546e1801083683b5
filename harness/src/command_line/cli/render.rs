//! Options of `render`.

use super::values::{choice, rate, setting};
use super::{Backends, RunOptions, SceneOptions};
use crate::running::settings::Setting;
use crate::running::view::{Look, Mirrors, Shade, ShadedAt};
use clap::Args;
use interreflect_estimators::Quantity;
use interreflect_scene::ReflectionLaw;
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
    /// Quantity to show; default: reflected light in the scene's colours
    #[arg(long, value_name = "QUANTITY", value_parser = choice::<Quantity>())]
    pub quantity: Option<Quantity>,
    /// Parameter of the estimator; repeatable
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<Setting>,
    /// Which backends to run on
    #[arg(long, value_enum, default_value = "cpu")]
    pub backend: Backends,
    /// Width in pixels; default: the scene's
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub width: Option<u32>,
    /// Height in pixels; default: the scene's
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=16384))]
    pub height: Option<u32>,
    /// Where the estimator is evaluated: at the surface in each pixel, or at the vertices of the meshes
    #[arg(long = "shade-at", value_name = "WHERE", default_value = "pixels")]
    #[arg(value_parser = choice::<ShadedAt>())]
    pub shaded_at: ShadedAt,
    /// Surfaces to shade: receivers (every surface where there are none), or all
    #[arg(long, value_name = "WHAT", default_value = "receivers", value_parser = choice::<Shade>())]
    pub shade: Shade,
    /// Image to write: the camera's view, or the reflective shadow maps that the estimator uses
    #[arg(long, value_name = "WHAT", default_value = "camera", value_parser = choice::<Show>())]
    pub show: Show,
    /// Indirect light in mirrors: none, that of the mirror as if it were diffuse, or that of the surfaces
    /// seen in it
    #[arg(long, value_name = "WHAT", default_value = "included")]
    #[arg(value_parser = choice::<Mirrors>())]
    pub mirrors: Mirrors,
    /// Direct light by Lambert's law, or by the whole material
    #[arg(long, value_name = "LAW", default_value = "lambert", value_parser = choice::<ReflectionLaw>())]
    pub direct_light: ReflectionLaw,
    /// Number of frames of a moving scene; default: one image of the scene at rest
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: Option<u32>,
    /// Frames per second of scene time
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
    /// The estimator's reflective shadow maps.
    Rsm,
}

impl Choice for Show {}

impl Render {
    /// How the view is made.
    pub fn look(&self) -> Look {
        Look {
            at: self.shaded_at,
            mirrors: self.mirrors,
            shade: self.shade,
        }
    }
}
