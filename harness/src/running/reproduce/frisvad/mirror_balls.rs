//! Figure 8: indirect light in mirrors left out, faked, included.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::steps::{BALLS, GRID, Grid, Step, row, take};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_scene::Estimate;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.8",
    paper: Paper::Frisvad,
    item: Item::Figure(8),
    title: "two mirror balls without, with faked and with indirect light",
    setup: &MirrorBalls {
        scene: BALLS,
        grid: GRID,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "The trick costs nothing.",
            rule: "A trial is a backend: a frame with the trick takes less than 1.1 times as long as one \
                without indirect light in mirrors, beyond the spread of both.",
        },
        Claim {
            id: "C2",
            says: "Included light is dearer.",
            rule: "A trial is a backend: a frame with the light included takes longer than with the trick, \
                beyond the spread of both.",
        },
        Claim {
            id: "C3",
            says: "The trick looks nearer to included light than its absence does.",
            rule: "A trial is a backend: over the pixels that differ, the picture with the trick is nearer, in \
                mean squared error, to that with the light included.",
        },
    ],
};

/// Most that the trick may cost beside leaving indirect light out.
const NOTHING: f64 = 1.1;

/// The figure's pictures, (a) to (c).
const PICTURES: [Step; 3] = [
    Step::Eq14WithoutMirrored,
    Step::Eq14MirrorsAsDiffuse,
    Step::Eq14,
];

#[derive(Serialize)]
pub(super) struct MirrorBalls {
    pub(super) scene: SceneSetup,
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl Runs for MirrorBalls {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        finding.note(
            "mirrors are followed by exact rays, where the paper renders a cube map for each curved one",
        );
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        for backend in context.backends() {
            let taken = take(
                context,
                ("mirror balls", &loaded),
                (&PICTURES, self.grid, backend),
                &mut finding,
            )?;
            if let [without, trick, included] = &taken[..] {
                let ms = [without, trick, included].map(|taken| taken.frame_ms);
                let [nothing, dearer] = costs(backend, ms);
                finding.judge("C1", [nothing]);
                finding.judge("C2", [dearer]);
                let images = [without, trick, included].map(|taken| taken.image.to_estimate());
                finding.judge("C3", [nearer(backend, &images)]);
            }
            finding
                .pictures
                .push(row(&format!("mirror balls, {backend}"), taken));
        }
        Ok(finding)
    }
}

/// That the trick costs next to nothing, and included light more than it.
fn costs(backend: Backend, [without, trick, included]: [Amount; 3]) -> [Trial; 2] {
    let cheap = "a frame with the trick below 1.1 times one without indirect light in mirrors, ms";
    let dearer = "a frame with the trick below one with the light included, ms";
    [
        Trial::less(cheap, backend, trick, without.times(NOTHING)),
        Trial::less(dearer, backend, trick, included),
    ]
}

/// That the trick is nearer to the picture with the light included, where mirrors make a difference.
fn nearer(backend: Backend, [without, trick, included]: &[Estimate; 3]) -> Trial {
    let differs = |&i: &usize| without.get(i) != included.get(i) || trick.get(i) != included.get(i);
    let at = (0..included.len()).filter(differs).collect();
    let judge = Judge::at(included, None, at);
    judge.nearer(
        "the trick nearer to included light than nothing",
        backend,
        trick,
        without,
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{flat, signs};
    use super::*;

    #[test]
    fn the_trick_has_to_be_cheap_and_near() {
        let costs = |ms: [f64; 3]| signs(&costs(Backend::Cpu, ms.map(Amount::exact)));
        assert_eq!(costs([10.0, 10.5, 15.0]), "++");
        assert_eq!(costs([10.0, 11.5, 11.0]), "--");
        let nearer = |values: [f32; 3]| signs([&nearer(Backend::Cpu, &values.map(flat))]);
        assert_eq!(
            [nearer([0.0, 0.8, 1.0]), nearer([0.8, 3.0, 1.0])],
            ["+", "-"]
        );
    }
}
