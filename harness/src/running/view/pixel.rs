//! What a pixel shows.

use glam::Vec3;
use interreflect_scene::Estimate;

/// What a pixel shows.
#[derive(Clone, Copy)]
pub(super) struct Pixel {
    /// The points that it shows, none if it sees no shaded surface.
    pub(super) taps: Option<Taps>,
    /// Product of the mirrors' reflectances between camera and point.
    pub(super) throughput: Vec3,
    /// The same, up to the surface that is seen, shaded or not.
    pub(super) mirrored: Vec3,
    /// Radiance that is there without any reflection: emission, environment at infinity.
    pub(super) emitted: Vec3,
    /// The surface that is seen, shaded or not; none where there is none.
    pub(super) seen: Option<u32>,
}

/// Points with their weights.
#[derive(Clone, Copy)]
pub(super) struct Taps {
    pub(super) points: [u32; 3],
    pub(super) weights: [f32; 3],
}

impl Taps {
    pub(super) fn one(point: usize) -> Self {
        Self {
            points: [point as u32, 0, 0],
            weights: [1.0, 0.0, 0.0],
        }
    }

    pub(super) fn of(self, estimate: &Estimate) -> Vec3 {
        let taps = self.points.into_iter().zip(self.weights);
        taps.filter(|tap| tap.1 != 0.0)
            .map(|(point, weight)| estimate.get(point as usize) * weight)
            .sum()
    }
}
