//! Environment light with and without occlusion, beside the truth.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::Estimate;

pub(super) fn one_model(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let place = ExperimentScene::of("studio").with(&context.mesh("bunny"));
    compare(context, ("bunny, sky", place), &mut finding)?;
    Ok(finding)
}

pub(super) fn environments(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let all = [
        ("buddha", "blender_courtyard"),
        ("dragon", "blender_interior"),
        ("dragon", "pmndrs_hall"),
    ];
    for &(model, map) in context.pick(&all[..2], &all[..]) {
        let environment = context.assets().environment(map);
        if environment.is_none() {
            finding.note(format!(
                "{map} not found: the library's sky in its place; `make assets` brings it"
            ));
        }
        let place = ExperimentScene::of("studio")
            .with(&context.mesh(model))
            .under(environment);
        compare(context, (&format!("{model}, {map}"), place), &mut finding)?;
    }
    Ok(finding)
}

pub(super) fn group(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let dragon = context.mesh("dragon");
    let place = ExperimentScene::of("dragons")
        .with(&context.mesh("buddha"))
        .with(&dragon);
    compare(context, ("three models", place), &mut finding)?;
    Ok(finding)
}

fn compare(
    context: &ExperimentContext<'_>,
    (case, place): (&str, ExperimentScene),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let quantity = Quantity::Irradiance;
    let loaded = context.load(&place, finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.references(&loaded, quantity, &points);
    // What the method leaves out beside its finite number of directions: light between surfaces.
    let black = references.model(OwnModel::OccludedEnvironment);
    let (black, black_error) = (black.values.clone(), black.error.clone());
    let surfaces = (0..points.len()).filter(|&i| points.get(i).is_some());
    let own = Judge::at(&black, Some(&black_error), surfaces.collect());
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::rendered(case, "path tracing", &view, &truth.values);
    for backend in context.backends() {
        let occluded = context.method(
            "directional_ao",
            &[
                ("level", &context.pick(3, 4)),
                ("map_resolution", &context.pick(192, 512)),
            ],
        )?;
        let open = context.method("sh_mip_envmap", &[])?;
        let mut estimates = Vec::new();
        for (label, method) in [("without occlusion", open), ("with occlusion", occluded)] {
            let measured = context.run_once(&loaded, backend, &*method, quantity, &points)?;
            // The paper's sum has no weight: its pictures are as bright as they are made.
            let [to_all, to_own] = [&judge, &own].map(|judge| {
                let estimate = scaled(&measured.estimate, judge.factor(&measured.estimate));
                (judge.error(&estimate), estimate)
            });
            let at = |name: &str| (case.to_owned(), format!("{name}, {label}"));
            let factor = Amount::exact(judge.factor(&measured.estimate));
            finding.measure(at(ERROR), backend, to_all.0, "");
            finding.measure(at("to occluded environment light"), backend, to_own.0, "");
            finding.measure(at("factor on brightness"), backend, factor, "");
            if backend == context.backends()[0] {
                row.add(label, view.image(&to_all.1));
            }
            estimates.push([to_all.1, to_own.1]);
            finding.runs.push(measured.run);
        }
        if let [without, with] = &estimates[..] {
            for (i, (judge, reference)) in
                [(&judge, "all light"), (&own, "occluded environment light")]
                    .into_iter()
                    .enumerate()
            {
                let trial = gained(judge, (case, reference), backend, [&with[i], &without[i]]);
                finding.judge(["C1", "C2"][i], [trial]);
            }
        }
    }
    finding.pictures.push(row);
    Ok(())
}

/// That an estimate with occlusion is nearer to the reference than one without.
fn gained(
    judge: &Judge<'_>,
    (case, reference): (&str, &str),
    backend: Backend,
    [with, without]: [&Estimate; 2],
) -> Trial {
    let what = format!("{case}: nearer to {reference} with occlusion than without");
    judge.nearer(what, backend, with, without)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn occlusion_has_to_bring_an_estimate_nearer() {
        let reference = flat(0.5);
        let judge = exact(&reference);
        let judged = |with: f32, without: f32| {
            let pair = [&flat(with), &flat(without)];
            signs([&gained(&judge, ("", ""), Backend::Cpu, pair)])
        };
        assert_eq!(
            (judged(0.6, 1.0), judged(1.0, 0.6)),
            ("+".into(), "-".into())
        );
    }
}
