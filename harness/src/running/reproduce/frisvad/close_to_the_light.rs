//! Figure 7: an object close to the light.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::solid_angles::{EQUATIONS, brightness};
use super::steps::{BOX, GRID, Grid, Step, row, take, view};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.7",
    paper: Paper::Frisvad,
    item: Item::Figure(7),
    title: "an object close to the light",
    setup: &CloseToTheLight {
        scene: SceneSetup::of("cornell-box")
            .with(&["blob"])
            .set(&[("light", "area"), ("receiver.place", "lamp")]),
        without: BOX,
        grid: GRID,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "Eq. 11 overexposes, as one triangle near the light can cover all texels.",
            rule: "A trial is a comparison and a backend: mean irradiance by eq. 11 is more than twice that of \
                path tracing, and more than by eq. 15 and by eq. 14.",
        },
        Claim {
            id: "C2",
            says: "By eq. 11 the light of every surface depends on where all samples fall.",
            rule: "A trial is another equation and a backend: with the object mean irradiance changes by a \
                larger factor by eq. 11.",
        },
    ],
};

/// Times the truth that an overexposed picture has at least.
const OVEREXPOSED: f64 = 2.0;

/// Figure 7: an object close to the light.
#[derive(Serialize)]
pub(super) struct CloseToTheLight {
    pub(super) scene: SceneSetup,
    /// The same scene without the object.
    pub(super) without: SceneSetup,
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl CloseToTheLight {
    /// Mean irradiance by each equation on the surfaces of a scene, pictures on the way.
    fn means(
        &self,
        context: &ExperimentContext<'_>,
        (name, loaded): (&str, &LoadedScene),
        backend: Backend,
        finding: &mut Finding,
    ) -> Result<[f64; 3], RunError> {
        let taken = take(
            context,
            (name, loaded),
            (&EQUATIONS[..], self.grid, backend),
            finding,
        )?;
        let mut means = [0.0; 3];
        for (mean, picture) in means.iter_mut().zip(&taken) {
            *mean = brightness(&picture.irradiance);
            let case = format!("{name}, {}", picture.step.caption());
            let amount = Amount::exact(*mean);
            finding.measure((case, "mean irradiance"), backend, amount, "W/m²");
        }
        finding
            .pictures
            .push(row(&format!("{name}, {backend}"), taken));
        Ok(means)
    }
}

impl Runs for CloseToTheLight {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let close = context.load(&context.place(&self.scene), &mut finding)?;
        let without = context.load(&context.place(&self.without), &mut finding)?;
        let points = view(context, &close, Step::Eq14)?.points(Quantity::Irradiance.layout());
        let mut references = context.references(&close, Quantity::Irradiance, &points);
        let truth = brightness(&references.truth().values);
        for backend in context.backends() {
            let amount = Amount::exact(truth);
            finding.measure(
                ("close to the light, path tracing", "mean irradiance"),
                backend,
                amount,
                "W/m²",
            );
            let name = "close to the light";
            let near = self.means(context, (name, &close), backend, &mut finding)?;
            let far = self.means(context, ("without it", &without), backend, &mut finding)?;
            finding.judge("C1", overexposed(backend, near, truth));
            finding.judge("C2", global(backend, near, far));
        }
        Ok(finding)
    }
}

/// That eq. 11 gives far more light than there is, and the others less than it.
fn overexposed(backend: Backend, [eq11, eq15, eq14]: [f64; 3], truth: f64) -> [Trial; 3] {
    let below = |what: &str, a, b| Trial::less_by(what, backend, (a, b), 0.0);
    [
        below(
            "twice the truth below eq. 11, mean",
            OVEREXPOSED * truth,
            eq11,
        ),
        below("eq. 15 below eq. 11, mean", eq15, eq11),
        below("eq. 14 below eq. 11, mean", eq14, eq11),
    ]
}

/// That the light by eq. 11 changes by a larger factor with the object than by the others.
fn global(backend: Backend, near: [f64; 3], far: [f64; 3]) -> [Trial; 2] {
    let change = |i: usize| (near[i] / far[i]).ln().abs();
    let below = |what: &str, i| Trial::less_by(what, backend, (change(i), change(0)), 0.0);
    [
        below("logarithm of the change by eq. 15 below that by eq. 11", 1),
        below("logarithm of the change by eq. 14 below that by eq. 11", 2),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn eq_11_has_to_exceed_truth_and_others_and_to_change_most() {
        let overexposed = |means, truth| signs(&overexposed(Backend::Cpu, means, truth));
        assert_eq!(overexposed([5.0, 1.0, 2.0], 2.0), "+++");
        assert_eq!(overexposed([3.0, 4.0, 4.0], 2.0), "---");
        let global = |near, far| signs(&global(Backend::Cpu, near, far));
        assert_eq!(global([9.0, 1.0, 2.0], [1.0, 1.0, 1.0]), "++");
        assert_eq!(global([1.0, 1.0, 2.0], [1.0, 3.0, 1.0]), "--");
    }
}
