//! What polygons cost beside points and classic mapping.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;

/// Largest factor between polygons and points: the talk's is 60 to 11.
const DEARER: f64 = 10.0;

/// Milliseconds of shading that are interactive.
const INTERACTIVE_MS: f64 = 100.0;

/// The methods, from the cheapest to the dearest.
const METHODS: [(&str, &str); 3] = [
    ("classic", "classic_envmap"),
    ("points", "point_form_factor"),
    ("polygons", "polygon_form_factor"),
];

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let place = ExperimentScene::of("colored-room")
        .set("reference.offset", 0)
        .with(&context.mesh("dragon"))
        .set("receiver.size", 0.9);
    let loaded = context.load(&place, &mut finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let mut references = context.references(&loaded, Quantity::Irradiance, &points);
    let truth = references.truth();
    let mut row = Row::rendered("irradiance, M = 4", "path tracing", &view, &truth.values);
    for backend in context.backends() {
        let software = context.software(backend);
        let mut shade = Vec::new();
        for (label, id) in METHODS {
            let method = context.method(id, &[("bounces", &4)])?;
            let measured =
                context.run_timed(&loaded, backend, &*method, Quantity::Irradiance, &points)?;
            for (name, ms) in [
                ("preparing", measured.prepare_ms()),
                ("shading", measured.shade_ms()),
                ("frame with a fresh map", measured.frame_ms()),
            ] {
                finding.time((label, name), backend, ms, ("ms", software));
            }
            shade.push(measured.shade_ms());
            if backend == context.backends()[0] {
                row.add(label, view.image(&measured.estimate));
            }
            finding.runs.push(measured.run);
        }
        let ratio = shade[2].over(shade[1]);
        finding.time(
            ("polygons", "times as long as points"),
            backend,
            ratio,
            ("", software),
        );
        let [polygons, points, limit, interactive] =
            judged(backend, [shade[0], shade[1], shade[2]]);
        finding.judge("C1", [polygons, points]);
        finding.judge("C2", [limit]);
        finding.judge("C3", [interactive]);
    }
    finding.pictures.push(row);
    Ok(finding)
}

/// That the methods cost ever more, but neither ten times as much nor more than is interactive.
fn judged(backend: Backend, [classic, points, polygons]: [Amount; 3]) -> [Trial; 4] {
    let dearer = format!("shading by polygons below {DEARER} times that by points, ms");
    let interactive = Amount::exact(INTERACTIVE_MS);
    let below = |what: &str, a, b| Trial::less(what, backend, a, b);
    [
        below("shading by points below polygons, ms", points, polygons),
        below(
            "shading by classic mapping below points, ms",
            classic,
            points,
        ),
        below(&dearer, polygons, points.times(DEARER)),
        below("shading by polygons below 100 ms", polygons, interactive),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn polygons_are_dearer_within_limits() {
        let judged = |ms: [f64; 3]| signs(&judged(Backend::Cpu, ms.map(about)));
        assert_eq!(judged([1.0, 10.0, 60.0]), "++++");
        assert_eq!(judged([30.0, 10.0, 130.0]), "+---");
        assert_eq!(judged([1.0, 10.0, 5.0]), "-+++");
        // Dearest in the order of shading.
        let ids = METHODS.map(|(_, id)| id);
        assert_eq!(
            ids,
            ["classic_envmap", "point_form_factor", "polygon_form_factor"]
        );
    }
}
