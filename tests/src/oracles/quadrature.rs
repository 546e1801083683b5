//! Integrals by brute force, for the trials of closed forms: the midpoint rule and no more.
//!
//! With N cells a side its error is O(1/N²) for integrands that are continuous, kinks included, and
//! O(1/N) where they jump along a line of cells.

use glam::DVec3;
use std::f64::consts::PI;

/// Cells a side.
pub(super) const N: usize = 1024;

/// Σ f(u, v)/N² at the midpoints of N² cells of the unit square.
pub(super) fn over_square(f: impl Fn(f64, f64) -> f64) -> f64 {
    let at = |i: usize| (i as f64 + 0.5) / N as f64;
    let row = |i: usize| (0..N).map(|j| f(at(i), at(j))).sum::<f64>();
    (0..N).map(row).sum::<f64>() / (N * N) as f64
}

/// ∫ f(i) dω over the sphere.
pub(super) fn over_sphere(f: impl Fn(DVec3) -> f64) -> f64 {
    over_square(|u, v| f(direction(2.0 * u - 1.0, v))) * 4.0 * PI
}

/// ∫ f(i) cos θ dω over the hemisphere about +z.
pub(super) fn over_hemisphere(f: impl Fn(DVec3) -> f64) -> f64 {
    over_square(|u, v| f(direction(u.sqrt(), v))) * PI
}

fn direction(z: f64, turn: f64) -> DVec3 {
    let (sin_phi, cos_phi) = (2.0 * PI * turn).sin_cos();
    let sin_theta = (1.0 - z * z).sqrt();
    DVec3::new(sin_theta * cos_phi, sin_theta * sin_phi, z)
}

/// ∫ f(y) dA over a triangle, its square of parameters collapsed at the first corner.
pub(super) fn over_triangle([a, b, c]: [DVec3; 3], f: impl Fn(DVec3) -> f64) -> f64 {
    let area = (b - a).cross(c - a).length();
    over_square(|u, v| u * f(a + u * ((b - a) + v * (c - b)))) * area
}
