//! Umenhoffer and Szirmay-Kalos, *Robust Diffuse Final Gathering on the GPU*.

mod cost;
mod object;
mod plane;

use super::{Experiment, Paper};

pub(super) const EXPERIMENTS: &[Experiment] = &[
    Experiment {
        id: "umenhoffer.4",
        paper: Paper::Umenhoffer,
        item: "Figure 4",
        title: "spikes near a wall",
        claim: "Point-to-point form factors spike near a wall, point-to-polygon form factors do \
            not. Test: a plane that faces a wall of a coloured room, ever nearer, M = 4.",
        rule: "A trial is a distance, within a quarter of a texel's width, and a backend: the \
            largest excess over the truth, beyond its noise, is for points more than the truth's \
            mean, and for polygons, published and corrected, less than half of that for points.",
        run: plane::run,
    },
    Experiment {
        id: "umenhoffer.5",
        paper: Paper::Umenhoffer,
        item: "Figure 5",
        title: "an object on the floor, beside the reference",
        claim: "Of classic mapping, point-to-point and point-to-polygon form factors, polygons \
            look most like the reference. Test: a model a centimetre above the floor, M = 4 \
            and 8.",
        rule: "A trial is an M, a fidelity, a rival and a backend: polygons' mean squared error \
            against path-traced truth is below that of points and of classic mapping, beyond the \
            reference's noise. Captures hold four reflections; the reference leaves out the \
            model's shadows on itself, which no cube map contains.",
        run: object::run,
    },
    Experiment {
        id: "umenhoffer.6",
        paper: Paper::Umenhoffer,
        item: "Figure 6",
        title: "frame rates with a more complex object",
        claim: "Polygons cost more than points, and points more than classic mapping, at rates \
            that stay interactive. The authors' talk names 600, 60 and 11 frames a second.",
        rule: "A trial is a pair on a backend: shading by polygons takes longer than by points, \
            and by points longer than by classic mapping, beyond the spread of both; polygons take \
            less than ten times as long as points; and shading by them takes less than 100 ms.",
        run: cost::run,
    },
];
