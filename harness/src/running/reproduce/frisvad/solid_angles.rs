//! The three solid angles beside each other.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{Judge, scaled};
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::steps::{Grid, Step, Taken, row, take, view};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Estimate, Point, PointLayout, Points};
use serde::Serialize;

const EQUATIONS: [Step; 3] = [Step::Eq11, Step::Eq15, Step::Eq14];

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
        ),
        below(
            "eq. 14's frame over eq. 11's below 2.33·1.5",
            ratio,
            bound(FACTOR),
        ),
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

/// Mean over points and channels.
fn brightness(irradiance: &Estimate) -> f64 {
    let sum: f64 = irradiance.iter().map(|v| f64::from(v.element_sum())).sum();
    sum / (3 * irradiance.len().max(1)) as f64
}

/// §4: what lies behind a lit surface.
#[derive(Serialize)]
pub(super) struct BackSides {
    pub(super) scene: SceneSetup,
    /// How far below the floor points are that look up at it, in metres.
    pub(super) below_m: f64,
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl Runs for BackSides {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let bounds = loaded.scene().facts().bounds;
        let (low, extent) = (bounds.low, bounds.high - bounds.low);
        let at = |i: u32| {
            let [x, z] = [i % 16, i / 16].map(|k| (k as f32 + 0.5) / 16.0);
            Some(Point {
                position: low + Vec3::new(x * extent.x, -self.below_m as f32, z * extent.z),
                normal: Vec3::Y,
                ..Point::default()
            })
        };
        let points = Points::new(PointLayout::Surface, (0..256).map(at));
        for backend in context.backends() {
            let mut means = [0.0; 3];
            for (mean, step) in means.iter_mut().zip(EQUATIONS) {
                let Some(map) = step.map(context, self.grid)? else {
                    continue;
                };
                let quantity = Quantity::Irradiance;
                let measured = context.run_once(&loaded, backend, &*map, quantity, &points)?;
                *mean = brightness(&measured.estimate);
                let case = format!("below the floor, {}", step.caption());
                finding.measure(
                    (case, "mean irradiance"),
                    backend,
                    Amount::exact(*mean),
                    "W/m²",
                );
                finding.runs.push(measured.run);
            }
            finding.judge("C1", behind(backend, means));
        }
        Ok(finding)
    }
}

/// That equations 11 and 15 light what is behind, which eq. 14 does not.
fn behind(backend: Backend, [eq11, eq15, eq14]: [f64; 3]) -> [Trial; 2] {
    let above = |what: &str, light| Trial::less_by(what, backend, (eq14, light), 0.0);
    [
        above("eq. 14 below eq. 11", eq11),
        above("eq. 14 below eq. 15", eq15),
    ]
}

/// Most that the error of 3×3 samples may exceed that of 4×4 if these are not markedly better.
const MARKEDLY: f64 = 1.5;

/// §5: the number of samples.
#[derive(Serialize)]
pub(super) struct NumberOfSamples {
    pub(super) scene: SceneSetup,
    pub(super) texels: u32,
    pub(super) samples: [u32; 4],
}

impl Runs for NumberOfSamples {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = view(context, &loaded, Step::Eq14)?;
        let points = view.points(Quantity::Irradiance.layout());
        let mut references = context.references(&loaded, Quantity::Irradiance, &points);
        let truth = references.truth();
        let judge = Judge::new(truth, &points);
        let ambient = super::bleeding::uniform(&truth.values, &points);
        for backend in context.backends() {
            let title = format!("irradiance, {backend}");
            let mut row =
                super::super::pictures::Row::rendered(title, "path tracing", &view, &truth.values);
            row.add("best constant ambient term", view.image(&ambient));
            let mut found = Vec::new();
            for n in self.samples {
                let settings: [(&str, &dyn ToString); 2] =
                    [("map_resolution", &self.texels), ("samples_per_side", &n)];
                let map = context.method("direct_radiance_map", &settings)?;
                let quantity = Quantity::Irradiance;
                let measured = context.run_once(&loaded, backend, &*map, quantity, &points)?;
                // Shades are compared, not brightness: the published areas lose light by themselves.
                let shades = scaled(&measured.estimate, judge.factor(&measured.estimate));
                let alike = super::bleeding::correlation(&shades, &truth.values);
                let error = judge.error(&shades);
                let case = format!("{n}×{n} samples");
                finding.measure(
                    (case.as_str(), super::super::judge::ERROR),
                    backend,
                    error,
                    "",
                );
                let amount = Amount::exact(alike);
                finding.measure(
                    (case.as_str(), "correlation of colours"),
                    backend,
                    amount,
                    "",
                );
                row.add(case, view.image(&shades));
                finding.runs.push(measured.run);
                found.push((shades, error, alike));
            }
            finding.pictures.push(row);
            if let [two, three, four, ..] = &found[..] {
                let nearer = "2×2 samples nearer to the truth than a constant ambient term";
                let colours = "correlation of colours of 2×2 below that of 4×4 samples";
                finding.judge("C1", [judge.nearer(nearer, backend, &two.0, &ambient)]);
                finding.judge(
                    "C2",
                    [Trial::less_by(colours, backend, (two.2, four.2), 0.0)],
                );
                finding.judge("C3", [not_markedly(backend, three.1, four.1)]);
            }
        }
        Ok(finding)
    }
}

/// That 4×4 samples are not markedly better than 3×3.
fn not_markedly(backend: Backend, three: Amount, four: Amount) -> Trial {
    let what = "error of 3×3 below 1.5 times that of 4×4 samples";
    Trial::less(what, backend, three, four.times(MARKEDLY))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn each_rule_can_fail() {
        let costs = |ms: [f64; 3]| signs(&costs(Backend::Cpu, ms.map(Amount::exact)));
        assert_eq!(costs([10.0, 12.0, 23.0]), "+++");
        assert_eq!(costs([10.0, 13.0, 15.0]), "--+");
        assert_eq!(costs([10.0, 10.0, 36.0]), "++-");
        let overexposed = |means, truth| signs(&overexposed(Backend::Cpu, means, truth));
        assert_eq!(overexposed([5.0, 1.0, 2.0], 2.0), "+++");
        assert_eq!(overexposed([3.0, 4.0, 4.0], 2.0), "---");
        let global = |near, far| signs(&global(Backend::Cpu, near, far));
        assert_eq!(global([9.0, 1.0, 2.0], [1.0, 1.0, 1.0]), "++");
        assert_eq!(global([1.0, 1.0, 2.0], [1.0, 3.0, 1.0]), "--");
        let behind = |means| signs(&behind(Backend::Cpu, means));
        assert_eq!(behind([1.0, 2.0, 0.0]), "++");
        assert_eq!(behind([0.0, 0.0, 0.0]), "??");
        let markedly =
            |three, four| signs([&not_markedly(Backend::Cpu, about(three), about(four))]);
        assert_eq!(markedly(1.0, 1.0), "+");
        assert_eq!(markedly(2.0, 1.0), "-");
        assert_eq!(
            brightness(&super::super::super::synthetic::of(&[1.0, 3.0])),
            2.0
        );
    }
}
