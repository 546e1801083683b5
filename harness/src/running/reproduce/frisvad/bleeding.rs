//! Indirect light of few samples beside the truth, and beside a uniform ambient light.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::irradiance::{correlation, sum, uniform};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::truth::References;
use crate::running::view::{View, lambertian};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Estimate, PointLayout};

pub(super) const NEARER: Claim = Claim {
    id: "C1",
    says: "Few samples are nearer to the truth than no indirect light, and in shape than ambient light.",
    rule: "A trial is a case and a backend: irradiance by 3×3 samples is nearer to path-traced truth, in \
        mean squared error and beyond its noise, than no indirect light at all; and, up to one factor on its \
        brightness, than the best uniform ambient light, which has the truth's mean colour.",
};

const ARRIVES: Claim = Claim {
    id: "C2",
    says: "Most of the truth's light arrives.",
    rule: "A trial is a case and a backend: more than half of the sum of the truth.",
};

pub(super) const CORNELL_BOX: Experiment = Experiment {
    id: "frisvad.bleeding",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "few samples in the Cornell box against path tracing",
    setup: &InCode(cornell_box),
    claims: &[
        NEARER,
        ARRIVES,
        Claim {
            id: "C3",
            says: "The light has the truth's colours.",
            rule: "A trial is an area or a spot light and a backend: the colours (red less green over \
                their sum, weighted by the truth's brightness) correlate with the truth's by more \
                than a half.",
        },
    ],
};

pub(super) const LANTERN: Experiment = Experiment {
    id: "frisvad.lantern",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "few samples of a lantern in the cave against path tracing",
    setup: &InCode(cave),
    claims: &[NEARER, ARRIVES],
};

/// Least correlation of colours that passes for colour bleeding.
const ALIKE: f64 = 0.5;

/// Share of the truth's light that passes for comparable.
const ENOUGH: f64 = 0.5;

pub(super) fn cornell_box(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for lamp in ["area", "spot"] {
        let loaded = context.load(
            &ExperimentScene::of("cornell-box").set("light", lamp),
            &mut finding,
        )?;
        let view = context.view(&loaded)?;
        let points = view.points(Quantity::Irradiance.layout());
        let references = context.precise(&loaded, Quantity::Irradiance, &points);
        let case = format!("{lamp} light");
        let what = ("C1", &*case, &view, references);
        for light in compare(context, &loaded, what, &mut finding)? {
            finding.judge("C2", [enough(&case, &light)]);
            finding.judge("C3", [bleeds(&case, &light)]);
        }
    }
    Ok(finding)
}

