//! A kept cube map while the object moves away from where it was made, or has a neighbour.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::verdict::Trial;
use crate::error::HarnessError;
use interreflect_estimators::Quantity;

/// Metres that the object has moved since the map was made.
const MOVED_M: [f32; 5] = [0.0, 0.125, 0.25, 0.4, 0.55];

/// Metres up to which a kept map has to do.
const NEAR_M: f32 = 0.25;

/// Largest factor on the error that counts as serving as well.
const WORSE: f64 = 2.0;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    for moved in MOVED_M {
        compare(desk, (moved, 1), &mut finding)?;
    }
    compare(desk, (0.0, 2), &mut finding)?;
    Ok(finding)
}

fn compare(
    desk: &Desk<'_>,
    (moved, receivers): (f32, u32),
    finding: &mut Finding,
) -> Result<(), HarnessError> {
    let quantity = Quantity::Irradiance;
    let model = desk.mesh("bunny");
    let place = Place::of("colored-room")
        .with(&model)
        .set("receiver.size", 0.5)
        .set("receiver.moved", moved)
        .set("receivers", receivers);
    let room = desk.room(&place, finding)?;
    let view = desk.view(&room)?;
    let points = view.points(quantity.layout());
    let mut references = desk.references(&room, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let case = match receivers {
        1 => format!("moved {moved} m"),
        n => format!("{n} objects"),
    };
    let mut row = Row::against(&*case, "truth", view.image(&truth.values), view.surfaces());
    for backend in desk.backends() {
        let mut shots = Vec::new();
        // Captures count as kept within a distance, even one of 0; without one they are fresh.
        for (label, within) in [("fresh", 0.0), ("kept", 1.0)] {
            let method = desk.method(
                "localized_cubemap",
                &[("resolution", &8), ("bounces", &4), ("recapture_distance", &within)],
            )?;
            let shot = desk.shot(&room, backend, &*method, quantity, &points)?;
            let (relmse, ms) = (judge.relmse(&shot.estimate), shot.frame_ms());
            finding.measure((&*case, format!("relMSE {label}")), backend, relmse, "");
            let unit = ("ms", shot.run.software);
            finding.time((&*case, format!("frame {label}")), backend, ms, unit);
            finding.runs.push(shot.run);
            if backend == desk.backends()[0] {
                row.add(label, view.image(&shot.estimate));
            }
            shots.push((ms, relmse));
        }
        if let [(fresh_ms, fresh), (kept_ms, kept)] = shots[..] {
            let time = format!("{case}: frame with a kept map below that with a fresh one, ms");
            finding.trials.push(Trial::less(time, backend, kept_ms, fresh_ms));
            if moved <= NEAR_M {
                let error = format!("{case}: relMSE of a kept map below {WORSE} of a fresh one's");
                finding.trials.push(Trial::less(error, backend, kept, fresh.times(WORSE)));
            }
        }
    }
    finding.pictures.push(row);
    Ok(())
}
