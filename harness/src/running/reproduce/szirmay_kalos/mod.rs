//! Szirmay-Kalos and Lazányi, *Indirect Diffuse and Glossy Illumination on the GPU*.

mod amortised;
mod models;

use super::{Experiment, Paper};
use models::Reflection::{Diffuse, Specular};

const CLAIM_OF_MODELS: &str = "Localized cube maps of few texels come close to the reference \
    wherever the model stands, classic environment mapping does not. Test: the model in the \
    middle of a coloured room, half-way to a wall and beside it, at M = 2, 4 and 16.";
const RULE_OF_MODELS: &str = "A trial is a place, M and backend: the published map's mean squared \
    error against a path-traced reference is below classic mapping's by more than the reference's \
    noise. The reference leaves out the model's shadows on itself, which neither map has; captures \
    hold four reflections. A specular map is compared up to one factor on its brightness, as is \
    classic mapping, since the paper's lobe is not normalised.";

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "szirmay-kalos.3",
        paper: Paper::SzirmayKalos,
        item: "Figure 3",
        title: "diffuse bunny",
        claim: CLAIM_OF_MODELS,
        rule: RULE_OF_MODELS,
        run: |context| models::run(context, "bunny", &[Diffuse]),
    },
    Experiment {
        id: "szirmay-kalos.6",
        paper: Paper::SzirmayKalos,
        item: "Figure 6",
        title: "specular bunny, shininess 5",
        claim: CLAIM_OF_MODELS,
        rule: RULE_OF_MODELS,
        run: |context| models::run(context, "bunny", &[Specular]),
    },
    Experiment {
        id: "szirmay-kalos.7",
        paper: Paper::SzirmayKalos,
        item: "Figure 7",
        title: "buddha, diffuse and specular",
        claim: CLAIM_OF_MODELS,
        rule: RULE_OF_MODELS,
        run: |context| models::run(context, "buddha", &[Diffuse, Specular]),
    },
    Experiment {
        id: "szirmay-kalos.8",
        paper: Paper::SzirmayKalos,
        item: "Figure 8",
        title: "dragon, diffuse and specular",
        claim: CLAIM_OF_MODELS,
        rule: RULE_OF_MODELS,
        run: |context| models::run(context, "dragon", &[Diffuse, Specular]),
    },
    Experiment {
        id: "szirmay-kalos.amortised",
        paper: Paper::SzirmayKalos,
        item: "§2",
        title: "one cube map for several frames and objects",
        claim: "One cube map serves several objects, or one that moves; it is made again only when \
            the object has moved far.",
        rule: "A trial is a distance moved and a backend: a frame with the reused cube map takes \
            less time than one with a fresh map, beyond the spread of both; and, up to a quarter of the \
            half-width of the room, its mean squared error against the truth is less than twice \
            that of the fresh map, beyond the reference's noise. For two objects: the same, one \
            map between them against a map for each.",
        run: amortised::run,
    },
];
