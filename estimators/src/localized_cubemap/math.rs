//! The paper's formulas and their corrections, over any [`Lane`].
//!
//! A texel's surface point is kept relative to the reference point o and in homogeneous form:
//! y − o = direction / w with the unit `direction` = L/l and w = 1/d, so that the environment at
//! infinity is w = 0 and no formula has a case for it. With x relative to o as well,
//! R = direction − w·x is (y − x)·w, its square is (r/d)², and its direction is that of I.

use interreflect_cpu::lane::{Lane, Vector};
use std::f64::consts::{FRAC_1_PI, PI};

/// Solid angle in sr of a texel seen from o, as in the text: Δω' = 4/(M²l³ + 4/π) (P1 §2).
///
/// `m` is M ≥ 1, `l` the length of L in [1, √3]. Deviation: none; over all texels it sums to .84
/// (M = 1) … .99 (M = 8) of 4π.
pub fn texel_omega_text(m: f64, l: f64) -> f64 {
    4.0 / (m * m * l * l * l + 4.0 / PI)
}

/// Solid angle in sr of a texel seen from o, as in the shader, with l² for l³ (P1, listing).
pub fn texel_omega_shader(m: f64, l: f64) -> f64 {
    4.0 / (m * m * l * l + 4.0 / PI)
}

/// Solid angle in sr of a texel seen from x: Δω* = d²Δω' / (r²(1−Δω'/π) + d²Δω'/π) (P1 §2).
///
/// Takes `omega` = Δω' in (0, π) and `r2` = (r/d)² ≥ 0; the result is in (0, π] and equals
/// `omega` at x = o, where r = d.
#[inline(always)]
pub fn omega_published<L: Lane>(omega: L, r2: L) -> L {
    let disc = omega * L::splat(FRAC_1_PI);
    omega / (r2 * (L::splat(1.0) - disc) + disc)
}

/// Area over d² of the disc that subtends the solid angle `omega` (sr, in (0, π)) at distance d
/// under the cosine `cos_reference` in (0, 1]: A/d² = Δω/(cos θ·(1 − Δω/π)).
pub fn disc_area(omega: f64, cos_reference: f64) -> f64 {
    omega / (cos_reference * (1.0 - omega / PI))
}

/// Solid angle in sr of that disc seen from x, with the cosine at the surface: A·c/(r² + A·c/π)
/// (P1, corrected).
///
/// `area` is A/d², `r2` = (r/d)² and `cos_surface` the cosine between the surface's normal and the
/// direction to x; the result is in [0, π), 0 behind the surface.
#[inline(always)]
pub fn omega_corrected<L: Lane>(area: L, r2: L, cos_surface: L) -> L {
    let seen = area * cos_surface.max(L::splat(0.0));
    seen / (r2 + seen * L::splat(FRAC_1_PI))
}

/// The direction I from x to a texel's surface point, and r2 = (r/d)².
///
/// `direction`, `w`: the texel's homogeneous point; `x`: the shaded point relative to o. Where x
/// is that very point, or nearer than float32 resolves, I is zero: the texel then adds nothing.
#[inline(always)]
pub fn towards_texel<L: Lane>(direction: Vector<L>, w: L, x: Vector<L>) -> (Vector<L>, L) {
    let r = direction - x.scale(w);
    let r2 = r.dot(r);
    let tiny = L::splat(f64::from(f32::MIN_POSITIVE));
    let inverse = r2.select_gt(tiny, L::splat(1.0) / r2.max(tiny).sqrt(), L::splat(0.0));
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

/// Diffuse and specular factor of the paper's reflectivity a = k_d(N·I)⁺ + k_s((N·H)⁺)ⁿ, both 0
/// unless N·I > 0 and N·V > 0 (P1 §2).
///
/// Deviation: none; k_d lacks 1/π and the lobe its normalisation and the cosine.
#[inline(always)]
pub fn reflectivity_published<L: Lane>(n_i: L, n_v: L, n_h: L, shininess: L) -> (L, L) {
    let zero = L::splat(0.0);
    let lit = |value: L| n_i.select_gt(zero, n_v.select_gt(zero, value, zero), zero);
    (lit(n_i), lit(n_h.lobe_power(shininess)))
}

/// Diffuse and specular factor of the normalised reflectivity times the cosine:
/// [k_d/π + k_s·(n+2)(n+4)/(8π(2^(−n/2)+n))·(N·H)ⁿ]·(N·I)⁺ (P1, corrected).
///
/// `normalisation` is [`lobe_normalisation`] of the shininess. Takes no notice of N·V: with
/// interpolated normals a visible point may have N·V < 0, and it is not black there.
#[inline(always)]
pub fn reflectivity_corrected<L: Lane>(n_i: L, n_h: L, shininess: L, normalisation: L) -> (L, L) {
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
