//! Reflection lobes whose integral is known.

use std::f64::consts::PI;

/// Factor (n+1)/(2π) that makes Phong's lobe cosⁿ integrate to 1 over the hemisphere about its axis.
pub fn phong_normalisation(exponent: f64) -> f64 {
    (exponent + 1.0) / (2.0 * PI)
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::{over_hemisphere, over_sphere};
    use super::*;
    use glam::DVec3;
    use interreflect_estimators::texels::math::{lobe_normalisation, normalised_reflectivity};
    use interreflect_scene::material::blinn_phong_normalisation;

    #[test]
    fn phongs_lobe_integrates_to_one() {
        for n in [1.0, 5.0, 40.0, 200.0] {
            let lobe = over_sphere(|i| phong_normalisation(n) * i.z.max(0.0).powf(n));
            // The midpoint rule: n²/1024² at the top of the lobe, a kink at the horizon for n = 1.
            assert!((lobe - 1.0).abs() < 2e-2 * n * n / 1024.0, "{n}: {lobe}");
        }
    }

    /// Seen head-on, N·H is the cosine of half the angle of I.
    fn head_on(lobe: impl Fn(DVec3, f64) -> f64) -> f64 {
        over_hemisphere(|i| lobe(i, (0.5 * (1.0 + i.z)).sqrt()))
    }

    #[test]
    fn blinn_and_phongs_normalised_lobe_reflects_all_head_on() {
        for n in [0.0, 1.0, 5.0, 100.0] {
            // The midpoint rule over cos²θ: its slope is endless at the horizon, N^(−3/2).
            let lobe = head_on(|_, n_h| blinn_phong_normalisation(n) * n_h.powf(n));
            assert!((lobe - 1.0).abs() < 3e-5, "{n}: {lobe}");
            let specular = head_on(|i, n_h| {
                normalised_reflectivity(i.z, n_h, n, lobe_normalisation(n)).1 / i.z
            });
            assert!((specular - 1.0).abs() < 3e-5, "{n}: {specular}");
            let diffuse = head_on(|i, n_h| normalised_reflectivity(i.z, n_h, n, 0.0).0 / i.z);
            assert!((diffuse - 1.0).abs() < 1e-9, "{n}: {diffuse}");
        }
    }
}
