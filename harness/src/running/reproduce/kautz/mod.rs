//! Kautz, Daubert and Seidel, *Advanced Environment Mapping in VR Applications*.

mod border;
mod dynamic;
mod environments;
mod faces;
mod grid;
mod lines;
mod models;
mod objects;
mod phong;
mod projection;
mod shift;
mod vertices;

use super::Experiment;
use super::experiment_context::ExperimentContext;
use super::scene_setup::SceneSetup;
use crate::running::error::RunError;
use interreflect_estimators::Configured;

/// Texels along a face's edge of the pyramid's base: the paper does not say.
const RESOLUTION: u32 = 256;

/// Pixels along a picture's edge: the paper does not say.
const PIXELS: u32 = 512;

/// A model that reflects part of the light diffusely and part of it mirrored.
const GLOSSY: &[(&str, &str)] = &[("receiver.diffuse", "0.4"), ("receiver.specular", "0.6")];

/// A model that mirrors all light.
const MIRRORING: &[(&str, &str)] = &[("receiver.diffuse", "0"), ("receiver.specular", "1")];

/// A model under an environment.
const fn studio(
    model: &'static [&'static str],
    settings: &'static [(&'static str, &'static str)],
) -> SceneSetup {
    SceneSetup::of("studio")
        .with(model)
        .under("blender_courtyard")
        .set(settings)
}

/// The published pyramid with a bias on the level that pixels call for.
fn biased(
    context: &ExperimentContext<'_>,
    resolution: u32,
    bias: f64,
    f_lambda: f64,
) -> Result<Box<dyn Configured>, RunError> {
    context.method(
        "sh_mip_envmap",
        &[
            ("resolution", &resolution),
            ("lod_mode", &"bias"),
            ("lod", &bias),
            ("f_lambda", &f_lambda),
        ],
    )
}

/// In the order of the paper, then what it does not have.
pub(super) const EXPERIMENTS: &[Experiment] = &[
    models::EXPERIMENT,
    faces::EXPERIMENT,
    phong::EXPERIMENT,
    grid::EXPERIMENT,
    projection::EXPERIMENT,
    vertices::EXPERIMENT,
    shift::EXPERIMENT,
    dynamic::EXPERIMENT,
    objects::EXPERIMENT,
    border::EXPERIMENT,
];
