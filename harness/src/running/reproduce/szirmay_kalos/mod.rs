//! Szirmay-Kalos and Lazányi, *Indirect Diffuse and Glossy Illumination on the GPU*.

mod alike;
mod amortised;
mod distance;
mod game;
mod head;
mod left_out;
mod models;
mod reflectivity;
mod room;

use super::Experiment;
use super::scene_setup::SceneSetup;
use room::Settings;

/// Texels along a face's edge of the paper's captures.
const CAPTURE: u32 = 256;

/// The figures' room with a model in it.
const fn room(model: &'static [&'static str], settings: Settings) -> SceneSetup {
    SceneSetup::of("colored-room").with(model).set(settings)
}

/// In the order of the paper, then what it does not have.
pub(super) const EXPERIMENTS: &[Experiment] = &[
    head::EXPERIMENT,
    models::FIGURE_6,
    models::FIGURE_7,
    models::FIGURE_8,
    game::EXPERIMENT,
    amortised::EXPERIMENT,
    distance::EXPERIMENT,
    left_out::HIDDEN,
    left_out::SELF_SHADOWING,
    reflectivity::EXPERIMENT,
];
