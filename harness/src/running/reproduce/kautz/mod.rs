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

use super::experiment_context::ExperimentContext;
use super::scene_setup::SceneSetup;
use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use crate::running::error::RunError;
use dynamic::Dynamic;
use faces::Faces;
use grid::Grid;
use interreflect_estimators::Configured;
use models::{Model, Models};
use phong::Filters;
use projection::Projection;
use shift::Shift;
use vertices::Vertices;

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

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "kautz.3",
        paper: Paper::Kautz,
        item: Item::Figure(3),
        title: "three models, each of its own f_λ and b",
        setup: &Models {
            models: [
                Model {
                    scene: studio(&["bunny"], GLOSSY),
                    f_lambda: 0.05,
                    biases: &[2.3],
                },
                Model {
                    scene: studio(&["bust"], GLOSSY),
                    f_lambda: 0.24,
                    biases: &[1.5],
                },
                Model {
                    scene: studio(&["car"], GLOSSY),
                    f_lambda: 0.15,
                    biases: &[0.2, 3.3],
                },
            ],
            pixels: PIXELS,
            resolution: RESOLUTION,
        },
        claims: &[Claim {
            id: "C1",
            says: "All models are shown at more than 100 Hz.",
            rule: "A trial is a model and a backend: preparing the maps and shading all points of the picture \
                takes less than 10 ms, beyond the spread of both. The picture has 512×512 pixels: the paper \
                does not say how many. Times on a software adapter say nothing of a graphics card.",
        }],
    },
    Experiment {
        id: "kautz.4",
        paper: Paper::Kautz,
        item: Item::Figure(4),
        title: "faces of the cube at a high bias",
        setup: &Faces {
            scene: studio(&["sphere"], MIRRORING),
            bias: 9.4,
            resolution: RESOLUTION,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "At a high bias the six faces show.",
                rule: "A trial is a backend: across the cube's edges the published map steps more than three \
                    times as far as inside its faces, over the same angle.",
            },
            Claim {
                id: "C2",
                says: "Filtering across faces avoids it.",
                rule: "A trial is a backend: the map that is filtered across edges steps less than half as far \
                    there as the published one.",
            },
        ],
    },
    Experiment {
        id: "kautz.5",
        paper: Paper::Kautz,
        item: Item::Figure(5),
        title: "box filter beside the Phong filter, N = 225",
        setup: &Filters {
            scene: studio(&["bunny"], MIRRORING),
            exponent: 225.0,
            bias: 2.25,
            resolution: RESOLUTION,
            pixels: PIXELS,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "Differences from the Phong filter are not very noticeable.",
                rule: "A trial is a backend: pictures of mirrored light alone, clipped and encoded as they are \
                    shown, differ by less than 5 % of white, rms.",
            },
            Claim {
                id: "C2",
                says: "The box filter shows some blocks.",
                rule: "A trial is a backend: along lines over the cube's faces the strongest kinks of mirrored \
                    light, changes of slope from step to step over the mean slope, are more than twice those of \
                    the Phong filter on a map of 64² cells a face.",
            },
            Claim {
                id: "C3",
                says: "The box filter is 20 times faster than the two-pass convolution of paraboloid maps.",
                rule: "A trial is a backend: a frame takes less than a twentieth of the time, beyond the spread \
                    of both.",
            },
        ],
    },
    Experiment {
        id: "kautz.6",
        paper: Paper::Kautz,
        item: Item::Figure(6),
        title: "a grid over f_λ and b",
        setup: &Grid {
            scene: studio(&["buddha"], GLOSSY),
            f_lambda: [0.03, 0.09, 0.26, 0.42],
            bias: [0.0, 0.8, 1.7, 2.4],
            resolution: RESOLUTION,
            pixels: PIXELS,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "A larger f_λ is more reflective.",
                rule: "A trial is a step of f_λ, a b and a backend: the picture is farther from that of \
                    f_λ = 0, rms.",
            },
            Claim {
                id: "C2",
                says: "A larger b is blurrier.",
                rule: "A trial is a step of b, an f_λ and a backend: neighbouring pixels differ less, over \
                    their mean, in a picture of the mirrored light alone.",
            },
            Claim {
                id: "C3",
                says: "The frame rate is the same over the grid.",
                rule: "A trial is a picture and a backend: a frame under light that stays takes less than \
                    1.25 times the median over the grid, beyond the spread of both. All pictures' frames \
                    are taken in turns.",
            },
        ],
    },
    Experiment {
        id: "kautz.s5.1.1",
        paper: Paper::Kautz,
        item: Item::Section("5.1.1"),
        title: "size of the map that spherical harmonics are projected from",
        setup: &Projection {
            scenes: [
                SceneSetup::of("studio").with(&["bunny"]),
                SceneSetup::of("studio")
                    .with(&["bunny"])
                    .under("blender_courtyard"),
                SceneSetup::of("studio")
                    .with(&["bunny"])
                    .under("blender_interior"),
            ],
            texels: 8,
            many_texels: 64,
        },
        claims: &[Claim {
            id: "C1",
            says: "8×8 texels a face are enough for accurate harmonics.",
            rule: "A trial is an environment and a backend: irradiance from 8² texels differs from that from \
                64² by less than nine harmonics from 64² differ from the exact convolution, rms.",
        }],
    },
    Experiment {
        id: "kautz.vertices",
        paper: Paper::Kautz,
        item: Item::Section("4.1"),
        title: "diffuse part at vertices or at pixels",
        setup: &Vertices {
            scene: SceneSetup::of("studio")
                .with(&["bunny"])
                .under("blender_courtyard"),
        },
        claims: &[Claim {
            id: "C1",
            says: "The diffuse part need not be evaluated at every pixel: it varies slowly.",
            rule: "A trial is a backend: a picture interpolated from vertices differs from one shaded at \
                pixels by less than that differs from the exact convolution, rms.",
        }],
    },
    Experiment {
        id: "kautz.shift-variance",
        paper: Paper::Kautz,
        item: Item::Section("4.2"),
        title: "the box filter's shape over the sphere",
        setup: &Shift {
            scene: studio(&["bunny"], MIRRORING),
            bias: 2.25,
            resolution: RESOLUTION,
            pixels: PIXELS,
            turned_deg: 45.0,
        },
        claims: &[Claim {
            id: "C1",
            says: "That the filter differs from direction to direction is hardly noticeable.",
            rule: "A trial is a backend: a picture of mirrored light alone, and the same with the cube's faces \
                turned by 45°, clipped and encoded as they are shown, differ by less than 5 % of white, rms.",
        }],
    },
    Experiment {
        id: "kautz.dynamic",
        paper: Paper::Kautz,
        item: Item::Section("7"),
        title: "lighting that changes in every frame",
        setup: &Dynamic {
            scene: studio(
                &["bunny"],
                &[
                    ("receiver.diffuse", "0.4"),
                    ("receiver.specular", "0.6"),
                    ("environment.turn_deg_per_s", "30"),
                ],
            ),
            f_lambda: 0.24,
            bias: 1.5,
            resolution: RESOLUTION,
        },
        claims: &[Claim {
            id: "C1",
            says: "Diffuse and glossy reflections are filtered anew as the lighting changes, interactively.",
            rule: "A trial is a backend: each frame of a session that goes on is that of a new session, within a \
                thousandth of the mean, rms; and a frame, captures included, takes less than 100 ms.",
        }],
    },
    Experiment {
        id: "kautz.harmonics",
        paper: Paper::Kautz,
        item: Item::NotInThePaper,
        title: "nine harmonics against the exact convolution",
        setup: &InCode(objects::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Nine harmonics of 8² texels a face light a diffuse object as the whole environment does.",
                rule: "A trial is an environment and a backend: the irradiance differs from the exact \
                    convolution by less than 5 % rms of its mean.",
            },
            Claim {
                id: "C2",
                says: "Both maps are prepared anew sooner than one is convolved.",
                rule: "A trial is an environment and a backend, beyond the spread of both times.",
            },
        ],
    },
    Experiment {
        id: "kautz.seams",
        paper: Paper::Kautz,
        item: Item::NotInThePaper,
        title: "seams of filtering each face by itself, level by level",
        setup: &InCode(border::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Levels that are filtered face by face show the edges of the cube.",
                rule: "A trial is an environment, level and backend: across the cube's edges the published \
                    map steps more than three times as far as inside its faces, over the same angle.",
            },
            Claim {
                id: "C2",
                says: "Filtering across a border removes them.",
                rule: "A trial is an environment, level and backend: the map that is filtered across edges \
                    steps less than half as far as the published one there.",
            },
        ],
    },
];
