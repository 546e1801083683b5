//! Which of two estimates is nearer to a reference that errs itself.
//!
//! Errors are mean squared ones over the square of the reference's mean. Unlike the relMSE of
//! [`crate::domain::metrics`] that lets what is nearly black count no more than the rest: folds and back faces
//! are as good as black in many of these scenes, and pictures are judged by what is bright.
//!
//! Both estimates are compared with the same reference, so most of its noise cancels: the difference
//! of their errors is Σ(a−b)(a+b−2r)/n, whose standard error from that of r, s, is 2·√(Σ((a−b)s)²)/n. The
//! channels of a point share their light paths and add up; points are independent. [`NOISE_DEVIATIONS`]
//! standard errors count as noise.

use super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::domain::significance::NOISE_DEVIATIONS;
use glam::DVec3;
use interreflect_conformance::own_model::ModelValues;
use interreflect_scene::{Estimate, Points};

/// A reference at the points that have a surface.
pub(super) struct Judge<'a> {
    reference: &'a Estimate,
    error: Option<&'a Estimate>,
    at: Vec<usize>,
    mean: f64,
}

/// What errors are called in tables and trials.
pub(super) const ERROR: &str = "MSE / mean²";

impl<'a> Judge<'a> {
    /// A reference with its standard error.
    pub(super) fn new(reference: &'a ModelValues, points: &Points) -> Self {
        let at = (0..points.len()).filter(|&i| points.get(i).is_some());
        Self::at(&reference.values, Some(&reference.error), at.collect())
    }

    /// A reference at some indices; without errors it is exact.
    pub(super) fn at(reference: &'a Estimate, error: Option<&'a Estimate>, at: Vec<usize>) -> Self {
        let magnitude = |i: &usize| reference.get(*i).as_dvec3().abs().element_sum() / 3.0;
        let mean = at.iter().map(magnitude).sum::<f64>() / at.len().max(1) as f64;
        Self {
            reference,
            error,
            at,
            mean: mean.max(f64::MIN_POSITIVE.sqrt()),
        }
    }

    /// Mean of the reference over points and channels.
    pub(super) fn mean(&self) -> f64 {
        self.mean_of(|i| self.r(i))
    }

    /// That estimate `a` is nearer to the reference than `b`, in mean squared error.
    pub(super) fn nearer(
        &self,
        what: impl Into<String>,
        backend: Backend,
        a: &Estimate,
        b: &Estimate,
    ) -> Trial {
        let between = self.deviation(|i| a.get(i).as_dvec3() - b.get(i).as_dvec3());
        let errors = (self.error(a).value, self.error(b).value);
        Trial::less_by(
            format!("{}, {}", what.into(), ERROR),
            backend,
            errors,
            between,
        )
    }

    /// Mean squared error over the squared mean, less what the reference's noise adds to it, with three standard
    /// errors of what this noise makes of it. It may be a little below 0.
    pub(super) fn error(&self, e: &Estimate) -> Amount {
        let difference = |i| e.get(i).as_dvec3() - self.r(i);
        Amount {
            value: self.mean_of(|i| difference(i).powf(2.0) - self.s(i).powf(2.0))
                / self.mean.powi(2),
            spread: self.deviation(difference),
        }
    }

    /// The factor that brings an estimate nearest to the reference.
    pub(super) fn factor(&self, e: &Estimate) -> f64 {
        let sum =
            |f: &dyn Fn(DVec3, DVec3) -> DVec3| self.mean_of(|i| f(e.get(i).as_dvec3(), self.r(i)));
        let square = sum(&|e, _| e * e);
        if square > 0.0 {
            sum(&|e, r| e * r) / square
        } else {
            1.0
        }
    }

    /// The largest excess of an estimate over the reference plus three standard errors, mean of the
    /// channels, in means of the reference; not below 0.
    pub(super) fn spike(&self, e: &Estimate) -> f64 {
        let excess = |&i: &usize| {
            let above = e.get(i).as_dvec3() - self.r(i) - NOISE_DEVIATIONS * self.s(i);
            above.element_sum() / 3.0
        };
        self.at.iter().map(excess).fold(0.0, f64::max) / self.mean()
    }

    /// Root mean square difference over the mean of the reference, less what the reference's noise
    /// adds to it.
    pub(super) fn relative_rms(&self, e: &Estimate) -> Amount {
        let difference = |i| e.get(i).as_dvec3() - self.r(i);
        let square = self.mean_of(|i| difference(i).powf(2.0) - self.s(i).powf(2.0));
        let value = square.max(0.0).sqrt() / self.mean;
        let doubt = self.deviation(difference);
        Amount {
            value,
            // Of a root, and of one that is 0.
            spread: (doubt / (2.0 * value)).min(doubt.sqrt()),
        }
    }

