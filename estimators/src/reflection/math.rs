//! The mirrored direction and Schlick's Fresnel factor, over any [`Lane`].

use interreflect_cpu::lane::{Lane, Vector};
use std::f64::consts::FRAC_1_PI;

/// Unit direction r = 2(n·v)n − v that mirrors the unit direction `v` to the viewer about the unit
/// normal `n`.
#[inline(always)]
pub fn mirrored<L: Lane>(n: Vector<L>, v: Vector<L>) -> Vector<L> {
    n.scale(L::splat(2.0) * n.dot(v)) - v
}

/// Schlick's Fresnel factor F = f_λ + (1 − f_λ)(1 − cos θ)⁵ in [f_λ, 1] (P2).
///
/// `f_lambda` is the reflectance at normal incidence in [0, 1]. cos θ = n·v is clamped to [0, 1]:
/// interpolated normals may turn away from the viewer.
#[inline(always)]
pub fn schlick<L: Lane>(f_lambda: L, cos_theta: L) -> L {
    let one = L::splat(1.0);
    let away = one - cos_theta.max(L::splat(0.0)).min(one);
    let squared = away * away;
    f_lambda + (one - f_lambda) * (squared * squared * away)
}

/// Reflected radiance L_o = (1 − F)·k_d/π·E + F·k_s·L of one colour (P2), from the irradiance E and
/// the radiance L filtered around the mirrored direction.
#[inline(always)]
pub fn fresnel_mix<L: Lane>(fresnel: L, diffuse: L, irradiance: L, specular: L, radiance: L) -> L {
    (L::splat(1.0) - fresnel) * (diffuse * irradiance * L::splat(FRAC_1_PI))
        + fresnel * (specular * radiance)
}