pub(super) fn cave(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let loaded = context.load(&ExperimentScene::of("cave"), &mut finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let references = context.references(&loaded, Quantity::Irradiance, &points);
    let what = ("C1", "cave", &view, references);
    for light in compare(context, &loaded, what, &mut finding)? {
        finding.judge("C2", [enough("cave", &light)]);
    }
    Ok(finding)
}

/// That most of the truth's light arrives.
fn enough(case: &str, light: &Published) -> Trial {
    let what = format!("{case}: a half below the share of the truth's light");
    Trial::less(what, light.backend, Amount::exact(ENOUGH), light.energy)
}

/// That its colours are the truth's.
fn bleeds(case: &str, light: &Published) -> Trial {
    let what = format!("{case}: a half below the correlation of colours");
    Trial::less(what, light.backend, Amount::exact(ALIKE), light.alike)
}

/// That an estimate is nearer to the truth than no indirect light and, up to a factor on its brightness, than
/// uniform ambient light.
fn nearer(
    judge: &Judge<'_>,
    (case, backend): (&str, Backend),
    estimate: &Estimate,
    ambient: &Estimate,
) -> [Trial; 2] {
    let none = Estimate::new(estimate.len());
    let bright = scaled(estimate, judge.factor(estimate));
    let than_none = format!("{case}: nearer than direct light alone");
    let than_ambient = format!("{case}: nearer than uniform ambient light");
    [
        judge.nearer(than_none, backend, estimate, &none),
        judge.nearer(than_ambient, backend, &bright, ambient),
    ]
}

/// Light of the published map on a backend.
pub(super) struct Published {
    backend: Backend,
    /// Its sum over the truth's.
    energy: Amount,
    /// Correlation of its colours with the truth's.
    alike: Amount,
}

/// Compares maps of 3×3 samples in a scene that is set up with the truth and a uniform ambient light; its trials are
/// of a claim.
pub(super) fn compare(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    (claim, case, view, mut references): (&'static str, &str, &View, References<'_>),
    finding: &mut Finding,
) -> Result<Vec<Published>, RunError> {
    let mut published = Vec::new();
    let quantity = Quantity::Irradiance;
    let points = view.points(quantity.layout());
    let materials = view.points(PointLayout::Material);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let ambient = uniform(&truth.values, &points);
    let first = context.backends()[0];
    let direct = context.direct_light(loaded, first, view)?;
    let lit = |e: &Estimate| view.lit(&lambertian(&materials, e), &direct);
    let title = format!("{case}: direct and indirect light");
    let mut row = Row::against(title, "path tracing", lit(&truth.values), view.surfaces());
    row.add(
        "direct light alone",
        view.lit(&Estimate::new(points.len()), &direct),
    );
    row.add("best uniform ambient light", lit(&ambient));
    let mut alone = Row::plain(format!("{case}: indirect light alone"));
    alone.add(
        "path tracing",
        view.image(&lambertian(&materials, &truth.values)),
    );
    for backend in context.backends() {
        for fidelity in ["published", "corrected"] {
            let map = context.method("direct_radiance_map", &[("fidelity", &fidelity)])?;
            let measured = context.run_once(loaded, backend, &*map, quantity, &points)?;
            let estimate = &measured.estimate;
            let alike = Amount::exact(correlation(estimate, &truth.values));
            let energy =
                Amount::exact(sum(estimate).element_sum() / sum(&truth.values).element_sum());
            let error = judge.error(estimate);
            for (name, amount) in [
                (ERROR, error),
                ("energy", energy),
                ("correlation of colours", alike),
            ] {
                finding.measure((format!("{case}, {fidelity}"), name), backend, amount, "");
            }
            if backend == context.backends()[0] {
                row.add(fidelity, lit(estimate));
                alone.add(fidelity, view.image(&lambertian(&materials, estimate)));
            }
            if fidelity == "published" {
                let trials = nearer(&judge, (case, backend), estimate, &ambient);
                finding.judge(claim, trials);
                published.push(Published {
                    backend,
                    energy,
                    alike,
                });
            }
            finding.runs.push(measured.run);
        }
    }
    let at = (format!("{case}, uniform ambient light"), ERROR);
    finding.measure(at, context.backends()[0], judge.error(&ambient), "");
    finding.pictures.extend([row, alone]);
    Ok(published)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, of, signs};
    use super::*;

    #[test]
    fn light_has_to_beat_none_and_ambient_and_to_arrive_in_its_colours() {
        let truth = of(&[1.0, 2.0, 3.0, 2.0]);
        let (judge, ambient) = (exact(&truth), of(&[2.0; 4]));
        let judged =
            |estimate: &Estimate| signs(&nearer(&judge, ("", Backend::Cpu), estimate, &ambient));
        // Half as bright but of the right shape; then so bright that nothing would be nearer; then upside down.
        assert_eq!(judged(&of(&[0.5, 1.0, 1.5, 1.0])), "++");
        assert_eq!(judged(&of(&[9.0, 18.0, 27.0, 18.0])), "-+");
        assert_eq!(judged(&of(&[3.0, 2.0, 1.0, 2.0])), "+-");
        let light = |energy, alike| Published {
            backend: Backend::Gpu,
            energy: Amount::exact(energy),
            alike: Amount::exact(alike),
        };
        let both = |light: &Published| signs([&enough("", light), &bleeds("", light)]);
        assert_eq!(both(&light(0.51, 0.49)), "+-");
        assert_eq!(both(&light(0.49, 0.51)), "-+");
    }
}
