//! Kautz, Daubert and Seidel, *Advanced Environment Mapping in VR Applications*.

mod border;
mod environments;
mod faces;
mod grid;
mod objects;
mod phong;

use super::scene_setup::SceneSetup;
use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use faces::Faces;

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "kautz.4",
        paper: Paper::Kautz,
        item: Item::Figure(4),
        title: "faces of the cube at a high bias",
        setup: &Faces {
            scene: SceneSetup::of("studio")
                .with(&["sphere"])
                .under("blender_courtyard")
                .set(&[("receiver.diffuse", "0"), ("receiver.specular", "1")]),
            bias: 9.4,
            resolution: 256,
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
    Experiment {
        id: "kautz.phong",
        paper: Paper::Kautz,
        item: Item::NotInThePaper,
        title: "box filter of one level against the Phong filter, N = 225",
        setup: &InCode(phong::run),
        claims: &[
            Claim {
                id: "C1",
                says: "The box filter's pictures look like the Phong filter's.",
                rule: "A trial is an environment and a backend: at the matching level pictures of mirrored \
                    light alone, clipped and encoded as they are shown, differ by less than 5 % of white, \
                    rms.",
            },
            Claim {
                id: "C2",
                says: "It is fast enough for every frame.",
                rule: "A trial is an environment and a backend: preparation takes less than a tenth of the \
                    Phong filter's time, beyond the spread of both.",
            },
        ],
    },
    Experiment {
        id: "kautz.grid",
        paper: Paper::Kautz,
        item: Item::NotInThePaper,
        title: "bias b and Fresnel term f_λ over wide ranges",
        setup: &InCode(grid::run),
        claims: &[
            Claim {
                id: "C1",
                says: "A larger f_λ reflects more.",
                rule: "A trial is a step of f_λ, a b and a backend: the picture is farther from that of \
                    f_λ = 0, rms.",
            },
            Claim {
                id: "C2",
                says: "A larger b is blurrier.",
                rule: "A trial is a step of b, an f_λ and a backend: neighbouring pixels differ less.",
            },
        ],
    },
];
