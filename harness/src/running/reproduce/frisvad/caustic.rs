//! The cave's lantern turned to its mirror, and the same with a black mirror.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::{Shade, lambertian};
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Light, PointLayout, Scene};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.caustic",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "light over a mirror",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Light that a mirror brings is in the map.",
            rule: "A trial is a backend: irradiance is nearer, in mean squared error, to the own model \
                with the mirror than the same map is with a black mirror in its place. Path tracing \
                finds no mirrored light of a point, so that the method's own model, an integral, is \
                the reference.",
        },
        Claim {
            id: "C2",
            says: "As much of it arrives as the mirror brings.",
            rule: "A trial is a bound and a backend: of the light that the mirror brings to all points \
                between half and twice as much arrives.",
        },
    ],
};

/// From the lantern to the middle of the cave's mirror.
const TO_MIRROR: Vec3 = Vec3::new(0.85, -1.2, -1.15);

/// Full angle of the lantern in degrees: little more than the mirror.
const ANGLE_DEG: f32 = 55.0;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::Irradiance;
    let place = ExperimentScene::of("cave")
        .set("light.angle", ANGLE_DEG)
        .set("light", 150);
    let bright = turned(context.scene(&place, &mut finding)?);
    let black = turned(context.scene(&place.clone().set("mirror.specular", 0), &mut finding)?);
    let (bright, black) = (context.set_up(&bright)?, context.set_up(&black)?);
    let view = context.view_of(&bright, (context.pick(4_000, 20_000), Shade::default()))?;
    let points = view.points(quantity.layout());
    let materials = view.points(PointLayout::Material);
    let model = context.method("direct_radiance_map", &[])?.model(quantity);
    let (mut references, mut without) = (
        context.references(&bright, quantity, &points),
        context.references(&black, quantity, &points),
    );
    let reference = references.model(model);
    let judge = Judge::new(reference, &points);
    let gained = total(&reference.values) - total(&without.model(model).values);
    let shown = |e: &Estimate| view.image(&lambertian(&materials, e));
    let title = "indirect light of a lantern that shines at a mirror";
    let mut row = Row::against(
        title,
        "own model",
        shown(&reference.values),
        view.surfaces(),
    );
    for backend in context.backends() {
        for fidelity in ["published", "corrected"] {
            let map = context.method(
                "direct_radiance_map",
                &[("fidelity", &fidelity), ("samples_per_side", &5)],
            )?;
            let with = context.run_once(&bright, backend, &*map, quantity, &points)?;
            let dark = context.run_once(&black, backend, &*map, quantity, &points)?;
            let share = (total(&with.estimate) - total(&dark.estimate)) / gained;
            let at = |name: &'static str| (fidelity, name);
            finding.measure(at(ERROR), backend, judge.error(&with.estimate), "");
            finding.measure(
                at("the same, black mirror"),
                backend,
                judge.error(&dark.estimate),
                "",
            );
            finding.measure(
                at("share of mirrored light"),
                backend,
                Amount::exact(share),
                "",
            );
            if fidelity == "published" {
                let estimates = [&with.estimate, &dark.estimate];
                let [nearer, least, most] = judged(&judge, backend, estimates, share);
                finding.judge("C1", [nearer]);
                finding.judge("C2", [least, most]);
            }
            if backend == context.backends()[0] {
                row.add(format!("{fidelity}, 5×5"), shown(&with.estimate));
                row.add(format!("{fidelity}, black mirror"), shown(&dark.estimate));
            }
            finding.runs.extend([with.run, dark.run]);
        }
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That the map with the mirror is nearer than with a black one, and brings between half and twice the light.
fn judged(
    judge: &Judge<'_>,
    backend: Backend,
    [with, dark]: [&Estimate; 2],
    share: f64,
) -> [Trial; 3] {
    let nearer = "with the mirror nearer than with a black one";
    let least = "a half below the share of mirrored light";
    let most = "share of mirrored light below two";
    [
        judge.nearer(nearer, backend, with, dark),
        Trial::less_by(least, backend, (0.5, share), 0.0),
        Trial::less_by(most, backend, (share, 2.0), 0.0),
    ]
}

/// The scene with its spot lights turned to the mirror.
fn turned(mut scene: Scene) -> Scene {
    let towards = TO_MIRROR.normalize();
    for light in &mut scene.lights {
        if let Light::Spot { direction, up, .. } = light {
            *direction = towards;
            *up = (Vec3::Y - towards * towards.y).normalize();
        }
    }
    scene
}

fn total(estimate: &Estimate) -> f64 {
    estimate.iter().map(|v| f64::from(v.element_sum())).sum()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn a_mirror_has_to_bring_its_light_and_not_more() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let judged = |with, dark, share| {
            signs(&judged(
                &judge,
                Backend::Cpu,
                [&flat(with), &flat(dark)],
                share,
            ))
        };
        assert_eq!(judged(0.9, 0.5, 1.0), "+++");
        assert_eq!(judged(0.5, 0.9, 0.4), "--+");
        assert_eq!(judged(0.9, 0.5, 2.1), "++-");
        assert_eq!(total(&flat(0.5)), 6.0);
    }
}
