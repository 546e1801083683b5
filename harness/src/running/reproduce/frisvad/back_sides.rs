//! §6: what lies behind a lit surface.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::solid_angles::{EQUATIONS, brightness};
use super::steps::{GRID, Grid};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Point, PointLayout, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.back-sides",
    paper: Paper::Frisvad,
    item: Item::Section("6"),
    title: "surfaces that face away from a sample",
    setup: &BackSides {
        scene: SceneSetup::of("cornell-box").set(&[("light.angle", "20")]),
        below_m: 0.1,
        grid: GRID,
    },
    claims: &[Claim {
        id: "C1",
        says: "Eqs. 11 and 15 light back sides.",
        rule: "A trial is an equation and a backend: points below the floor that look up at it get more light \
            than by eq. 14. The spot light is so narrow that all samples lie on the floor and on a block's top.",
    }],
};

/// Points that look up at the floor from below.
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

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn equations_11_and_15_have_to_light_what_eq_14_does_not() {
        let behind = |means| signs(&behind(Backend::Cpu, means));
        assert_eq!(behind([1.0, 2.0, 0.0]), "++");
        assert_eq!(behind([0.0, 0.0, 0.0]), "??");
        assert_eq!(behind([0.1, 0.2, 0.3]), "--");
    }
}
