//! What polygons cost beside points and classic mapping.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::verdict::{Amount, Trial};
use crate::error::HarnessError;
use interreflect_estimators::Quantity;

/// Largest factor between polygons and points: the talk's is 60 to 11.
const DEARER: f64 = 10.0;

/// Milliseconds of a frame that is interactive.
const INTERACTIVE_MS: f64 = 100.0;

/// The methods, from the cheapest to the dearest.
const METHODS: [(&str, &str); 3] = [
    ("classic", "classic_envmap"),
    ("points", "point_form_factor"),
    ("polygons", "polygon_form_factor"),
];

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    let place = Place::of("colored-room").with(&desk.mesh("dragon")).set("receiver.size", 0.9);
    let room = desk.room(&place, &mut finding)?;
    let view = desk.view(&room)?;
    let points = view.points(Quantity::Irradiance.layout());
    let mut references = desk.references(&room, Quantity::Irradiance, &points);
    let truth = references.truth();
    let mut row = Row::against("irradiance, M = 4", "path tracing", view.image(&truth.values), view.surfaces());
    for backend in desk.backends() {
        let software = desk.software(backend);
        let (mut shade, mut frame) = (Vec::new(), Vec::new());
        for (label, id) in METHODS {
            let method = desk.method(id, &[("bounces", &4)])?;
            let shot = desk.timed_shot(&room, backend, &*method, Quantity::Irradiance, &points)?;
            let (prepare, shading) = (shot.prepare_ms(), shot.shade_ms());
            let kept = Amount {
                value: prepare.value + shading.value,
                spread: prepare.spread.hypot(shading.spread),
            };
            finding.time((label, "shading"), backend, shading, ("ms", software));
            finding.time((label, "frame with a kept map"), backend, kept, ("ms", software));
            finding.time((label, "frame with a fresh map"), backend, shot.frame_ms(), ("ms", software));
            shade.push(shading);
            frame.push(kept);
            if backend == desk.backends()[0] {
                row.add(label, view.image(&shot.estimate));
            }
            finding.runs.push(shot.run);
        }
        let ratio = shade[2].over(shade[1]);
        finding.time(("polygons", "times as long as points"), backend, ratio, ("", software));
        for (i, j, what) in [(1, 2, "points below polygons, ms"), (0, 1, "classic mapping below points, ms")] {
            finding.trials.push(Trial::less(format!("shading by {what}"), backend, shade[i], shade[j]));
        }
        let what = format!("shading by polygons below {DEARER} times that by points, ms");
        finding.trials.push(Trial::less(what, backend, shade[2], shade[1].times(DEARER)));
        let what = "frame of polygons with a kept map below 100 ms";
        finding.trials.push(Trial::less(what, backend, frame[2], Amount::exact(INTERACTIVE_MS)));
    }
    finding.pictures.push(row);
    Ok(finding)
}
