//! Estimates and times made up, for the tests of each experiment's rule: both ways.

use super::judge::Judge;
use super::verdict::{Amount, Outcome, Trial};
use glam::Vec3;
use interreflect_scene::Estimate;

/// The same grey at four points.
pub(super) fn flat(value: f32) -> Estimate {
    of(&[value; 4])
}

/// These greys.
pub(super) fn of(values: &[f32]) -> Estimate {
    let mut estimate = Estimate::new(values.len());
    for (i, value) in values.iter().enumerate() {
        estimate.set(i, Vec3::splat(*value));
    }
    estimate
}

/// An exact reference at all of its points.
pub(super) fn exact(reference: &Estimate) -> Judge<'_> {
    Judge::at(reference, None, (0..reference.len()).collect())
}

/// A time, or another number, that may be off by a tenth of it.
pub(super) fn about(value: f64) -> Amount {
    Amount {
        value,
        spread: 0.1 * value,
    }
}

/// What became of each trial: `+` holds, `-` fails, `?` undecided.
pub(super) fn signs<'a>(trials: impl IntoIterator<Item = &'a Trial>) -> String {
    let sign = |trial: &Trial| match trial.outcome {
        Outcome::Holds => '+',
        Outcome::Fails => '-',
        Outcome::Undecided => '?',
    };
    trials.into_iter().map(sign).collect()
}
