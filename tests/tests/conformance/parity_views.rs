//! How far two backends' views from the lights part, and what that may do to an estimate.

use crate::ensure;
use glam::Vec3;
use interreflect_scene::RsmImage;
use libtest_mimic::Failed;
use std::f64::consts::PI;

/// Most of a view's texels, as a share, that two backends may see differently: those whose rays
/// meet an edge.
const SEEN_DIFFERENTLY: f64 = 0.02;

/// A photon is seen under π sr at most; one that has moved by a part of its way counts as much more
/// or less as a point at a tenth of that way sees it.
const NEARER: f64 = 10.0;

/// Bound on what the views' differences do to an irradiance: each texel's light that is new, gone or
/// from elsewhere, as if it arrived head-on under π sr, the most that any photon counts. Where only
/// a part of the texels is sampled this bounds it the more.
pub(crate) fn views_apart(a: &RsmImage, b: &RsmImage) -> Result<f64, Failed> {
    let brightest = (0..a.texels())
        .map(|i| radiance(a, i).max_element())
        .fold(0.0, f32::max);
    let (mut sum, mut differently) = (0.0, 0);
    for index in 0..a.texels() {
        let moved = moved(a, b, index);
        let difference = radiance(a, index) - radiance(b, index);
        let difference = difference.abs().max_element();
        sum += f64::from(difference) + NEARER * f64::from(radiance(a, index).max_element() * moved);
        differently += usize::from(moved > 1e-2 || difference > 1e-2 * brightest);
    }
    let share = differently as f64 / a.texels().max(1) as f64;
    ensure!(
        share <= SEEN_DIFFERENTLY,
        "{differently} of {} texels in views from lights differ",
        a.texels()
    );
    Ok(PI * sum)
}

/// What a texel reflects: radiance, or the most that it may reflect in any direction.
fn radiance(views: &RsmImage, index: usize) -> Vec3 {
    match (views.radiance.get(index), views.true_colors.get(index)) {
        (Some(radiance), _) => *radiance,
        (None, Some(c)) => c.irradiance * (c.diffuse + c.specular * (1.0 + c.shininess)),
        (None, None) => Vec3::ZERO,
    }
}

/// How far a texel's surface is from the other view's, relative to the light's way, or how much it
/// is turned; at most 1, and 1 where only one has a photon.
fn moved(a: &RsmImage, b: &RsmImage, index: usize) -> f32 {
    let (way, other) = (a.path_m[index], b.path_m[index]);
    if (way > 0.0) != (other > 0.0) {
        return 1.0;
    }
    if way <= 0.0 {
        return 0.0;
    }
    let distance = a.position[index].distance(b.position[index]) / way.min(other);
    let turned = match (a.normal.get(index), b.normal.get(index)) {
        (Some(a), Some(b)) => a.distance(*b),
        _ => 0.0,
    };
    let tilted = match (a.cos_light.get(index), b.cos_light.get(index)) {
        (Some(a), Some(b)) => (a - b).abs() / a.max(*b),
        _ => 0.0,
    };
    let of_light = match (a.true_colors.get(index), b.true_colors.get(index)) {
        (Some(a), Some(b)) => a.to_light.distance(b.to_light) * (1.0 + a.shininess),
        _ => 0.0,
    };
    (2.0 * distance)
        .max(turned)
        .max(tilted)
        .max(of_light)
        .min(1.0)
}