    fn r(&self, i: usize) -> DVec3 {
        self.reference.get(i).as_dvec3()
    }

    fn s(&self, i: usize) -> DVec3 {
        self.error.map_or(DVec3::ZERO, |e| e.get(i).as_dvec3())
    }

    fn mean_of(&self, value: impl Fn(usize) -> DVec3) -> f64 {
        let sum: f64 = self.at.iter().map(|&i| value(i).element_sum()).sum();
        sum / (3 * self.at.len().max(1)) as f64
    }

    /// Three standard errors of 2·mean(d·r)/mean² that the reference's noise causes.
    fn deviation(&self, difference: impl Fn(usize) -> DVec3) -> f64 {
        let of_point = |&i: &usize| (difference(i) * self.s(i)).abs().element_sum().powi(2);
        let variance: f64 = self.at.iter().map(of_point).sum();
        let values = (3 * self.at.len().max(1)) as f64;
        NOISE_DEVIATIONS * 2.0 * variance.sqrt() / values / self.mean.powi(2)
    }
}

/// An estimate times a factor.
pub(super) fn scaled(estimate: &Estimate, factor: f64) -> Estimate {
    let mut all = Estimate::new(estimate.len());
    for (i, value) in estimate.iter().enumerate() {
        all.set(i, value * factor as f32);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::verdict::Outcome;
    use super::*;
    use glam::Vec3;

    fn estimate(values: &[f32]) -> Estimate {
        let mut all = Estimate::new(values.len());
        for (i, v) in values.iter().enumerate() {
            all.set(i, Vec3::splat(*v));
        }
        all
    }

    #[test]
    fn what_is_nearer_is_told_unless_noise_hides_it() {
        let (reference, near, far) = (
            estimate(&[1.0; 9]),
            estimate(&[1.1; 9]),
            estimate(&[1.3; 9]),
        );
        for (error, outcome) in [
            (0.0, Outcome::Holds),
            (0.01, Outcome::Holds),
            (2.0, Outcome::Undecided),
        ] {
            let error = estimate(&[error; 9]);
            let judge = Judge::at(&reference, Some(&error), (0..9).collect());
            assert_eq!(judge.nearer("", Backend::Cpu, &near, &far).outcome, outcome);
        }
        let exact = Judge::at(&reference, None, (0..9).collect());
        assert_eq!(
            exact.nearer("", Backend::Cpu, &far, &near).outcome,
            Outcome::Fails
        );
        assert!((exact.error(&near).value - 0.01).abs() < 1e-4);
        let rms = exact.relative_rms(&far);
        assert!((rms.value - 0.3).abs() < 1e-6 && rms.spread == 0.0);
        let noisy = estimate(&[0.3; 9]);
        let judge = Judge::at(&reference, Some(&noisy), (0..9).collect());
        assert!(
            judge.relative_rms(&far).value < 1e-3,
            "all of it may be noise"
        );
        let trial = exact.nearer("this", Backend::Cpu, &near, &far);
        assert_eq!(trial.what, "this, MSE / mean²");
    }

    /// Errors of ±1, of which the reference's own noise is .9² in the mean: what is left tells the estimates apart.
    #[test]
    fn the_references_noise_is_no_error_of_an_estimate() {
        let reference = estimate(&[2.0, 4.0, 2.0, 4.0]);
        let noise = estimate(&[0.9; 4]);
        let judge = Judge::at(&reference, Some(&noise), (0..4).collect());
        let (near, far) = (estimate(&[3.0; 4]), estimate(&[1.0, 5.0, 1.0, 5.0]));
        let mean2 = 9.0;
        for e in [&near, &far] {
            let left = judge.error(e).value * mean2;
            // Roundings of .9² in float32.
            assert!((left - (1.0 - 0.81)).abs() < 1e-6, "{left}");
        }
        // Thrice the error above the noise is not within twice of it.
        let thrice = judge.error(&estimate(&[
            2.0 + 1.38_f32.sqrt(),
            4.0 + 1.38_f32.sqrt(),
            2.0 + 1.38_f32.sqrt(),
            4.0 + 1.38_f32.sqrt(),
        ]));
        assert!(thrice.value > 2.0 * judge.error(&near).value);
    }

    #[test]
    fn a_factor_takes_a_scale_away_and_spikes_are_the_largest_excess() {
        let reference = estimate(&[1.0, 2.0, 3.0]);
        let judge = Judge::at(&reference, None, vec![0, 1, 2]);
        let double = estimate(&[2.0, 4.0, 6.0]);
        let factor = judge.factor(&double);
        assert!((factor - 0.5).abs() < 1e-6);
        assert!(judge.error(&scaled(&double, factor)).value < 1e-12);
        assert!((judge.spike(&double) - 1.5).abs() < 1e-6);
        assert_eq!(judge.spike(&estimate(&[0.0; 3])), 0.0);
    }
}
