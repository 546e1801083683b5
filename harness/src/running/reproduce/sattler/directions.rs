//! Openness over the number of directions.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::directions;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;

/// The level of a few hundred directions.
const ENOUGH: u32 = 3;

/// Largest rms difference over the mean that is enough.
const NEAR: f64 = 0.05;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::AmbientOcclusion;
    let room = context.room(
        &ExperimentScene::of("studio").with(&context.mesh("buddha")),
        &mut finding,
    )?;
    let view = context.view(&room)?;
    let points = view.points(quantity.layout());
    let mut references = context.precise(&room, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::against(
        "openness",
        "traced rays",
        view.image(&truth.values),
        view.surfaces(),
    );
    for backend in context.backends() {
        let mut estimates = Vec::new();
        for level in 0..=context.pick(3, 4) {
            let k = directions(level);
            let method = context.method(
                "directional_ao",
                &[
                    ("level", &level),
                    ("map_resolution", &context.pick(192, 512)),
                ],
            )?;
            let measured = context.run_once(&room, backend, &*method, quantity, &points)?;
            let rms = judge.relative_rms(&measured.estimate);
            let case = format!("k = {k}");
            finding.measure(
                (&*case, ERROR),
                backend,
                judge.error(&measured.estimate),
                "",
            );
            finding.measure((&*case, "rms difference / mean"), backend, rms, "");
            if level == ENOUGH {
                let what = format!("{case}: rms difference over mean");
                finding
                    .trials
                    .push(Trial::less(what, backend, rms, Amount::exact(NEAR)));
            }
            if backend == context.backends()[0] {
                row.add(case, view.image(&measured.estimate));
            }
            estimates.push((k, measured.estimate));
            finding.runs.push(measured.run);
        }
        for pair in estimates.windows(2) {
            let what = format!("{} directions nearer than {}", pair[1].0, pair[0].0);
            finding
                .trials
                .push(judge.nearer(what, backend, &pair[1].1, &pair[0].1));
        }
    }
    finding.pictures.push(row);
    Ok(finding)
}
