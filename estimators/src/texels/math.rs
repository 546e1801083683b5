//! Leaf functions of sums over texels, over any [`Lane`].
//!
//! A texel's surface point is kept relative to the reference point o and in homogeneous form:
//! y − o = direction / w with the unit `direction` = L/l and w = 1/d, so that the environment at
//! infinity is w = 0 and no formula has a case for it. With x relative to o as well,
//! R = direction − w·x is (y − x)·w, its square is (r/d)², and its direction is that of I.

use interreflect_cpu::lane::{Lane, Vector};
use std::f64::consts::{FRAC_1_PI, PI};

/// (r/d)² below which x is a texel's own point: of the unit vector `direction` and of w·x, which is nearly
/// as long there, float32 rounds each component by up to 2⁻²⁴, and r/d below 2⁻²² is all rounding.
pub const COINCIDENT: f64 = 1.0 / (1_u64 << 44) as f64;

/// The direction I from x to a texel's surface point, and r2 = (r/d)².
///
/// `direction`, `w`: the texel's homogeneous point; `x`: the shaded point relative to o. Where x
/// is that very point, or nearer than float32 resolves, I is zero: the texel then adds nothing.
#[inline(always)]
pub fn towards_texel<L: Lane>(direction: Vector<L>, w: L, x: Vector<L>) -> (Vector<L>, L) {
    let r = direction - x.scale(w);
    let r2 = r.dot(r);
    let least = L::splat(COINCIDENT);
    let inverse = r2.select_gt(least, L::splat(1.0) / r2.max(least).sqrt(), L::splat(0.0));
    (r.scale(inverse), r2)
}

/// Cosine N·H with the half vector of I and V; 0 where I = −V.
#[inline(always)]
pub fn cos_half<L: Lane>(n: Vector<L>, i: Vector<L>, v: Vector<L>) -> L {
    let h = i + v;
    let h2 = h.dot(h);
    let tiny = L::splat(1e-20);
    n.dot(h) * h2.select_gt(tiny, L::splat(1.0) / h2.max(tiny).sqrt(), L::splat(0.0))
}

/// Diffuse and specular factor of the normalised reflectivity times the cosine:
/// [k_d/π + k_s·(n+2)(n+4)/(8π(2^(−n/2)+n))·(N·H)ⁿ]·(N·I)⁺ (P1, corrected).
///
/// `normalisation` is [`lobe_normalisation`] of the shininess. Takes no notice of N·V: with
/// interpolated normals a visible point may have N·V < 0, and it is not black there.
#[inline(always)]
pub fn normalised_reflectivity<L: Lane>(n_i: L, n_h: L, shininess: L, normalisation: L) -> (L, L) {
    let cos = n_i.max(L::splat(0.0));
    (
        cos * L::splat(FRAC_1_PI),
        cos * normalisation * n_h.lobe_power(shininess),
    )
}

/// Normalisation (n+2)(n+4)/(8π(2^(−n/2)+n)) of the Blinn–Phong lobe for n ≥ 0 (P1, corrected).
#[inline(always)]
pub fn lobe_normalisation<L: Lane>(shininess: L) -> L {
    let n = shininess;
    let two_to_minus_half_n = L::splat(0.5).lobe_power(n * L::splat(0.5));
    (n + L::splat(2.0)) * (n + L::splat(4.0)) / (L::splat(8.0 * PI) * (two_to_minus_half_n + n))
}
