//! A level that is lowered so that a frame rate is held, and refined at rest.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::shot::amount_of;
use super::super::verdict::{Amount, Trial};
use super::directions;
use super::sequence::{DEFORMING, Moment, RESTING};
use crate::error::HarnessError;
use crate::record::Backend;
use crate::stages::Running;
use interreflect_estimators::Configured;
use interreflect_scene::{Estimate, Scene};

/// How far below the full level the frame rate is within reach.
const BELOW: u32 = 2;

/// How far over its time a frame may be.
const SLACK: f64 = 1.2;

/// Largest difference over the mean that passes for the full level's estimate.
const SAME: f64 = 1e-3;

/// Frames until the level has settled, while the model moves and at rest.
const SETTLED: usize = 4;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    let place = Place::of("studio")
        .with(&desk.mesh("dragon"))
        .set("receiver.deformation", "wave");
    let rest = desk.scene(&place, &mut finding)?;
    for backend in desk.backends() {
        held(desk, &rest, backend, &mut finding)?;
    }
    Ok(finding)
}

fn held(
    desk: &Desk<'_>,
    rest: &Scene,
    backend: Backend,
    finding: &mut Finding,
) -> Result<(), HarnessError> {
    let method = |level: u32, fps: f64| {
        desk.method(
            "directional_ao",
            &[
                ("level", &level),
                ("target_fps", &fps),
                ("map_resolution", &desk.pick(64, 256)),
            ],
        )
    };
    let (highest, frames) = desk.pick((2, 10), (3, 24));
    let full = method(highest, 0.0)?;
    let (full_ms, _) = moving(desk, rest, (backend, SETTLED + 3), &*full)?;
    let (low_ms, _) = moving(
        desk,
        rest,
        (backend, SETTLED + 3),
        &*method(highest - BELOW, 0.0)?,
    )?;
    // Between both on a logarithmic scale: the control needs room for a level and its costlier neighbour.
    let budget_ms = (full_ms.value * low_ms.value).sqrt();
    let controlled = method(highest, 1e3 / budget_ms)?;
    let (held_ms, mut running) = moving(desk, rest, (backend, frames), &*controlled)?;
    let last = Moment::of(desk, rest, time_of(frames - 1))?;
    let in_motion = last
        .shade(desk, (&mut running, backend), &*controlled, RESTING)?
        .estimate;
    let mut at_rest = in_motion.clone();
    // At rest a kept visibility costs next to nothing, so that each frame has room for the next level.
    for _ in 0..2 * SETTLED {
        at_rest = last
            .shade(desk, (&mut running, backend), &*controlled, RESTING)?
            .estimate;
    }
    let best = last
        .shade(desk, (&mut Running::default(), backend), &*full, RESTING)?
        .estimate;
    let left = difference(&at_rest, &best);
    let unit = ("ms", desk.software(backend));
    let at_level = |level| format!("frame at {} directions", directions(level));
    for (name, ms) in [
        (at_level(highest), full_ms),
        (at_level(highest - BELOW), low_ms),
        ("time for a frame".into(), Amount::exact(budget_ms)),
        ("controlled frame".into(), held_ms),
    ] {
        finding.time(("moving", name), backend, ms, unit);
    }
    let at = |name: &'static str| ("at rest", name);
    finding.measure(
        at("largest difference, first frame / mean"),
        backend,
        Amount::exact(difference(&in_motion, &best)),
        "",
    );
    finding.measure(
        at("largest difference, last frame / mean"),
        backend,
        Amount::exact(left),
        "",
    );
    let allowed = Amount::exact(SLACK * budget_ms);
    finding.trials.push(Trial::less(
        "controlled frame below 120 % of its time, ms",
        backend,
        held_ms,
        allowed,
    ));
    finding.trials.push(Trial::less(
        "120 % of its time below an uncontrolled frame, ms",
        backend,
        allowed,
        full_ms,
    ));
    let what = "at rest: largest difference from the full level, over the mean";
    finding
        .trials
        .push(Trial::less_by(what, backend, (left, SAME), 0.0));
    let mut row = Row::plain(format!("openness, {backend}"));
    for (caption, estimate) in [
        ("in motion", &in_motion),
        ("at rest", &at_rest),
        ("full level", &best),
    ] {
        row.add(caption, last.view.image(estimate));
    }
    finding.pictures.push(row);
    Ok(())
}

fn time_of(frame: usize) -> f32 {
    frame as f32 / 15.0
}

/// The settled frames' time while the model moves, and the session that showed them.
fn moving(
    desk: &Desk<'_>,
    rest: &Scene,
    (backend, frames): (Backend, usize),
    method: &dyn Configured,
) -> Result<(Amount, Running), HarnessError> {
    let (mut running, mut times) = (Running::default(), Vec::new());
    for index in 0..frames {
        let moment = Moment::of(desk, rest, time_of(index))?;
        times.push(
            moment
                .shade(desk, (&mut running, backend), method, DEFORMING)?
                .ms,
        );
    }
    Ok((amount_of(&times[SETTLED.min(times.len())..]), running))
}

/// Largest difference of two estimates over the mean of the second.
fn difference(a: &Estimate, b: &Estimate) -> f64 {
    let largest = a
        .iter()
        .zip(b.iter())
        .map(|(a, b)| (a - b).abs().max_element());
    let mean = b.iter().map(|v| v.element_sum() / 3.0).sum::<f32>() / b.len() as f32;
    f64::from(largest.fold(0.0, f32::max) / mean)
}
