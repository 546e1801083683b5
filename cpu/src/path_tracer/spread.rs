//! How sources of light are weighted, and which of them are worth drawing.

use glam::Vec3;

/// Sources whose light comes from more than this part of all surfaces, or of the sphere, are not
/// drawn.
pub(super) const BROAD: f64 = 0.3;

/// What sources are weighted by.
pub(super) fn brightness(radiance: Vec3) -> f32 {
    radiance.element_sum()
}

/// Over how large a part of its domain a brightness is spread: (∫ b)² / (∫ b² · ∫ 1), 1 if it is
/// constant, the covered part if it is constant there and 0 elsewhere.
#[derive(Default)]
pub(super) struct Spread {
    measure: f64,
    first: f64,
    second: f64,
}

impl Spread {
    pub(super) fn add(&mut self, measure: f64, brightness: f32) {
        let b = f64::from(brightness);
        self.measure += measure;
        self.first += measure * b;
        self.second += measure * b * b;
    }

    pub(super) fn part(&self) -> f64 {
        let whole = self.second * self.measure;
        if whole > 0.0 {
            self.first * self.first / whole
        } else {
            0.0
        }
    }
}
