//! Umenhoffer and Szirmay-Kalos, *Robust Diffuse Final Gathering on the GPU*.

mod cost;
mod object;
mod plane;

use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "umenhoffer.plane",
        paper: Paper::Umenhoffer,
        item: Item::NotInThePaper,
        title: "a plane that faces a wall, ever nearer, M = 4",
        setup: &InCode(plane::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Points spike near a wall.",
                rule: "A trial is a distance, within a quarter of a texel's width, and a backend: the \
                    largest excess over the truth, beyond its noise, is more than the truth's mean.",
            },
            Claim {
                id: "C2",
                says: "Polygons do not.",
                rule: "A trial is a distance, a fidelity and a backend: the largest excess is less than \
                    half of that for points.",
            },
        ],
    },
    Experiment {
        id: "umenhoffer.floor",
        paper: Paper::Umenhoffer,
        item: Item::NotInThePaper,
        title: "a model a centimetre above the floor, beside the reference",
        setup: &InCode(object::run),
        claims: &[Claim {
            id: "C1",
            says: "Of classic mapping, points and polygons, polygons are the nearest to the reference.",
            rule: "A trial is an M, a fidelity, a rival and a backend: polygons' mean squared error \
                against path-traced truth is below that of points and of classic mapping, beyond the \
                reference's noise. Captures hold four reflections; the reference leaves out the \
                model's shadows on itself, which no cube map contains.",
        }],
    },
    Experiment {
        id: "umenhoffer.cost",
        paper: Paper::Umenhoffer,
        item: Item::NotInThePaper,
        title: "what polygons cost beside points and classic mapping",
        setup: &InCode(cost::run),
        claims: &[
            Claim {
                id: "C1",
                says: "Polygons cost more than points, and points more than classic mapping.",
                rule: "A trial is a pair on a backend: shading by polygons takes longer than by points, and \
                    by points longer than by classic mapping, beyond the spread of both.",
            },
            Claim {
                id: "C2",
                says: "Polygons cost less than ten times as much as points.",
                rule: "A trial is a backend: shading, beyond the spread of both. The authors' talk names \
                    60 and 11 frames a second.",
            },
            Claim {
                id: "C3",
                says: "Polygons are interactive.",
                rule: "A trial is a backend: shading by polygons takes less than 100 ms.",
            },
        ],
    },
];
