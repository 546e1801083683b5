//! Irradiance from skies whose integral is known, and what nine spherical harmonics make of light
//! from one direction.

use super::form_factors::openness_beside_half_space;
use std::f64::consts::PI;

/// Irradiance from a sky of radiance 1 in the half of all directions about its zenith;
/// `cos_tilt` is the normal's cosine to the zenith.
pub fn hemispherical_sky(cos_tilt: f64) -> f64 {
    PI * openness_beside_half_space(cos_tilt)
}

/// Irradiance from a sky of radiance `mean` + `slope`·(d·m) in direction d; `cos_tilt` = n·m.
pub fn linear_sky(mean: f64, slope: f64, cos_tilt: f64) -> f64 {
    PI * (mean + 2.0 / 3.0 * slope * cos_tilt)
}

/// Irradiance from a sky of radiance (d·m)² in direction d; `cos_tilt` = n·m.
pub fn quadratic_sky(cos_tilt: f64) -> f64 {
    0.25 * PI * (1.0 + cos_tilt * cos_tilt)
}

/// Irradiance from a delta light that gives 1 head-on, at cosine `cos_theta` to the normal.
pub fn delta_light(cos_theta: f64) -> f64 {
    cos_theta.max(0.0)
}

/// The irradiance that nine spherical harmonics give for [`delta_light`]: its best approximation by
/// a quadratic in `cos_theta`, negative down to −19/480 and off by 3/32 at most.
pub fn delta_light_by_sh9(cos_theta: f64) -> f64 {
    let c = cos_theta;
    0.25 + 0.5 * c + 5.0 / 32.0 * (3.0 * c * c - 1.0)
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::{over_hemisphere, over_sphere};
    use super::*;
    use glam::DVec3;

    const TILTS: [f64; 5] = [0.0, 0.4, 1.3, 2.2, PI];

    /// `closed`(n·m) is the irradiance from a sky of this radiance at every d·m.
    fn assert_sky(closed: impl Fn(f64) -> f64, radiance: impl Fn(f64) -> f64, tolerance: f64) {
        for tilt in TILTS {
            let m = DVec3::new(tilt.sin(), 0.0, tilt.cos());
            let quadrature = over_hemisphere(|d| radiance(d.dot(m)));
            let error = (closed(tilt.cos()) - quadrature).abs();
            assert!(error < tolerance, "tilted by {tilt}: off by {error}");
        }
    }

    #[test]
    fn smooth_skies_agree_with_quadrature() {
        // The midpoint rule over cos²θ meets sin θ, whose slope is endless at the horizon: N^(−3/2).
        assert_sky(|c| linear_sky(0.7, -0.6, c), |t| 0.7 - 0.6 * t, 3e-5);
        assert_sky(quadratic_sky, |t| t * t, 3e-5);
    }

    #[test]
    fn a_hemispherical_sky_agrees_with_quadrature() {
        // It jumps at its horizon: half a row of cells, π/2048.
        assert_sky(hemispherical_sky, |t| f64::from(u8::from(t > 0.0)), 1.6e-3);
    }

    #[test]
    fn a_small_sun_gives_the_clamped_cosine() {
        let radius = 0.02_f64;
        for tilt in [0.0_f64, 0.6, 1.2, 1.7, 3.0] {
            let n = DVec3::new(tilt.sin(), 0.0, tilt.cos());
            // Mean over directions evenly spread in a cap about +z.
            let cap = over_hemisphere(|i| {
                let sin = radius * (1.0 - i.z * i.z).sqrt();
                let d = i.with_z(0.0).normalize_or_zero() * sin;
                n.dot(d.with_z((1.0 - sin * sin).sqrt())).max(0.0)
            }) / PI;
            // The mean cosine of a cap to its axis is 1 − radius²/4.
            let error = (cap - delta_light(tilt.cos())).abs();
            assert!(error < 0.3 * radius * radius, "{tilt}: {error}");
        }
    }

    #[test]
    fn nine_harmonics_leave_out_what_no_quadratic_can_hold() {
        // The best approximation is the one whose error no polynomial of its kind can see; the
        // kink of the clamped cosine lies between cells, so that the rule is good to 1/N².
        for (i, power) in [|_| 1.0, |c| c, |c: f64| c * c].iter().enumerate() {
            let left = over_sphere(|d| (delta_light(d.z) - delta_light_by_sh9(d.z)) * power(d.z));
            assert!(left.abs() < 1e-5, "degree {i}: {left}");
        }
    }

    #[test]
    fn nine_harmonics_are_off_by_as_much_as_they_say() {
        let cosines = || (0..=96_000).map(|i| f64::from(i - 48_000) / 48_000.0);
        let off = |c: f64| (delta_light_by_sh9(c) - delta_light(c)).abs();
        let largest = cosines().map(off).fold(0.0, f64::max);
        let (least, at) = cosines()
            .map(|c| (delta_light_by_sh9(c), c))
            .fold((1.0, 0.0), |a, b| if b.0 < a.0 { b } else { a });
        assert!((largest - 3.0 / 32.0).abs() < 1e-15, "{largest}");
        assert!((least + 19.0 / 480.0).abs() < 1e-15, "{least}");
        assert!((at + 8.0 / 15.0).abs() < 1e-15, "{at}");
    }

    #[test]
    fn a_hemispherical_sky_is_exact_in_nine_harmonics() {
        // Made of delta lights over the upper half: the odd bands above 1 are all that is lost, and
        // a clamped cosine has none. The sky jumps between two rows of cells: 1/N² is left.
        for tilt in TILTS {
            let n = DVec3::new(tilt.sin(), 0.0, tilt.cos());
            let sum = over_sphere(|d| {
                if d.z > 0.0 {
                    delta_light_by_sh9(d.dot(n))
                } else {
                    0.0
                }
            });
            let error = (sum - hemispherical_sky(tilt.cos())).abs();
            assert!(error < 1e-5, "{tilt}: {error}");
        }
    }
}
