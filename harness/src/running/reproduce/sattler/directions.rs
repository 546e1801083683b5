//! Openness over the number of directions.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::directions;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;

/// The level of a few hundred directions.
const ENOUGH: u32 = 3;

/// Largest rms difference over the mean that is enough.
const NEAR: f64 = 0.05;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::AmbientOcclusion;
    let loaded = context.load(
        &ExperimentScene::of("studio").with(&context.mesh("buddha")),
        &mut finding,
    )?;
    let view = context.view(&loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.precise(&loaded, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::rendered("openness", "traced rays", &view, &truth.values);
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
            let measured = context.run_once(&loaded, backend, &*method, quantity, &points)?;
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
                finding.judge("C2", [enough(&case, backend, rms)]);
            }
            if backend == context.backends()[0] {
                row.add(case, view.image(&measured.estimate));
            }
            estimates.push((k, measured.estimate));
            finding.runs.push(measured.run);
        }
        finding.judge("C1", steps(&judge, backend, &estimates));
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That this many directions are near enough to the reference.
fn enough(case: &str, backend: Backend, rms: Amount) -> Trial {
    let what = format!("{case}: rms difference over mean");
    Trial::less(what, backend, rms, Amount::exact(NEAR))
}

/// That each estimate, of a number of directions, is nearer to the reference than the one before.
fn steps(judge: &Judge<'_>, backend: Backend, estimates: &[(u32, Estimate)]) -> Vec<Trial> {
    let step = |pair: &[(u32, Estimate)]| {
        let what = format!("{} directions nearer than {}", pair[1].0, pair[0].0);
        judge.nearer(what, backend, &pair[1].1, &pair[0].1)
    };
    estimates.windows(2).map(step).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn more_directions_have_to_be_nearer_and_258_enough() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let estimates = [(6, 0.5), (18, 0.7), (66, 0.6), (258, 0.9)];
        let estimates = estimates.map(|(k, value)| (k, flat(value)));
        let trials = steps(&judge, Backend::Cpu, &estimates);
        assert_eq!(signs(&trials), "+-+");
        assert_eq!(trials[0].what, "18 directions nearer than 6, MSE / mean²");
        let near = |rms| signs([&enough("", Backend::Cpu, Amount::exact(rms))]);
        assert_eq!((near(0.049), near(0.051)), ("+".into(), "-".into()));
        assert_eq!(directions(ENOUGH), 258);
        assert_eq!([0, 1, 2, 4].map(directions), [6, 18, 66, 1026]);
    }
}
