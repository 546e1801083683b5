//! The paper's formulas and their corrections, over any [`Lane`]. How a texel's place is kept:
//! [`crate::texels::math`].

use interreflect_cpu::lane::Lane;
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

/// A·cos θ/d² of the disc of area A that subtends the solid angle `omega` (sr, in (0, π)) at
/// distance d under the angle θ: Δω/(1 − Δω/π) (P1, corrected: the disc formula inverted).
pub fn disc_area(omega: f64) -> f64 {
    omega / (1.0 - omega / PI)
}

/// Solid angle in sr of that disc seen from x, with the cosine at the surface: A·c/(r² + A·c/π)
/// (P1, corrected).
///
/// `area` is A/d², `r2` = (r/d)² and `cos_surface` the cosine between the surface's normal and the
/// direction to x; the result is in [0, π), 0 behind the surface
/// and at it.
#[inline(always)]
pub fn omega_corrected<L: Lane>(area: L, r2: L, cos_surface: L) -> L {
    let seen = area * cos_surface.max(L::splat(0.0));
    let spread = r2 + seen * L::splat(FRAC_1_PI);
    seen / spread.max(L::splat(f64::from(f32::MIN_POSITIVE)))
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

/// Place of (cos θ, Δω) in a table of average reflectivity: ⁴√((1 − cos θ)/2) and √(Δω/π), both
/// in [0, 1] (P1 §3).
///
/// The fourth root puts half of the first axis within 29° of the lobe's middle, so that lobes of
/// exponents up to 1e4 are resolved; the second is 2·sin(α/2) for a cap of radius α.
#[inline(always)]
pub fn table_place<L: Lane>(cos_theta: L, omega: L) -> (L, L) {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let half = (one - cos_theta) * L::splat(0.5);
    let first = half.max(zero).min(one).sqrt().sqrt();
    let second = (omega * L::splat(FRAC_1_PI)).max(zero).min(one).sqrt();
    (first, second)
}

/// Mean of ((N·ω)⁺)ⁿ over the directions ω of a cap of angular radius `radius` in [0, π] whose axis
/// makes the angle `theta` in [0, π] with N.
///
/// In polar coordinates about N, where the cap's share of each circle is known: midpoint rule over
/// 128 circles up to where the power falls below 1e-12; relative error about 1e-3.
pub fn cap_mean(theta: f64, radius: f64, exponent: f64) -> f64 {
    const CIRCLES: u32 = 128;
    if radius < 1e-4 {
        return theta.cos().max(0.0).powf(exponent) * f64::from(u8::from(theta < 0.5 * PI));
    }
    let last = (1e-12_f64.ln() / exponent.max(1e-3)).exp().acos();
    let from = (theta - radius).max(0.0);
    let to = (theta + radius).min(last);
    if to <= from {
        return 0.0;
    }
    let step = (to - from) / f64::from(CIRCLES);
    let circle = |k: u32| {
        let polar = from + (f64::from(k) + 0.5) * step;
        let across = theta.sin() * polar.sin();
        let along = radius.cos() - theta.cos() * polar.cos();
        let half_arc = if across.abs() < 1e-12 {
            if along <= 0.0 { PI } else { 0.0 }
        } else {
            (along / across).clamp(-1.0, 1.0).acos()
        };
        2.0 * half_arc * polar.sin() * polar.cos().powf(exponent)
    };
    let sum: f64 = (0..CIRCLES).map(circle).sum();
    sum * step / (2.0 * PI * (1.0 - radius.cos()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tolerances: the midpoint rule's error at the ends of the cap, where the arc ends as a square
    /// root does, h^1.5 of 128 steps. Above the horizon the mean cosine over a cap is cos θ·(1 + cos α)/2; a narrow cap has the
    /// power itself, and the whole sphere half the hemisphere's mean 1/(n + 1).
    #[test]
    fn a_caps_mean_has_its_closed_forms() {
        for theta in [0.0, 0.3, 0.7] {
            for radius in [0.1, 0.5, 0.8] {
                let exact = f64::cos(theta) * (1.0 + f64::cos(radius)) / 2.0;
                let error = cap_mean(theta, radius, 1.0) / exact - 1.0;
                assert!(error.abs() < 2e-3, "{theta} {radius}: {error}");
            }
            for exponent in [1.0, 5.0, 100.0, 1e4] {
                let exact = f64::cos(theta).powf(exponent);
                let narrow = cap_mean(theta, 1e-3, exponent);
                assert!(
                    (narrow - exact).abs() < 4e-3,
                    "{theta} {exponent}: {narrow}"
                );
                let whole = cap_mean(theta, PI, exponent) * 2.0 * (exponent + 1.0);
                assert!((whole - 1.0).abs() < 4e-3, "{theta} {exponent}: {whole}");
            }
        }
    }
}
