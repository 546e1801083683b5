//! Error of classic mapping over the distance from the reference point, in distances of the walls from there.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::room::{classic, directions};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Point, PointLayout, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
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
};

/// A room, and how far points lie from its reference point.
#[derive(Serialize)]
pub(super) struct Distance {
    pub(super) scene: SceneSetup,
    /// Distances of points from the reference point over those of the surfaces behind them.
    pub(super) ratios: [f64; 5],
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
}

impl Runs for Distance {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let method = classic(context, self.capture_resolution)?;
        let mut errors: Vec<(Backend, Vec<Amount>)> = context
            .backends()
            .into_iter()
            .map(|backend| (backend, Vec::new()))
            .collect();
        for ratio in self.ratios {
            let points = points(&loaded, ratio as f32);
            let mut references = context.precise(&loaded, Quantity::Irradiance, &points);
            let judge = Judge::new(references.truth(), &points);
            for (backend, errors) in &mut errors {
                let run =
                    context.run_once(&loaded, *backend, &*method, Quantity::Irradiance, &points)?;
                let error = judge.error(&run.estimate);
                finding.measure((format!("ratio {ratio}"), ERROR), *backend, error, "");
                finding.runs.push(run.run);
                errors.push(error);
            }
        }
        for (backend, errors) in errors {
            finding.judge("C1", self.judged(backend, &errors));
        }
        Ok(finding)
    }
}

impl Distance {
    /// That each error is less than the next one.
    fn judged(&self, backend: Backend, errors: &[Amount]) -> Vec<Trial> {
        let pairs = errors.windows(2).zip(self.ratios.windows(2));
        let grows = |(error, ratio): (&[Amount], &[f64])| {
            let what = format!("error at ratio {} below that at {}", ratio[0], ratio[1]);
            Trial::less(what, backend, error[0], error[1])
        };
        pairs.map(grows).collect()
    }
}

/// Points of six orientations towards each of 26 directions, at a share of the way to what lies there.
fn points(loaded: &LoadedScene, ratio: f32) -> Points {
    let (scene, from) = (&loaded.cpu().scene, loaded.scene().reference_point);
    let geometry = scene.environment_objects();
    let mut points = Vec::new();
    for direction in directions() {
        let start = from.as_dvec3();
        let Some(hit) = scene.closest(geometry, start, direction, geometry.ray_start()) else {
            continue;
        };
        let position = from + (hit.position.as_vec3() - from) * ratio;
        for normal in [Vec3::X, Vec3::Y, Vec3::Z] {
            for normal in [normal, -normal] {
                points.push(Some(Point {
                    position,
                    normal,
                    ..Point::default()
                }));
            }
        }
    }
    Points::new(PointLayout::Surface, points)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn errors_have_to_grow_with_every_step() {
        let distance = Distance {
            scene: SceneSetup::of("colored-room"),
            ratios: [0.0, 0.2, 0.4, 0.6, 0.8],
            capture_resolution: 256,
        };
        let judged = |errors: [f64; 5]| signs(&distance.judged(Backend::Cpu, &errors.map(about)));
        assert_eq!(judged([1.0, 2.0, 4.0, 8.0, 16.0]), "++++");
        assert_eq!(judged([1.0, 0.5, 4.0, 4.1, 16.0]), "-+?+");
    }
}
