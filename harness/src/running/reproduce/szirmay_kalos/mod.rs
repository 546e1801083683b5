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

use super::scene_setup::SceneSetup;
use super::{Claim, Experiment, Item, Paper};
use amortised::Amortised;
use distance::Distance;
use game::Game;
use head::Head;
use left_out::{Left, LeftOut};
use models::Models;
use reflectivity::Reflectivities;
use room::{DIFFUSE, Reflection, SPECULAR, Settings};

/// Texels along a face's edge of the paper's captures.
const CAPTURE: u32 = 256;

/// The figures' room with a model in it.
const fn room(model: &'static [&'static str], settings: Settings) -> SceneSetup {
    SceneSetup::of("colored-room").with(model).set(settings)
}

/// Pictures of a model at several places, by M of a few and of many texels.
const fn pictures(scene: SceneSetup, reflection: Reflection) -> Models {
    Models {
        scene,
        reflection,
        places: &["middle", "halfway", "wall"],
        resolutions: [2, 4, 16],
        capture_resolution: CAPTURE,
        weights: ["shader", "text"],
    }
}

const OF_SPECULAR_MODELS: &[Claim] = &[
    Claim {
        id: "C1",
        says: "Even 2×2 texels are more pleasing than classic mapping.",
        rule: "A trial is a place, solid angles, a measure and a backend: the map of the listing's solid \
            angles (l², which made the pictures) or the text's (l³) is nearer to a path-traced reference than classic mapping, in mean squared \
            error and in mean FLIP, by more than the reference's noise. Each is compared up to one factor on \
            its brightness, since the paper's lobe is not normalised. The reference leaves out the model's \
            shadows on itself; captures hold four reflections.",
    },
    Claim {
        id: "C2",
        says: "They are similar to the map of many texels.",
        rule: "A trial is a place, solid angles and a backend: 2×2 texels differ from 16×16 by less than half of what \
            classic mapping does, root mean square.",
    },
];

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "szirmay-kalos.3",
        paper: Paper::SzirmayKalos,
        item: Item::Figure(3),
        title: "specular buddha under a green ceiling",
        setup: &Head {
            scene: room(
                &["buddha"],
                &[
                    ("ceiling", "green"),
                    ("divider", "0.9"),
                    ("block", "false"),
                    ("reference.place", "room"),
                    ("reference.offset", "0"),
                    ("receiver.place", "ceiling"),
                    ("receiver.size", "0.7"),
                    ("receiver.diffuse", "0"),
                    ("receiver.specular", "0.8"),
                    ("receiver.shininess", "5"),
                ],
            ),
            head: 0.15,
            resolution: 4,
            capture_resolution: CAPTURE,
        },
        claims: &[Claim {
            id: "C1",
            says: "The head should be greenish under the green ceiling, and is not by classic mapping.",
            rule: "The buddha's head is under the ceiling, the reference point in the middle of the room. \
                A trial is one of these on a backend, by the share of green in the light of the head's \
                points: in the reference the head is greener than the lower half; by classic mapping it is \
                less green than in the reference; and the localized map's share is nearer to the \
                reference's than classic mapping's, beyond the reference's noise.",
        }],
    },
    Experiment {
        id: "szirmay-kalos.6",
        paper: Paper::SzirmayKalos,
        item: Item::Figure(6),
        title: "diffuse bunny at several places",
        setup: &pictures(room(&["bunny"], DIFFUSE), Reflection::Diffuse),
        claims: &[
            Claim {
                id: "C1",
                says: "By classic mapping the bunny looks alike everywhere.",
                rule: "A trial is a place and a backend: from the middle of the room to there, irradiance at \
                    the same vertices changes by less than half as much as the reference's, root mean \
                    square.",
            },
            Claim {
                id: "C2",
                says: "Even 2×2 texels are similar to the map of many texels and to the reference.",
                rule: "A trial is a place, M = 2 or 4, solid angles, a rival picture and a backend: a map of \
                    the listing's solid angles (l², which made the pictures) or the text's (l³) differs from \
                    that of 16×16 texels by less than half of what classic mapping does, root mean square; \
                    and it is nearer to a path-traced reference than classic mapping, in mean squared error \
                    beyond the reference's noise. The reference leaves out the model's shadows on itself; captures \
                    hold four reflections.",
            },
        ],
    },
    Experiment {
        id: "szirmay-kalos.7",
        paper: Paper::SzirmayKalos,
        item: Item::Figure(7),
        title: "specular buddha, shininess 5",
        setup: &pictures(room(&["buddha"], SPECULAR), Reflection::Specular),
        claims: OF_SPECULAR_MODELS,
    },
    Experiment {
        id: "szirmay-kalos.8",
        paper: Paper::SzirmayKalos,
        item: Item::Figure(8),
        title: "specular dragon, shininess 5",
        setup: &pictures(room(&["dragon"], SPECULAR), Reflection::Specular),
        claims: OF_SPECULAR_MODELS,
    },
    Experiment {
        id: "szirmay-kalos.9",
        paper: Paper::SzirmayKalos,
        item: Item::Figure(9),
        title: "time of a frame of glossy objects",
        setup: &Game {
            scene: room(
                &["dragon"],
                &[
                    ("ceiling", "green"),
                    ("divider", "0.7"),
                    ("block", "false"),
                    ("reference.place", "room"),
                    ("reference.offset", "0"),
                    ("receivers", "2"),
                    ("receiver.size", "0.5"),
                    ("receiver.diffuse", "0.4"),
                    ("receiver.specular", "0.4"),
                    ("receiver.shininess", "5"),
                ],
            ),
            pixels: 700,
            resolution: 4,
            capture_resolution: CAPTURE,
            frames: 10,
        },
        claims: &[],
    },
    Experiment {
        id: "szirmay-kalos.amortised",
        paper: Paper::SzirmayKalos,
        item: Item::Section("2"),
        title: "one cube map for several frames and objects",
        setup: &Amortised {
            scene: room(
                &["bunny"],
                &[
                    ("ceiling", "green"),
                    ("divider", "0.9"),
                    ("block", "false"),
                    ("reference.offset", "0"),
                    ("receiver.size", "0.5"),
                    ("receiver.diffuse", "0.8"),
                    ("receiver.specular", "0"),
                ],
            ),
            resolution: 4,
            capture_resolution: CAPTURE,
            moved_m: [0.0, 0.125, 0.25, 0.5],
            near_m: 0.25,
            objects: 2,
        },
        claims: &[
            Claim {
                id: "C1",
                says: "One map serves several close objects.",
                rule: "A trial is time or error on a backend: one map between two objects takes less time than \
                    a map in the middle of each that shades its own object's points alone, beyond the \
                    spread of both; and its mean squared error against the truth is less than twice that \
                    of a map each.",
            },
            Claim {
                id: "C2",
                says: "A kept map saves the cost of making it.",
                rule: "A trial is a distance moved and a backend: a frame with the kept map takes less time \
                    than one with a fresh map, beyond the spread of both.",
            },
            Claim {
                id: "C3",
                says: "It has to be made again only when the object has moved far.",
                rule: "A trial is a distance up to a quarter of the half-width of the room, and a backend: the \
                    kept map's mean squared error is less than twice the fresh one's, beyond the \
                    reference's noise.",
            },
        ],
    },
    Experiment {
        id: "szirmay-kalos.distance",
        paper: Paper::SzirmayKalos,
        item: Item::Section("2"),
        title: "error of classic mapping over the distance from the reference point",
        setup: &Distance {
            scene: SceneSetup::of("colored-room").set(&[
                ("ceiling", "green"),
                ("divider", "0.9"),
                ("block", "false"),
                ("reference.place", "room"),
                ("reference.offset", "0"),
                ("receiver.place", "floor"),
                ("receiver.size", "0.01"),
            ]),
            ratios: [0.0, 0.2, 0.4, 0.6, 0.8],
            capture_resolution: CAPTURE,
        },
        claims: &[Claim {
            id: "C1",
            says: "The error grows with the distance from the reference point over that of the walls.",
            rule: "A trial is a step of that ratio on a backend: irradiance towards six sides, at points \
                towards 26 directions, has a larger mean squared error against path-traced truth than at the \
                ratio before, beyond the noise of both.",
        }],
    },
    Experiment {
        id: "szirmay-kalos.hidden",
        paper: Paper::SzirmayKalos,
        item: Item::Section("1"),
        title: "surfaces that the reference point does not see",
        setup: &LeftOut {
            scene: room(
                &["bunny"],
                &[
                    ("ceiling", "green"),
                    ("divider", "0.7"),
                    ("block", "false"),
                    ("reference.place", "room"),
                    ("reference.offset", "0"),
                    ("receiver.size", "0.4"),
                    ("receiver.diffuse", "0.8"),
                    ("receiver.specular", "0"),
                ],
            ),
            left_out: Left::Hidden,
            cases: &[
                ("receiver.moved", "0"),
                ("receiver.moved", "0.3"),
                ("receiver.moved", "0.55"),
            ],
            resolution: 4,
            capture_resolution: CAPTURE,
        },
        claims: &[Claim {
            id: "C1",
            says: "Surfaces that the reference point does not see cause no noticeable error.",
            rule: "The bunny is moved from the reference point past the divider's end, so that it sees what is behind. \
                A trial is a place: light from the surfaces that the reference point sees differs by less \
                than 5 % rms of the mean from all light, the model's shadows on itself left out of both. Or \
                a place and a backend: a map's mean squared error against all light is less than twice that \
                against the light of those surfaces.",
        }],
    },
    Experiment {
        id: "szirmay-kalos.self-shadowing",
        paper: Paper::SzirmayKalos,
        item: Item::Section("1"),
        title: "shadows of indirect light that a model casts on itself",
        setup: &LeftOut {
            scene: room(&["bunny"], DIFFUSE),
            left_out: Left::SelfShadowing,
            cases: &[("receiver.place", "middle"), ("receiver.place", "halfway")],
            resolution: 4,
            capture_resolution: CAPTURE,
        },
        claims: &[Claim {
            id: "C1",
            says: "Shadows of indirect light are not important to the eye.",
            rule: "A trial is a place: light without the model's shadows on itself differs by less than 5 % \
                rms of the mean from all light. Or a place and a backend: a map's mean squared error against \
                all light is less than twice that against light without those shadows.",
        }],
    },
    Experiment {
        id: "szirmay-kalos.reflectivity",
        paper: Paper::SzirmayKalos,
        item: Item::Section("3"),
        title: "average reflectivity by one sample or from a table",
        setup: &Reflectivities {
            scene: room(&["bunny"], SPECULAR),
            reflection: Reflection::Specular,
            resolutions: [2, 4],
            capture_resolution: CAPTURE,
            reflectivities: ["sample", "table"],
        },
        claims: &[Claim {
            id: "C1",
            says: "The average reflectivity is had by one sample or from a table, either way.",
            rule: "A trial is an M and a backend: with one sample the mean squared error against a path-traced \
                reference is less than twice that with the table, each up to one factor on its brightness.",
        }],
    },
];
