//! Sattler, Sarlette, Zachmann and Klein, *Hardware-accelerated Ambient Occlusion Computation*.

mod bias;
mod deformed;
mod directions;
mod frame_rate;
mod occluded;
mod sequence;
mod times;

use super::scene_setup::SceneSetup;
use super::setup::InCode;
use super::{Claim, Experiment, Item, Paper};
use frame_rate::FrameRate;

const OCCLUDED: &[Claim] = &[
    Claim {
        id: "C1",
        says: "Occlusion by directions brings environment light nearer to all light.",
        rule: "A trial is a scene and a backend: irradiance with occlusion by 258 directions, 1,026 unless \
            quick, is nearer to path-traced truth, in mean squared error beyond its noise, than that of the \
            same environment without any, each up to one factor on its brightness, since the paper's sum has \
            no weight.",
    },
    Claim {
        id: "C2",
        says: "It brings environment light nearer to occluded environment light.",
        rule: "As before, where the reference is environment light alone, occluded by surfaces that reflect \
            nothing.",
    },
];

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "sattler.frame-rate",
        paper: Paper::Sattler,
        item: Item::Section("4.2"),
        title: "holding a frame rate",
        setup: &FrameRate {
            scene: SceneSetup::of("studio")
                .with(&["dragon"])
                .set(&[("receiver.deformation", "wave")]),
        },
        claims: &[
            Claim {
                id: "C1",
                says: "While the model moves fewer directions are taken, so that a frame rate is held.",
                rule: "A trial is a backend and a kind of frame: of a rate between what the full level \
                    reaches and what one of a sixteenth of its directions does, the controlled median of \
                    moving frames, once settled, keeps within 120 %; the uncontrolled one does not.",
            },
            Claim {
                id: "C2",
                says: "At rest the number is raised until the result is exact.",
                rule: "A trial is a backend: some frames after the model has come to rest the estimate is \
                    that of the full level, within a thousandth of the mean.",
            },
        ],
    },
    Experiment {
        id: "sattler.occlusion",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "a bunny under the sky with and without occlusion",
        setup: &InCode(occluded::one_model),
        claims: OCCLUDED,
    },
    Experiment {
        id: "sattler.environments",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "models under environments with and without occlusion",
        setup: &InCode(occluded::environments),
        claims: OCCLUDED,
    },
    Experiment {
        id: "sattler.group",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "a model between two others with and without occlusion",
        setup: &InCode(occluded::group),
        claims: OCCLUDED,
    },
    Experiment {
        id: "sattler.directions",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "openness of a buddha over the number of directions",
        setup: &InCode(directions::run),
        claims: &[
            Claim {
                id: "C1",
                says: "More directions come nearer to the true openness.",
                rule: "A trial is a step from 6 to 18, 66, 258 and, unless quick, 1,026 directions on a \
                    backend: the mean squared error against traced rays falls by more than their noise.",
            },
            Claim {
                id: "C2",
                says: "258 directions are within a twentieth of it.",
                rule: "A trial is a backend: the difference is less than 5 % rms of the mean.",
            },
        ],
    },
    Experiment {
        id: "sattler.bias",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "depth bias, and the lists U and T",
        setup: &InCode(bias::run),
        claims: &[
            Claim {
                id: "C1",
                says: "A slope-scaled depth bias keeps surfaces from occluding themselves.",
                rule: "A trial is a rival on a backend: with the slope-scaled bias openness is nearer to \
                    traced rays, in mean squared error beyond their noise, than with a constant one and \
                    with none.",
            },
            Claim {
                id: "C2",
                says: "The lists of unseen triangles and of vertices to evaluate do not change the picture.",
                rule: "A trial is a backend: filtering changes the pixels of a turning camera's pictures by \
                    less than a thousandth of their mean.",
            },
        ],
    },
    Experiment {
        id: "sattler.deforming",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "a deforming model",
        setup: &InCode(deformed::run),
        claims: &[Claim {
            id: "C1",
            says: "A model may deform, and each frame has its own occlusion.",
            rule: "A trial is a frame on a backend: occlusion that is evaluated anew is nearer to traced \
                rays, in mean squared error beyond their noise, than that of the model at rest, at the \
                vertices that are seen.",
        }],
    },
    Experiment {
        id: "sattler.times",
        paper: Paper::Sattler,
        item: Item::NotInThePaper,
        title: "time over directions and vertices",
        setup: &InCode(times::run),
        claims: &[
            Claim {
                id: "C1",
                says: "More directions take longer.",
                rule: "A trial is a model and a backend: four times as many directions take longer, beyond \
                    the spread of both.",
            },
            Claim {
                id: "C2",
                says: "More vertices take longer.",
                rule: "A trial is a number of directions and a backend: a frame of the most vertices takes \
                    longer than one of the fewest, beyond the spread of both.",
            },
            Claim {
                id: "C3",
                says: "Filtering saves time.",
                rule: "A trial is a model, a number of directions and a backend: less time than without, \
                    beyond the spread of both.",
            },
            Claim {
                id: "C4",
                says: "A resting model costs less than an animated one.",
                rule: "A trial is as before: less time where only the environment turns than where the model \
                    deforms.",
            },
        ],
    },
];

/// Directions of a level.
fn directions(level: u32) -> u32 {
    4 * 4_u32.pow(level) + 2
}
