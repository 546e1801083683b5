//! Sattler, Sarlette, Zachmann and Klein, *Hardware-accelerated Ambient Occlusion Computation*.

mod bias;
mod deformed;
mod directions;
mod frame_rate;
mod occluded;
mod sequence;
mod times;

use super::{Experiment, Paper};

const RULE_OF_OCCLUSION: &str = "A trial is a scene, a reference and a backend: irradiance with \
    occlusion by 258 directions, 1,026 unless quick, is nearer to the reference, in mean squared \
    error beyond its noise, than that of the same environment without any, each up to one factor \
    on its brightness, since the paper's sum has no weight. References are path-traced: all light, \
    and environment light alone, occluded by surfaces that reflect nothing.";

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "sattler.4",
        paper: Paper::Sattler,
        item: "Figure 4",
        title: "with and without occlusion",
        claim: "Occlusion by directions gives a model under an environment the shadows that plain \
            environment light lacks.",
        rule: RULE_OF_OCCLUSION,
        run: occluded::one_model,
    },
    Experiment {
        id: "sattler.5",
        paper: Paper::Sattler,
        item: "Figure 5",
        title: "number of directions",
        claim: "More directions come nearer to the true occlusion; a few hundred are enough. Test: \
            openness of a model with 6, 18, 66, 258 and, unless quick, 1,026 directions.",
        rule: "A trial is a step on a backend: with four times as many directions the mean squared \
            error against traced rays falls by more than their noise; and with 258 the difference \
            is less than 5 % rms of the mean.",
        run: directions::run,
    },
    Experiment {
        id: "sattler.6",
        paper: Paper::Sattler,
        item: "Figure 6",
        title: "depth bias, and the lists U and T",
        claim: "A slope-scaled depth bias keeps surfaces from occluding themselves; the lists of \
            unseen triangles (U) and of vertices to evaluate (T) do not change the image. Both are \
            tested.",
        rule: "A trial is a rival or a picture on a backend: with the slope-scaled bias openness \
            is nearer to traced rays, in mean squared error beyond their noise, than with a \
            constant one and with none; and filtering changes the pixels of a turning camera's \
            pictures by less than a thousandth of their mean.",
        run: bias::run,
    },
    Experiment {
        id: "sattler.7",
        paper: Paper::Sattler,
        item: "Figure 7",
        title: "models under environments",
        claim: "Any environment lights a model, occluded. Test: models under several \
            environments, beside the same light without occlusion.",
        rule: RULE_OF_OCCLUSION,
        run: occluded::environments,
    },
    Experiment {
        id: "sattler.8",
        paper: Paper::Sattler,
        item: "Figure 8",
        title: "models that shadow each other",
        claim: "Objects shadow each other and the ground. Test: a model between two others on \
            ground under a sky.",
        rule: RULE_OF_OCCLUSION,
        run: occluded::group,
    },
    Experiment {
        id: "sattler.9",
        paper: Paper::Sattler,
        item: "Figure 9",
        title: "a deforming model",
        claim: "Nothing is computed beforehand: a model may deform, and each frame has its own \
            occlusion.",
        rule: "A trial is a frame on a backend: occlusion that is evaluated anew is nearer to \
            traced rays, in mean squared error beyond their noise, than that of the model at rest, \
            at the vertices that are seen.",
        run: deformed::run,
    },
    Experiment {
        id: "sattler.table1",
        paper: Paper::Sattler,
        item: "Table 1",
        title: "time over directions and vertices",
        claim: "A frame takes longer with more directions and more vertices; filtering saves time; \
            a static model costs less than an animated one.",
        rule: "A trial is a pair of times on a backend, beyond the spread of both: for each model \
            four times as many directions take longer; with the most vertices a frame takes longer \
            than with the fewest; with filtering less time than without; at rest, where only the \
            environment turns, less time than deforming.",
        run: times::run,
    },
    Experiment {
        id: "sattler.frame-rate",
        paper: Paper::Sattler,
        item: "§4.2",
        title: "holding a frame rate",
        claim: "While the model moves the number of directions is lowered so that a frame rate is \
            held; at rest it is refined again.",
        rule: "A trial is a backend: of a rate between what the full level reaches and what one of \
            a sixteenth of its directions does, the controlled median of moving frames, once \
            settled, keeps within 120 %; the uncontrolled one does not; and some frames after the \
            model has come to rest the estimate is that of the full level, within a thousandth of \
            the mean.",
        run: frame_rate::run,
    },
];

/// Directions of a level.
fn directions(level: u32) -> u32 {
    4 * 4_u32.pow(level) + 2
}
