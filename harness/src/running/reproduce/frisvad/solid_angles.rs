//! The three solid angles beside each other.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::steps::{BOX, GRID, Grid, Step, Taken, row, take};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_scene::Estimate;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.4",
    paper: Paper::Frisvad,
    item: Item::Figure(4),
    title: "the three solid angles",
    setup: &Compared {
        scene: BOX,
        grid: GRID,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "Eq. 15 costs as much as eq. 11.",
            rule: "A trial is a backend: a frame, direct light included, takes less than 1.25 times as long.",
        },
        Claim {
            id: "C2",
            says: "Eq. 14 costs about 2.3 times as much.",
            rule: "A trial is a bound and a backend: a frame by eq. 14 over one by eq. 11 is within a \
                factor of 1.5 of the paper's 2.33, beyond the spread of both.",
        },
        Claim {
            id: "C3",
            says: "Eq. 15 resembles eq. 14 more than eq. 11 does.",
            rule: "A trial is a backend: irradiance by eq. 15 is nearer to that by eq. 14, in mean squared \
                error.",
        },
    ],
};

/// In the figure's order.
pub(super) const EQUATIONS: [Step; 3] = [Step::Eq11, Step::Eq15, Step::Eq14];

/// Most that eq. 15 may cost beside eq. 11 to cost as much.
const AS_MUCH: f64 = 1.25;

/// How many times eq. 11 eq. 14 costs in the paper's table, and how far from it still counts.
const DEARER: f64 = 48.622 / 20.870;
const FACTOR: f64 = 1.5;

/// Figure 4: times and likeness.
#[derive(Serialize)]
pub(super) struct Compared {
    pub(super) scene: SceneSetup,
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl Runs for Compared {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        for backend in context.backends() {
            let what = (&EQUATIONS[..], self.grid, backend);
            let taken = take(context, ("Cornell box", &loaded), what, &mut finding)?;
            if let [eq11, eq15, eq14] = &taken[..] {
                let ms = [eq11, eq15, eq14].map(|taken| taken.frame_ms);
                let [same, least, most] = costs(backend, ms);
                finding.judge("C1", [same]);
                finding.judge("C2", [least, most]);
                finding.judge("C3", [likeness(backend, [eq11, eq15, eq14])]);
            }
            finding
                .pictures
                .push(row(&format!("Cornell box, {backend}"), taken));
        }
        Ok(finding)
    }
}

/// That eq. 15 costs as eq. 11, and eq. 14 about as many times more as in the paper.
fn costs(backend: Backend, [eq11, eq15, eq14]: [Amount; 3]) -> [Trial; 3] {
    let below = |what: &str, a, b| Trial::less(what, backend, a, b);
    let ratio = eq14.over(eq11);
    let bound = |by: f64| Amount::exact(DEARER * by);
    [
        below(
            "a frame of eq. 15 below 1.25 times eq. 11, ms",
            eq15,
            eq11.times(AS_MUCH),
        ),
        below(
            "2.33/1.5 below eq. 14's frame over eq. 11's",
            bound(1.0 / FACTOR),
            ratio,
        )
        .of_times(),
        below(
            "eq. 14's frame over eq. 11's below 2.33·1.5",
            ratio,
            bound(FACTOR),
        )
        .of_times(),
    ]
}

/// That the light by eq. 15 resembles that by eq. 14 more than the light by eq. 11 does.
fn likeness(backend: Backend, [eq11, eq15, eq14]: [&Taken; 3]) -> Trial {
    let all = (0..eq14.irradiance.len()).collect();
    let judge = Judge::at(&eq14.irradiance, None, all);
    judge.nearer(
        "eq. 15 nearer to eq. 14 than eq. 11",
        backend,
        &eq15.irradiance,
        &eq11.irradiance,
    )
}

/// Mean over points and channels.
pub(super) fn brightness(irradiance: &Estimate) -> f64 {
    let sum: f64 = irradiance.iter().map(|v| f64::from(v.element_sum())).sum();
    sum / (3 * irradiance.len().max(1)) as f64
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{of, signs};
    use super::*;

    #[test]
    fn eq_15_may_cost_a_quarter_more_and_eq_14_has_the_papers_ratio() {
        let costs = |ms: [f64; 3]| signs(&costs(Backend::Cpu, ms.map(Amount::exact)));
        assert_eq!(costs([10.0, 12.0, 23.0]), "+++");
        assert_eq!(costs([10.0, 13.0, 15.0]), "--+");
        assert_eq!(costs([10.0, 10.0, 36.0]), "++-");
        assert_eq!(brightness(&of(&[1.0, 3.0])), 2.0);
    }
}
