//! Which of two pictures looks more like a reference that errs itself: by FLIP, on the pixels of a surface.

use super::verdict::Trial;
use crate::domain::image::{Exposure, HdrImage};
use crate::domain::metrics::flip;
use crate::domain::record::Backend;
use crate::domain::significance::NOISE_DEVIATIONS;
use crate::running::view::View;
use interreflect_scene::Estimate;

/// What differences in looks are called in tables and trials.
pub(super) const LOOKS: &str = "mean FLIP";

/// What differences of pictures as they are shown are called.
pub(super) const SHOWN: &str = "rms of pictures / white";

/// A reference as it is shown, and the same off by a standard error at each point, towards either side at random.
pub(super) struct Viewer<'a> {
    view: &'a View,
    surfaces: Vec<bool>,
    reference: HdrImage,
    off: Vec<HdrImage>,
}

impl<'a> Viewer<'a> {
    /// A reference at the points of a view; without a standard error it is exact.
    pub(super) fn new(view: &'a View, reference: &Estimate, error: Option<&Estimate>) -> Self {
        let off = |error: &Estimate, sign: f32| {
            let (mut random, mut all) = (fastrand::Rng::with_seed(1), reference.clone());
            for i in 0..all.len() {
                let side = if random.bool() { sign } else { -sign };
                all.set(i, reference.get(i) + error.get(i) * side);
            }
            view.image(&all)
        };
        Self {
            view,
            surfaces: view.surfaces(),
            reference: view.image(reference),
            off: error.map_or(Vec::new(), |e| vec![off(e, 1.0), off(e, -1.0)]),
        }
    }

    /// Mean FLIP of an estimate over the surface.
    pub(super) fn difference(&self, estimate: &Estimate) -> f64 {
        self.from(&self.reference, estimate)
    }

    /// That an estimate `a` differs by less than `b` does. Noise is what the difference of both
    /// changes by where the reference is off by as many standard errors as count as noise.
    pub(super) fn nearer(
        &self,
        what: impl Into<String>,
        backend: Backend,
        (a, b): (&Estimate, &Estimate),
    ) -> Trial {
        let pair = |image| (self.from(image, a), self.from(image, b));
        let (of_a, of_b) = pair(&self.reference);
        let change = |image| {
            let (a, b) = pair(image);
            ((a - b) - (of_a - of_b)).abs()
        };
        let change = self.off.iter().map(change).fold(0.0, f64::max);
        let what = format!("{}, {LOOKS}", what.into());
        Trial::less_by(what, backend, (of_a, of_b), NOISE_DEVIATIONS * change)
    }

    /// Root mean square difference of an estimate's picture and the reference's as they are shown, clipped and encoded,
    /// where the surface is seen; white is 1.
    pub(super) fn shown_rms(&self, estimate: &Estimate) -> f64 {
        shown_rms(&self.surfaces, &self.view.image(estimate), &self.reference)
    }

    fn from(&self, image: &HdrImage, estimate: &Estimate) -> f64 {
        let shown = self.view.image(estimate);
        flip(&shown, image, |i| self.surfaces[i]).map_or(f64::NAN, |f| f.mean)
    }
}

fn shown_rms(surfaces: &[bool], a: &HdrImage, reference: &HdrImage) -> f64 {
    let exposure = Exposure::of(reference);
    let [a, b] = [a, reference].map(|image| image.tone_mapped(exposure));
    let pixels = a.pixels().zip(b.pixels()).zip(surfaces);
    let (mut square, mut count) = (0.0, 0.0);
    for ((a, b), _) in pixels.filter(|(_, surface)| **surface) {
        for channel in 0..3 {
            let difference = f64::from(a.0[channel]) - f64::from(b.0[channel]);
            square += (difference / 255.0).powi(2);
            count += 1.0;
        }
    }
    (square / f64::max(count, 1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// The reference is 0.9 of white everywhere: sRGB 243. Black beside it is 243 steps off.
    #[test]
    fn pictures_differ_as_they_are_shown() {
        let image = |values: [f32; 4]| HdrImage {
            width: 2,
            height: 2,
            pixels: values.map(Vec3::splat).to_vec(),
        };
        let (reference, estimate) = (image([3.0; 4]), image([3.0, 0.0, 0.0, 9.0]));
        let rms = shown_rms(&[true, true, false, false], &estimate, &reference);
        let expected = (243.0_f64 / 255.0) * 0.5_f64.sqrt();
        assert!((rms - expected).abs() < 1e-12, "{rms} {expected}");
        assert_eq!(shown_rms(&[false; 4], &estimate, &reference), 0.0);
    }
}
