//! Glossy walls, taken to be Lambertian and by their whole material.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::Trial;
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.materials",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "a Cornell box of glossy walls",
    setup: &InCode(run),
    claims: &[Claim {
        id: "C1",
        says: "With true colours in the map, lit surfaces may reflect by any law.",
        rule: "A trial is a fidelity and a backend: irradiance is nearer to path-traced truth, in mean \
            squared error beyond its noise, where lit surfaces reflect by their whole material than by \
            Lambert's law.",
    }],
};

/// Share of a wall's albedo that becomes specular.
const GLOSSY: f32 = 0.6;

/// Exponent of the walls' lobe.
const SHININESS: f32 = 10.0;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::Irradiance;
    let mut scene = context.scene(&ExperimentScene::of("cornell-box"), &mut finding)?;
    for material in &mut scene.materials {
        material.specular = Vec3::splat(GLOSSY * material.albedo.max_element());
        material.albedo *= 1.0 - GLOSSY;
        material.shininess = SHININESS;
    }
    let loaded = context.set_up(&scene)?;
    let view = context.view(&loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.references(&loaded, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::rendered("irradiance", "path tracing", &view, &truth.values);
    for backend in context.backends() {
        for fidelity in ["published", "corrected"] {
            let mut estimates = Vec::new();
            for (surface, caption) in [("lambertian", "Lambert"), ("blinn_phong", "whole material")]
            {
                let map = context.method(
                    "direct_radiance_map",
                    &[
                        ("surface", &surface),
                        ("fidelity", &fidelity),
                        ("samples_per_side", &5),
                    ],
                )?;
                let measured = context.run_once(&loaded, backend, &*map, quantity, &points)?;
                let at = (fidelity, format!("{ERROR}, {caption}"));
                finding.measure(at, backend, judge.error(&measured.estimate), "");
                if backend == context.backends()[0] {
                    row.add(
                        format!("{fidelity}, {caption}"),
                        view.image(&measured.estimate),
                    );
                }
                estimates.push(measured.estimate);
                finding.runs.push(measured.run);
            }
            if let [lambert, whole] = &estimates[..] {
                let trial = gained(&judge, (fidelity, backend), [lambert, whole]);
                finding.judge("C1", [trial]);
            }
        }
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That the whole material's estimate is nearer to the truth than Lambert's law's.
fn gained(
    judge: &Judge<'_>,
    (fidelity, backend): (&str, Backend),
    [lambert, whole]: [&Estimate; 2],
) -> Trial {
    let what = format!("{fidelity}: whole material nearer than Lambert's law");
    judge.nearer(what, backend, whole, lambert)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn the_whole_material_has_to_be_the_nearer_one() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let judged = |lambert, whole| {
            let pair = [&flat(lambert), &flat(whole)];
            signs([&gained(&judge, ("", Backend::Cpu), pair)])
        };
        assert_eq!(
            (judged(0.5, 0.9), judged(0.9, 0.5)),
            ("+".into(), "-".into())
        );
    }
}
