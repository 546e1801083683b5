//! A level that is lowered so that a frame rate is held, and refined at rest.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::measured_run::amount_of;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::directions;
use super::sequence::{DEFORMING, Moment, RESTING};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use interreflect_estimators::Configured;
use interreflect_scene::{Estimate, Scene};
use serde::Serialize;

/// How far below the full level the frame rate is within reach.
const BELOW: u32 = 2;

/// How far over its time a frame may be.
const SLACK: f64 = 1.2;

/// Largest difference over the mean that passes for the full level's estimate.
const SAME: f64 = 1e-3;

/// Frames until the level has settled, while the model moves and at rest.
const SETTLED: usize = 4;

/// A model that moves and then rests.
#[derive(Serialize)]
pub(super) struct FrameRate {
    pub(super) scene: SceneSetup,
}

impl Runs for FrameRate {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let rest = context.scene(&context.place(&self.scene), &mut finding)?;
        for backend in context.backends() {
            held(context, &rest, backend, &mut finding)?;
        }
        Ok(finding)
    }
}

/// What came of a frame rate on a backend.
struct Held {
    full_ms: Amount,
    low_ms: Amount,
    /// The frame rate's time for a frame.
    budget_ms: f64,
    held_ms: Amount,
    /// Captions and estimates: the first frame at rest, the last one, and the full level's.
    shown: [(&'static str, Estimate); 3],
}

fn held(
    context: &ExperimentContext<'_>,
    rest: &Scene,
    backend: Backend,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let (highest, frames) = context.pick((2, 10), (3, 24));
    let last = Moment::of(context, rest, time_of(frames - 1))?;
    let held = measure(context, (rest, &last), (backend, frames), highest)?;
    let unit = ("ms", context.software(backend));
    let at_level = |level| format!("frame at {} directions", directions(level));
    for (name, ms) in [
        (at_level(highest), held.full_ms),
        (at_level(highest - BELOW), held.low_ms),
        ("time for a frame".into(), Amount::exact(held.budget_ms)),
        ("controlled frame".into(), held.held_ms),
    ] {
        finding.time(("moving", name), backend, ms, unit);
    }
    let [first, settled, (_, best)] = &held.shown;
    for (caption, estimate) in [first, settled] {
        let name = format!("largest difference, {caption} / mean");
        let left = Amount::exact(difference(estimate, best));
        finding.measure(("at rest", name), backend, left, "");
    }
    let left = difference(&settled.1, best);
    let times = (held.held_ms, held.full_ms);
    let [controlled, without, rested] = judged(backend, held.budget_ms, times, left);
    finding.judge("C1", [controlled, without]);
    finding.judge("C2", [rested]);
    let mut row = Row::plain(format!("openness, {backend}"));
    for (caption, estimate) in &held.shown {
        row.add(*caption, last.view.image(estimate));
    }
    finding.pictures.push(row);
    Ok(())
}

/// That the controlled frame keeps to its time, the uncontrolled one does not, and at rest the full level's
/// estimate is reached.
fn judged(
    backend: Backend,
    budget_ms: f64,
    (held_ms, full_ms): (Amount, Amount),
    left: f64,
) -> [Trial; 3] {
    let allowed = Amount::exact(SLACK * budget_ms);
    let held = "controlled frame below 120 % of its time, ms";
    let without = "120 % of its time below an uncontrolled frame, ms";
    let rest = "at rest: largest difference from the full level, over the mean";
    [
        Trial::less(held, backend, held_ms, allowed),
        Trial::less(without, backend, allowed, full_ms),
        Trial::less_by(rest, backend, (left, SAME), 0.0),
    ]
}

fn measure(
    context: &ExperimentContext<'_>,
    (rest, last): (&Scene, &Moment),
    (backend, frames): (Backend, usize),
    highest: u32,
) -> Result<Held, RunError> {
    let method = |level: u32, fps: f64| {
        let texels = context.pick(64, 256);
        context.method(
            "directional_ao",
            &[
                ("level", &level),
                ("target_fps", &fps),
                ("map_resolution", &texels),
            ],
        )
    };
    let (full, low) = (method(highest, 0.0)?, method(highest - BELOW, 0.0)?);
    let (full_ms, _) = moving(context, rest, (backend, SETTLED + 3), &*full)?;
    let (low_ms, _) = moving(context, rest, (backend, SETTLED + 3), &*low)?;
    // Between both on a logarithmic scale: there is room for a level, and none for the one above it.
    let budget_ms = (full_ms.value * low_ms.value).sqrt();
    let controlled = method(highest, 1e3 / budget_ms)?;
    let (held_ms, mut running) = moving(context, rest, (backend, frames), &*controlled)?;
    let at_rest = |running: &mut Sequence, method: &dyn Configured| {
        let shaded = last.shade(context, (running, backend), method, RESTING)?;
        Ok::<_, RunError>(shaded.estimate)
    };
    let first = at_rest(&mut running, &*controlled)?;
    // Each frame at rest takes the next level's own directions only, or none at all.
    let mut settled = first.clone();
    for _ in 0..2 * SETTLED {
        settled = at_rest(&mut running, &*controlled)?;
    }
    let best = at_rest(&mut Sequence::default(), &*full)?;
    Ok(Held {
        full_ms,
        low_ms,
        budget_ms,
        held_ms,
        shown: [
            ("first frame", first),
            ("last frame", settled),
            ("full level", best),
        ],
    })
}

fn time_of(frame: usize) -> f32 {
    frame as f32 / 15.0
}

/// The settled frames' time while the model moves, and the session that showed them.
fn moving(
    context: &ExperimentContext<'_>,
    rest: &Scene,
    (backend, frames): (Backend, usize),
    method: &dyn Configured,
) -> Result<(Amount, Sequence), RunError> {
    let (mut running, mut times) = (Sequence::default(), Vec::new());
    for index in 0..frames {
        let moment = Moment::of(context, rest, time_of(index))?;
        times.push(
            moment
                .shade(context, (&mut running, backend), method, DEFORMING)?
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

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, of, signs};
    use super::*;

    #[test]
    fn a_frame_rate_is_held_within_a_fifth_and_rest_refines() {
        let judged = |held, full, left| {
            signs(&judged(
                Backend::Cpu,
                10.0,
                (about(held), about(full)),
                left,
            ))
        };
        assert_eq!(judged(10.0, 14.0, 0.9e-3), "+++");
        assert_eq!(judged(14.0, 10.0, 1.1e-3), "---");
        assert_eq!(judged(11.5, 12.5, 0.0), "??+");
        // Two levels below are a sixteenth of the directions, but for the two that all have.
        assert_eq!((directions(3) - 2) / (directions(3 - BELOW) - 2), 16);
    }

    #[test]
    fn differences_are_the_largest_over_the_mean_of_the_second() {
        let (a, b) = (of(&[1.0, 2.0, 3.0]), of(&[1.0, 2.5, 2.5]));
        assert!((difference(&a, &b) - 0.25).abs() < 1e-6);
    }
}
