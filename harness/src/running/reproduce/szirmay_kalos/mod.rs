//! Szirmay-Kalos and Lazányi, *Indirect Diffuse and Glossy Illumination on the GPU*.

mod amortised;
mod models;

use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use models::Reflection::{Diffuse, Specular};

const OF_MODELS: &[Claim] = &[Claim {
    id: "C1",
    says: "Localized cube maps of few texels are nearer to the reference than classic mapping.",
    rule: "A trial is a place, M and backend: the published map's mean squared \
        error against a path-traced reference is below classic mapping's by more than the reference's \
        noise. The reference leaves out the model's shadows on itself, which neither map has; captures \
        hold four reflections. A specular map is compared up to one factor on its brightness, as is \
        classic mapping, since the paper's lobe is not normalised.",
}];

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "szirmay-kalos.colored-room",
        paper: Paper::SzirmayKalos,
        item: Item::NotInThePaper,
        title: "bunny in a room without a divider",
        setup: &InCode(|context| models::run(context, "bunny", &[Diffuse, Specular])),
        claims: OF_MODELS,
    },
    Experiment {
        id: "szirmay-kalos.moved",
        paper: Paper::SzirmayKalos,
        item: Item::NotInThePaper,
        title: "one cube map for several frames and objects",
        setup: &InCode(amortised::run),
        claims: &[
            Claim {
                id: "C1",
                says: "A reused map saves time.",
                rule: "A trial is a distance moved and a backend: a frame with the reused cube map takes \
                    less time than one with a fresh map, beyond the spread of both. For two objects: the \
                    same, one map between them against a map for each.",
            },
            Claim {
                id: "C2",
                says: "It serves while the object has not moved far.",
                rule: "A trial is a distance up to a quarter of the half-width of the room, or two objects, \
                    and a backend: the mean squared error against the truth is less than twice that of the \
                    fresh map, beyond the reference's noise.",
            },
        ],
    },
];
