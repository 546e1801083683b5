//! Frame rates over samples and triangles.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::Shade;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.rates",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "frame rates over samples and triangles",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "More samples take longer.",
            rule: "A trial is a scene and a backend: a frame of 5×5 samples takes longer than one of \
                2×2, beyond the spread of both. Frames hold capture, preparation and shading at as \
                many points.",
        },
        Claim {
            id: "C2",
            says: "More triangles take longer.",
            rule: "A trial is a number of samples and a backend: a frame of the scene of most \
                triangles takes longer than one of the fewest, beyond the spread of both.",
        },
        Claim {
            id: "C3",
            says: "Frames are interactive.",
            rule: "A trial is a scene and a backend: a frame of 5×5 samples takes less than a second.",
        },
    ],
};

/// Samples along the edge of the grid.
const SAMPLES: [u32; 4] = [2, 3, 4, 5];

/// Milliseconds of a frame that is still interactive.
const INTERACTIVE_MS: f64 = 1000.0;

/// A scene's name and the number of its triangles, with the times of a frame for each number of samples.
type Column = (String, usize, Vec<Amount>);

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let mut columns: Vec<(Backend, Vec<Column>)> = context
        .backends()
        .into_iter()
        .map(|b| (b, Vec::new()))
        .collect();
    for model in [None, Some("dragon"), Some("dragon_871k")] {
        let (name, loaded) = in_the_box(context, model, &mut finding)?;
        let scene = loaded.scene();
        let triangles = scene.objects.iter().map(|o| o.mesh.triangles.len()).sum();
        for (backend, columns) in &mut columns {
            let times = times(context, &loaded, (&name, *backend), &mut finding)?;
            columns.push((name.clone(), triangles, times));
        }
    }
    for (backend, columns) in columns {
        judge(backend, &columns, &mut finding);
    }
    Ok(finding)
}

/// The Cornell box with a model in it.
fn in_the_box<'a>(
    context: &ExperimentContext<'a>,
    model: Option<&str>,
    finding: &mut Finding,
) -> Result<(String, LoadedScene), RunError> {
    let (name, place) = match model.map(|name| context.mesh(name)) {
        Some(model) => (
            model.name.clone(),
            ExperimentScene::of("cornell-box")
                .with(&model)
                .set("receiver.size", 0.25),
        ),
        None => ("box alone".into(), ExperimentScene::of("cornell-box")),
    };
    Ok((name, context.load(&place, finding)?))
}

fn times(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    (name, backend): (&str, Backend),
    finding: &mut Finding,
) -> Result<Vec<Amount>, RunError> {
    let view = context.view_of(loaded, (context.points(), Shade::All))?;
    let points = view.points(Quantity::Irradiance.layout());
    let software = context.software(backend);
    let mut all = Vec::new();
    for n in SAMPLES {
        let map = context.method("direct_radiance_map", &[("samples_per_side", &n)])?;
        let measured = context.run_timed(loaded, backend, &*map, Quantity::Irradiance, &points)?;
        let ms = measured.frame_ms();
        let rate = Amount::exact(1000.0).over(ms);
        finding.time(
            (name, format!("{n}×{n} frame")),
            backend,
            ms,
            ("ms", software),
        );
        finding.time(
            (name, format!("{n}×{n}")),
            backend,
            rate,
            ("frames/s", software),
        );
        finding.runs.push(measured.run);
        all.push(ms);
    }
    Ok(all)
}

fn judge(backend: Backend, columns: &[Column], finding: &mut Finding) {
    for (name, triangles, times) in columns {
        let count = Amount::exact(*triangles as f64);
        finding.measure((name.as_str(), "triangles"), backend, count, "");
        if let [first, .., last] = times[..] {
            let what = format!("{name}: a frame of 2×2 samples below one of 5×5, ms");
            finding.judge("C1", [Trial::less(what, backend, first, last)]);
            let what = format!("{name}: a frame of 5×5 samples below a second, ms");
            let second = Amount::exact(INTERACTIVE_MS);
            finding.judge("C3", [Trial::less(what, backend, last, second)]);
        }
    }
    let fewest = columns.iter().min_by_key(|c| c.1);
    let most = columns.iter().max_by_key(|c| c.1);
    if let (Some(fewest), Some(most)) = (fewest, most) {
        for (i, n) in SAMPLES.into_iter().enumerate() {
            let what = format!(
                "{n}×{n} samples: a frame of {} below one of {}, ms",
                fewest.0, most.0
            );
            let trial = Trial::less(what, backend, fewest.2[i], most.2[i]);
            finding.judge("C2", [trial]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn frames_take_longer_by_samples_and_triangles_and_less_than_a_second() {
        let judged = |few: [f64; 4], many: [f64; 4]| {
            let mut finding = Finding::default();
            let column = |name: &str, triangles, ms: [f64; 4]| {
                (name.to_owned(), triangles, ms.map(about).to_vec())
            };
            let columns = [column("many", 900, many), column("few", 9, few)];
            judge(Backend::Cpu, &columns, &mut finding);
            assert_eq!(finding.measured[0].value, 900.0);
            ["C1", "C2", "C3"].map(|claim| signs(finding.trials_of(claim)))
        };
        let (few, many) = ([100.0, 200.0, 300.0, 400.0], [500.0, 600.0, 700.0, 800.0]);
        assert_eq!(judged(few, many), ["++", "++++", "++"]);
        let (few, many) = (
            [5000.0, 4000.0, 3000.0, 2000.0],
            [1000.0, 900.0, 800.0, 700.0],
        );
        assert_eq!(judged(few, many), ["--", "----", "+-"]);
    }
}
