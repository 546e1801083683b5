//! Near quads in double precision.

use crate::oracles::polygon::polygon_irradiance;
use glam::DVec3;

/// A point that gathers.
pub(super) struct Receiver {
    pub(super) x: DVec3,
    pub(super) n: DVec3,
    /// View direction and exponent of its specular lobe.
    pub(super) lobe: Option<(DVec3, f64)>,
}

/// How often at most a near quad is split in four so that the lobe varies little over each part.
const SPLITS: u32 = 8;

/// Squared distance over area from which a quad counts as a point: the relative error is a third
/// of the inverse.
const FAR: f64 = 256.0;

/// Squared distance over area, for each unit of the exponent, from which a part is small in the
/// lobe.
const SMALL_BY_SHININESS: f64 = 8.0;

/// What a planar quad of radiance 1 gives: its exact irradiance, and the integral of that times
/// the lobe (N·H)ⁿ, in parts over each of which the lobe is constant.
pub(super) fn near(receiver: &Receiver, corners: &[DVec3; 4]) -> (f64, f64) {
    let corners = corners.map(|c| c - receiver.x);
    let diffuse = irradiance(receiver.n, &corners);
    match &receiver.lobe {
        Some((view, shininess)) if diffuse > 0.0 => {
            let lobe = |i: DVec3| {
                let cos_half = receiver.n.dot((i + view).normalize_or_zero());
                if cos_half > 0.0 {
                    cos_half.powf(*shininess)
                } else {
                    0.0
                }
            };
            let small = SMALL_BY_SHININESS * shininess.max(4.0);
            (
                diffuse,
                specular(receiver.n, &corners, small, SPLITS, &lobe),
            )
        }
        _ => (diffuse, 0.0),
    }
}

/// Irradiance from a quad of radiance 1: exact if near, else of a point of its area.
fn irradiance(n: DVec3, corners: &[DVec3; 4]) -> f64 {
    let [a, b, c, d] = *corners;
    let middle = (a + b + c + d) * 0.25;
    // Clockwise: away from the side that is seen.
    let area = 0.5 * (c - a).cross(d - b);
    let r2 = middle.length_squared();
    if r2 * r2 > FAR * FAR * area.length_squared() {
        return n.dot(middle).max(0.0) * area.dot(middle).max(0.0) / (r2 * r2);
    }
    polygon_irradiance(n, corners).max(0.0)
}

fn specular(
    n: DVec3,
    corners: &[DVec3; 4],
    small: f64,
    splits: u32,
    lobe: &impl Fn(DVec3) -> f64,
) -> f64 {
    let [a, b, c, d] = *corners;
    let middle = (a + b + c + d) * 0.25;
    let area = 0.5 * (c - a).cross(d - b).length();
    if splits == 0 || middle.length_squared() > small * area {
        return irradiance(n, corners) * lobe(middle.normalize_or_zero());
    }
    let (ab, bc, cd, da) = ((a + b) * 0.5, (b + c) * 0.5, (c + d) * 0.5, (d + a) * 0.5);
    [
        [a, ab, middle, da],
        [ab, b, bc, middle],
        [middle, bc, c, cd],
        [da, middle, cd, d],
    ]
    .iter()
    .map(|part| specular(n, part, small, splits - 1, lobe))
    .sum()
}
