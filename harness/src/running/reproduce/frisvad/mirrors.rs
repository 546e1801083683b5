//! What mirrors show of indirect light: nothing, a trick, or what is there.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{Judge, scaled};
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::{Look, Mirrors, ShadedAt, View, lambertian};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Estimate, PointLayout};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.mirrors",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "mirrors in the cave without, with faked and with indirect light",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Treating a mirror as diffuse hides that indirect light is missing in it.",
            rule: "A trial is a backend: at the pixels of mirrors the trick is nearer to the picture \
                with path-traced light than nothing is, in mean squared error beyond the reference's \
                noise. Indirect light of all pictures is brought to the truth's by one factor, from \
                all surfaces that are seen.",
        },
        Claim {
            id: "C2",
            says: "Light estimated at the surfaces seen in a mirror is right.",
            rule: "A trial is a backend: as before, of included light against the trick.",
        },
    ],
};

/// The figure's pictures.
const SHOWN: [(&str, Mirrors); 3] = [
    ("(a) none", Mirrors::Direct),
    ("(b) trick", Mirrors::Diffuse),
    ("(c) included", Mirrors::Included),
];

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let loaded = context.load(&ExperimentScene::of("cave"), &mut finding)?;
    let mut views = Vec::new();
    for (name, mirrors) in SHOWN {
        let view = look(context, &loaded, mirrors)?;
        // The same for all: only indirect light is compared.
        let direct = context.direct_light(&loaded, Backend::Cpu, &view)?;
        views.push((name, view, direct));
    }
    let (direct, included) = (&views[0].1, &views[2].1);
    let under_included = &views[2].2;
    // Where only light in mirrors makes the difference.
    let plain = direct.surfaces();
    let mirrored = included.surfaces().into_iter().enumerate();
    let at: Vec<usize> = mirrored
        .filter(|&(i, shows)| shows && !plain[i])
        .map(|(i, _)| i)
        .collect();
    let points = included.points(Quantity::Irradiance.layout());
    let mut references = context.references(&loaded, Quantity::Irradiance, &points);
    let truth = references.truth();
    let reference = lit((included, under_included), &truth.values);
    let materials = included.points(PointLayout::Material);
    let error = included.image(&lambertian(&materials, &truth.error));
    let (values, errors) = (reference.to_estimate(), error.to_estimate());
    let judge = Judge::at(&values, Some(&errors), at);
    let mut row = Row::against(
        "a mirror and a mirror ball",
        "path tracing",
        reference,
        included.surfaces(),
    );
    let everywhere = Judge::new(truth, &points);
    for backend in context.backends() {
        let mut pictures = Vec::new();
        // Few samples are too dark in mirrors and beside them alike.
        let plain = shoot(context, &loaded, (included, backend), &mut finding)?;
        let factor = everywhere.factor(&plain);
        for (name, view, direct) in &views {
            let light = shoot(context, &loaded, (view, backend), &mut finding)?;
            let image = lit((view, direct), &scaled(&light, factor));
            let error = judge.error(&image.to_estimate());
            finding.measure((*name, "MSE / mean² in mirrors"), backend, error, "");
            let shaded = Amount::exact(view.points(PointLayout::Surface).len() as f64);
            finding.measure((*name, "points"), backend, shaded, "");
            pictures.push(image.to_estimate());
            if backend == context.backends()[0] {
                row.add(*name, image);
            }
        }
        let steps = steps(&judge, backend, &pictures);
        for (claim, step) in ["C1", "C2"].into_iter().zip(steps) {
            finding.judge(claim, [step]);
        }
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That each of the figure's pictures is nearer to the reference than the one before.
fn steps(judge: &Judge<'_>, backend: Backend, pictures: &[Estimate]) -> Vec<Trial> {
    let names = ["(b) nearer than (a)", "(c) nearer than (b)"];
    let pairs = pictures.windows(2).zip(names);
    let nearer =
        |(pair, what): (&[Estimate], &str)| judge.nearer(what, backend, &pair[1], &pair[0]);
    pairs.map(nearer).collect()
}

fn look(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    mirrors: Mirrors,
) -> Result<View, RunError> {
    let look = Look {
        at: ShadedAt::Pixels,
        mirrors,
        ..Look::default()
    };
    context.whole_view(loaded, context.pick(180, 640), look)
}

fn shoot(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    (view, backend): (&View, Backend),
    finding: &mut Finding,
) -> Result<Estimate, RunError> {
    let map = context.method(
        "direct_radiance_map",
        &[("fidelity", &"corrected"), ("samples_per_side", &5)],
    )?;
    let points = view.points(Quantity::Irradiance.layout());
    let measured = context.run_once(loaded, backend, &*map, Quantity::Irradiance, &points)?;
    finding.runs.push(measured.run);
    Ok(measured.estimate)
}

fn lit((view, direct): (&View, &Estimate), irradiance: &Estimate) -> HdrImage {
    let materials = view.points(PointLayout::Material);
    view.lit(&lambertian(&materials, irradiance), direct)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn each_picture_has_to_be_nearer_than_the_one_before() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let judged = |values: [f32; 3]| signs(&steps(&judge, Backend::Cpu, &values.map(flat)));
        assert_eq!(judged([0.0, 0.5, 0.9]), "++");
        assert_eq!(judged([0.9, 0.5, 0.0]), "--");
        assert_eq!(judged([0.0, 0.9, 0.5]), "+-");
    }
}
