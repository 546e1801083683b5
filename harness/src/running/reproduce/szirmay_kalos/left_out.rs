//! Light that no localized map has, and whether it is missed.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::room;
use super::room::DIFFUSE;
use super::room::{BOUNCES, UNSHADOWED, directions, localized};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::truth::TRUTH;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::Points;
use serde::Serialize;

pub(super) const HIDDEN: Experiment = Experiment {
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
};

pub(super) const SELF_SHADOWING: Experiment = Experiment {
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
};

/// What a map leaves out.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Left {
    /// Surfaces that are not seen from the reference point; and those that are seen shine through what is in
    /// between.
    Hidden,
    /// Shadows of the model on itself.
    SelfShadowing,
}

/// A model in a room, and what is left out there.
#[derive(Serialize)]
pub(super) struct LeftOut {
    pub(super) scene: SceneSetup,
    pub(super) left_out: Left,
    /// Settings of the scene, one after the other.
    pub(super) cases: &'static [(&'static str, &'static str)],
    /// M, texels along a face's edge.
    pub(super) resolution: u32,
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
}

/// Largest rms difference over the mean that passes for no noticeable one.
const UNNOTICED: f64 = 0.05;

/// Largest factor on a map's error by what is left out.
const WORSE: f64 = 2.0;

impl Runs for LeftOut {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for &case in self.cases {
            self.at(context, case, &mut finding)?;
        }
        Ok(finding)
    }
}

impl LeftOut {
    /// The light with what is left out, and without.
    fn models(&self) -> [OwnModel; 2] {
        match self.left_out {
            Left::Hidden => [
                UNSHADOWED,
                OwnModel::VisibleFromReference { bounces: BOUNCES },
            ],
            Left::SelfShadowing => [TRUTH, UNSHADOWED],
        }
    }

    fn at(
        &self,
        context: &ExperimentContext<'_>,
        (setting, value): (&str, &str),
        finding: &mut Finding,
    ) -> Result<(), RunError> {
        let quantity = Quantity::Irradiance;
        let place = &*format!("{setting}={value}");
        let scene = context.place(&self.scene).set(setting, value);
        let loaded = context.load(&scene, finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let references = || context.references(&loaded, quantity, &points);
        let [with, without] = self.models();
        let (mut all, mut rest) = (references(), references());
        let (with, without) = (all.model(with), rest.model(without));
        let [judge, of_rest] = [with, without].map(|light| Judge::new(light, &points));
        let first = context.backends()[0];
        let rms = judge.relative_rms(&without.values);
        finding.measure((place, "rms of what is left out / mean"), first, rms, "");
        let hidden = Amount::exact(hidden_share(&loaded, &points));
        let name = "share of directions to surfaces that the reference point does not see";
        finding.measure((place, name), first, hidden, "");
        finding.judge("C1", [unnoticed(place, first, rms)]);
        let mut row = Row::rendered(place, "all of it", &view, &with.values);
        row.add("without what is left out", view.image(&without.values));
        for backend in context.backends() {
            let texels = (self.resolution, self.capture_resolution);
            let method = localized(context, texels, "shader", &[])?;
            let run = context.run_once(&loaded, backend, &*method, quantity, &points)?;
            let errors = [&judge, &of_rest].map(|judge| judge.error(&run.estimate));
            for (name, error) in ["all light", "the rest"].into_iter().zip(errors) {
                finding.measure((place, format!("{ERROR} to {name}")), backend, error, "");
            }
            finding.judge("C1", [drowned(place, backend, errors)]);
            if backend == first {
                row.add(
                    format!("M = {}", self.resolution),
                    view.image(&run.estimate),
                );
            }
            finding.runs.push(run.run);
        }
        finding.pictures.push(row);
        Ok(())
    }
}

/// Points whose surroundings are looked at, and how far off in metres the same place may be.
const LOOKED_AT: usize = 300;
const SAME_PLACE: f64 = 1e-3;

/// Of 26 directions from some points, as far as they leave the surface, the share that meets a surface which is not seen
/// from the reference point.
fn hidden_share(loaded: &LoadedScene, points: &Points) -> f64 {
    let (scene, from) = (
        &loaded.cpu().scene,
        loaded.scene().reference_point.as_dvec3(),
    );
    let geometry = scene.environment_objects();
    let closest =
        |origin, direction| scene.closest(geometry, origin, direction, geometry.ray_start());
    let (mut met, mut hidden) = (0_usize, 0_usize);
    for point in points
        .iter()
        .flatten()
        .step_by(points.len().div_ceil(LOOKED_AT))
    {
        for direction in directions()
            .into_iter()
            .filter(|d| d.dot(point.normal) > 0.0)
        {
            let Some(hit) = closest(point.position.as_dvec3(), direction) else {
                continue;
            };
            let towards = (hit.position - from).as_vec3();
            let seen = closest(from, towards.normalize());
            met += 1;
            if seen.is_none_or(|s| s.position.distance(hit.position) > SAME_PLACE) {
                hidden += 1;
            }
        }
    }
    hidden as f64 / met.max(1) as f64
}

/// That light differs little from light without what is left out.
fn unnoticed(place: &str, backend: Backend, rms: Amount) -> Trial {
    let what = format!("{place}: what is left out, rms / mean");
    Trial::less(what, backend, rms, Amount::exact(UNNOTICED))
}

/// That a map's error against all light is less than twice that against the rest.
fn drowned(place: &str, backend: Backend, [all, rest]: [Amount; 2]) -> Trial {
    let what = format!("{place}: error to all light below {WORSE} times that to the rest");
    Trial::less(what, backend, all, rest.times(WORSE))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn what_is_left_out_is_a_twentieth_at_most_and_does_not_double_the_error() {
        let judged = |rms, all, rest| {
            let [all, rest] = [all, rest].map(Amount::exact);
            let unnoticed = unnoticed("", Backend::Cpu, Amount::exact(rms));
            signs([&unnoticed, &drowned("", Backend::Cpu, [all, rest])])
        };
        assert_eq!(judged(0.04, 1.9, 1.0), "++");
        assert_eq!(judged(0.06, 2.1, 1.0), "--");
    }
}
