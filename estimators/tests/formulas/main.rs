//! Every constant, exponent and sign of the leaf functions against a value of its own: a closed form, a
//! quadrature, or a case worked out by hand. That both backends agree on a formula (the twins) says
//! nothing of whether it is right.

mod convolutions;
mod cube_maps;
mod harmonics;
mod photons;
mod polygons;
mod reflections;

use glam::DVec3;
use interreflect_cpu::lane::Vector;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Roundings of float64, of a handful of operations on numbers near 1.
pub(crate) const ROUNDING: f64 = 1e-12;

#[track_caller]
pub(crate) fn near(found: f64, expected: f64) {
    within(found, expected, ROUNDING);
}

#[track_caller]
pub(crate) fn within(found: f64, expected: f64, relative: f64) {
    let apart = (found - expected).abs();
    assert!(
        apart <= relative * expected.abs().max(1.0),
        "{found} is not {expected}"
    );
}

pub(crate) fn vector(x: f64, y: f64, z: f64) -> Vector<f64> {
    Vector::new(x, y, z)
}

pub(crate) fn of(v: DVec3) -> Vector<f64> {
    vector(v.x, v.y, v.z)
}

/// ∫ f dω over the directions whose angle with +z is from `from` to `to`, by the midpoint rule in cos θ and
/// φ; its error for smooth f is far below 1e-5 with so many nodes.
pub(crate) fn integral([from, to]: [f64; 2], f: impl Fn(DVec3) -> f64) -> f64 {
    const POLAR: u32 = 2000;
    const AROUND: u32 = 64;
    let (low, high) = (to.cos(), from.cos());
    let (dz, dphi) = ((high - low) / f64::from(POLAR), TAU / f64::from(AROUND));
    let mut sum = 0.0;
    for i in 0..POLAR {
        let z = low + (f64::from(i) + 0.5) * dz;
        let r = (1.0 - z * z).sqrt();
        for j in 0..AROUND {
            let (sin, cos) = ((f64::from(j) + 0.5) * dphi).sin_cos();
            sum += f(DVec3::new(r * cos, r * sin, z));
        }
    }
    sum * dz * dphi
}

pub(crate) const HEMISPHERE: [f64; 2] = [0.0, FRAC_PI_2];
