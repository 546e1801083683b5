//! A model just above the floor: classic mapping, points and polygons beside the reference.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::{Estimate, LightPaths};

/// All light but what the model keeps from itself.
const UNSHADOWED: OwnModel = OwnModel::LightTransport(LightPaths {
    self_shadowing: false,
    ..LightPaths::ALL
});

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::Irradiance;
    let place = ExperimentScene::of("colored-room")
        .set("reference.offset", 0)
        .with(&context.mesh("bunny"))
        .set("receiver.place", "floor")
        .set("receiver.gap", 0.01)
        .set("receiver.size", 0.9);
    let loaded = context.load(&place, &mut finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.references(&loaded, quantity, &points);
    let truth = references.model(UNSHADOWED);
    let judge = Judge::new(truth, &points);
    for m in [4_u32, 8] {
        let title = format!("irradiance, M = {m}");
        let mut row = Row::rendered(title, "reference", &view, &truth.values);
        for backend in context.backends() {
            let mut shoot = |label: &str, id: &str, parameters: &[(&str, &dyn ToString)]| {
                let method = context.method(id, parameters)?;
                let measured = context.run_once(&loaded, backend, &*method, quantity, &points)?;
                let at = |name: &str| (format!("M = {m}, {label}"), name.to_owned());
                finding.measure(at(ERROR), backend, judge.error(&measured.estimate), "");
                let spike = Amount::exact(judge.spike(&measured.estimate));
                finding.measure(at("spike / mean"), backend, spike, "");
                if backend == context.backends()[0] {
                    row.add(label, view.image(&measured.estimate));
                }
                finding.runs.push(measured.run);
                Ok::<_, RunError>(measured.estimate)
            };
            let four: (&str, &dyn ToString) = ("bounces", &4);
            let edge: (&str, &dyn ToString) = ("resolution", &m);
            let corrected: (&str, &dyn ToString) = ("fidelity", &"corrected");
            let classic = shoot("classic", "classic_envmap", &[four])?;
            let point = shoot("points", "point_form_factor", &[four, edge])?;
            let polygon = shoot("polygons", "polygon_form_factor", &[four, edge])?;
            let mended = shoot(
                "corrected polygons",
                "polygon_form_factor",
                &[four, edge, corrected],
            )?;
            let (polygons, rivals) = ([&polygon, &mended], [&point, &classic]);
            let trials = judged(&judge, (m, backend), polygons, rivals);
            finding.judge("C1", trials);
        }
        finding.pictures.push(row);
    }
    Ok(finding)
}

/// That polygons, published and corrected, are nearer to the reference than points and classic mapping.
fn judged(
    judge: &Judge<'_>,
    (m, backend): (u32, Backend),
    [published, corrected]: [&Estimate; 2],
    [points, classic]: [&Estimate; 2],
) -> Vec<Trial> {
    let mut trials = Vec::new();
    for (fidelity, polygon) in [("published", published), ("corrected", corrected)] {
        for (rival, estimate) in [("points", points), ("classic mapping", classic)] {
            let what = format!("M = {m}: {fidelity} polygons nearer than {rival}");
            trials.push(judge.nearer(what, backend, polygon, estimate));
        }
    }
    trials
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn polygons_have_to_be_the_nearest() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let [one, two, three, four] = [0.9, 0.8, 0.7, 0.6].map(flat);
        let at = (4, Backend::Cpu);
        let trials = judged(&judge, at, [&one, &two], [&three, &four]);
        assert_eq!(signs(&trials), "++++");
        let trials = judged(&judge, at, [&four, &two], [&three, &one]);
        assert_eq!(signs(&trials), "--+-");
        assert_eq!(
            trials[2].what,
            "M = 4: corrected polygons nearer than points, MSE / mean²"
        );
    }
}
