//! The colour of a specular model's head under a green ceiling.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::heights::heights;
use super::super::judge::{Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::room;
use super::room::{UNSHADOWED, classic, localized};
use crate::domain::record::Backend;
use crate::domain::significance::NOISE_DEVIATIONS;
use crate::running::error::RunError;
use glam::DVec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "szirmay-kalos.3",
    paper: Paper::SzirmayKalos,
    item: Item::Figure(3),
    title: "specular buddha under a green ceiling",
    setup: &Head {
        scene: room(
            &["buddha"],
            &[
                ("ceiling", "green"),
                ("divider", "0.9"),
                ("block", "false"),
                ("reference.place", "room"),
                ("reference.offset", "0"),
                ("receiver.place", "ceiling"),
                ("receiver.size", "0.7"),
                ("receiver.diffuse", "0"),
                ("receiver.specular", "0.8"),
                ("receiver.shininess", "5"),
            ],
        ),
        head: 0.15,
        resolution: 4,
        capture_resolution: CAPTURE,
    },
    claims: &[Claim {
        id: "C1",
        says: "The head should be greenish under the green ceiling, and is not by classic mapping.",
        rule: "The buddha's head is under the ceiling, the reference point in the middle of the room. \
            A trial is one of these on a backend, by the share of green in the light of the head's \
            points: in the reference the head is greener than the lower half; by classic mapping it is \
            less green than in the reference; and the localized map's share is nearer to the \
            reference's than classic mapping's, beyond the reference's noise.",
    }],
};

/// A model under the ceiling.
#[derive(Serialize)]
pub(super) struct Head {
    pub(super) scene: SceneSetup,
    /// Share of the model's height that is its head.
    pub(super) head: f64,
    /// M of the localized map beside it, texels along a face's edge.
    pub(super) resolution: u32,
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
}

impl Runs for Head {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::GlossyRadiance;
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let mut references = context.precise(&loaded, quantity, &points);
        let truth = references.model(UNSHADOWED);
        let judge = Judge::new(truth, &points);
        let (head, body) = self.parts(&points);
        let first = context.backends()[0];
        let green = |of: &[usize]| greenness(&truth.values, Some(&truth.error), of);
        let (reference, below) = (green(&head), green(&body));
        finding.measure(("head", "green share, reference"), first, reference, "");
        finding.measure(("body", "green share, reference"), first, below, "");
        finding.judge("C1", [greenish(first, below, reference)]);
        let mut row = Row::rendered("specular buddha", "reference", &view, &truth.values);
        for backend in context.backends() {
            let mut shoot = |label: &str, method: &dyn interreflect_estimators::Configured| {
                let run = context.run_once(&loaded, backend, method, quantity, &points)?;
                let green = greenness(&run.estimate, None, &head);
                finding.measure(
                    ("head", format!("green share, {label}")),
                    backend,
                    green,
                    "",
                );
                if backend == first {
                    let brought = scaled(&run.estimate, judge.factor(&run.estimate));
                    row.add(label, view.image(&brought));
                }
                finding.runs.push(run.run);
                Ok::<_, RunError>(green)
            };
            let capture = self.capture_resolution;
            let by_classic = shoot("classic", &*classic(context, capture)?)?;
            let method = localized(context, (self.resolution, capture), "shader", &[])?;
            let by_map = shoot(&format!("M = {}", self.resolution), &*method)?;
            finding.judge("C1", judged(backend, reference, by_classic, by_map));
        }
        finding.pictures.push(row);
        Ok(finding)
    }
}

impl Head {
    /// Indices of the points of the head, and of those of the lower half.
    fn parts(&self, points: &Points) -> (Vec<usize>, Vec<usize>) {
        let heights = heights(points);
        let of = |part: &dyn Fn(f64) -> bool| {
            let inside = heights.iter().filter(|(_, share)| part(*share));
            inside.map(|(i, _)| *i).collect()
        };
        (of(&|y| y > 1.0 - self.head), of(&|y| y < 0.5))
    }
}

/// Green over the sum of all channels, of all these points together.
fn greenness(estimate: &Estimate, error: Option<&Estimate>, at: &[usize]) -> Amount {
    let light: DVec3 = at.iter().map(|&i| estimate.get(i).as_dvec3()).sum();
    let share = light.y / light.element_sum();
    let variance = |error: &Estimate| -> f64 {
        let weights = DVec3::new(share, 1.0 - share, share);
        let of_point = |&i: &usize| (weights * error.get(i).as_dvec3()).length_squared();
        at.iter().map(of_point).sum::<f64>() / light.element_sum().powi(2)
    };
    Amount {
        value: share,
        spread: NOISE_DEVIATIONS * error.map_or(0.0, variance).sqrt(),
    }
}

/// That the reference's head is greener than the body below.
fn greenish(backend: Backend, body: Amount, head: Amount) -> Trial {
    let what = "reference: green share of the body below that of the head";
    Trial::less(what, backend, body, head)
}

/// That classic mapping's head is less green than the reference's, and farther from it than the localized one's.
fn judged(backend: Backend, reference: Amount, classic: Amount, map: Amount) -> [Trial; 2] {
    let distance = |a: Amount| (a.value - reference.value).abs();
    let nearer =
        "distance of the localized head's green share from the reference's below classic's";
    [
        Trial::less(
            "green share of the head by classic below the reference's",
            backend,
            classic,
            reference,
        ),
        Trial::less_by(
            nearer,
            backend,
            (distance(map), distance(classic)),
            2.0 * reference.spread,
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{flat, signs};
    use super::*;

    #[test]
    fn classic_mapping_has_to_miss_the_green_that_a_map_and_the_reference_have() {
        let about = |value| Amount {
            value,
            spread: 0.01,
        };
        let judged = |classic, map| {
            signs(&judged(
                Backend::Cpu,
                about(0.5),
                Amount::exact(classic),
                Amount::exact(map),
            ))
        };
        assert_eq!(judged(0.35, 0.48), "++");
        assert_eq!(judged(0.6, 0.2), "--");
        assert_eq!(judged(0.495, 0.5), "??");
        assert_eq!(
            signs([&greenish(Backend::Cpu, about(0.4), about(0.5))]),
            "+"
        );
        let grey = greenness(&flat(2.0), Some(&flat(0.1)), &[0, 1]);
        assert!((grey.value - 1.0 / 3.0).abs() < 1e-6 && grey.spread > 0.0);
    }
}
