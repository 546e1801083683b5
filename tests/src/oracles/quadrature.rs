//! Integrals by brute force, for the trials of closed forms: the midpoint rule and no more.
//!
//! With N cells a side its error is O(1/N²) for integrands that are continuous, kinks included, and
//! O(1/N) where they jump along a line of cells.

use glam::DVec3;
use std::f64::consts::PI;

/// Cells a side.
pub(super) const N: usize = 1024;

/// Mean of f(u, v) at the midpoints of `cells`² cells of the unit square.
pub(super) fn over_square(cells: usize, f: impl Fn(f64, f64) -> f64) -> f64 {
    let at = |i: usize| (i as f64 + 0.5) / cells as f64;
    let row = |i: usize| (0..cells).map(|j| f(at(i), at(j))).sum::<f64>();
    (0..cells).map(row).sum::<f64>() / (cells * cells) as f64
}

/// ∫ f(i) dω over the sphere.
pub(super) fn over_sphere(f: impl Fn(DVec3) -> f64) -> f64 {
    over_square(N, |u, v| f(direction(2.0 * u - 1.0, v))) * 4.0 * PI
}

/// ∫ f(i) cos θ dω over the hemisphere about +z, cells even in cos²θ and φ.
pub(super) fn over_hemisphere(f: impl Fn(DVec3) -> f64) -> f64 {
    over_square(N, |u, v| f(direction(u.sqrt(), v))) * PI
}

fn direction(z: f64, turn: f64) -> DVec3 {
    let (sin_phi, cos_phi) = (2.0 * PI * turn).sin_cos();
    let sin_theta = (1.0 - z * z).sqrt();
    DVec3::new(sin_theta * cos_phi, sin_theta * sin_phi, z)
}

/// ∫ f(y) dA over a convex polygon: a fan of triangles, each with its square of parameters collapsed
/// at the first corner.
pub(super) fn over_polygon(corners: &[DVec3], f: impl Fn(DVec3) -> f64) -> f64 {
    let triangle = |e: &[DVec3]| {
        let (a, b, c) = (corners[0], e[0], e[1]);
        let twice = (b - a).cross(c - a).length();
        over_square(N, |u, v| u * f(a + u * ((b - a) + v * (c - b)))) * twice
    };
    corners[1..].windows(2).map(triangle).sum()
}

/// Irradiance at the origin from a convex polygon of radiance 1 by ∫ cos θ cos θ'/r² dA.
pub(super) fn irradiance_by_area(n: DVec3, corners: &[DVec3]) -> f64 {
    let across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    let m = across.normalize();
    over_polygon(corners, |y| {
        n.dot(y).max(0.0) * m.dot(y).abs() / y.length_squared().powi(2)
    })
}
