//! Openness over the number of directions.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::verdict::{Amount, Trial};
use super::directions;
use crate::error::HarnessError;
use interreflect_estimators::Quantity;

/// The level of a few hundred directions.
const ENOUGH: u32 = 3;

/// Largest rms difference over the mean that is enough.
const NEAR: f64 = 0.05;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    let quantity = Quantity::AmbientOcclusion;
    let room = desk.room(
        &Place::of("studio").with(&desk.mesh("buddha")),
        &mut finding,
    )?;
    let view = desk.view(&room)?;
    let points = view.points(quantity.layout());
    let mut references = desk.precise(&room, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::against(
        "openness",
        "traced rays",
        view.image(&truth.values),
        view.surfaces(),
    );
    for backend in desk.backends() {
        let mut estimates = Vec::new();
        for level in 0..=desk.pick(3, 4) {
            let k = directions(level);
            let method = desk.method(
                "directional_ao",
                &[("level", &level), ("map_resolution", &desk.pick(192, 512))],
            )?;
            let shot = desk.shot(&room, backend, &*method, quantity, &points)?;
            let rms = judge.relative_rms(&shot.estimate);
            let case = format!("k = {k}");
            finding.measure((&*case, ERROR), backend, judge.error(&shot.estimate), "");
            finding.measure((&*case, "rms difference / mean"), backend, rms, "");
            if level == ENOUGH {
                let what = format!("{case}: rms difference over mean");
                finding
                    .trials
                    .push(Trial::less(what, backend, rms, Amount::exact(NEAR)));
            }
            if backend == desk.backends()[0] {
                row.add(case, view.image(&shot.estimate));
            }
            estimates.push((k, shot.estimate));
            finding.runs.push(shot.run);
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
