//! Closed forms: fractions of the cosine-weighted hemisphere, so that E = π·L·F.

use std::f64::consts::PI;

/// Rectangle of sides a and b parallel to the receiver, one corner straight above it at height c.
pub fn parallel_rectangle(a: f64, b: f64, c: f64) -> f64 {
    let (a, b) = (a / c, b / c);
    let (ra, rb) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
    (a / ra * (b / ra).atan() + b / rb * (a / rb).atan()) / (2.0 * PI)
}

/// Rectangle of this height and width perpendicular to the receiver, standing on its plane at this
/// distance, one lower corner straight ahead.
pub fn perpendicular_rectangle(height: f64, width: f64, distance: f64) -> f64 {
    let (x, y) = (height / width, distance / width);
    let r = x.hypot(y);
    ((1.0 / y).atan() - y / r * (1.0 / r).atan()) / (2.0 * PI)
}

/// Two opposite faces of a unit cube.
pub const CUBE_OPPOSITE: f64 = 0.199_824_895_698_387_46;

/// Two adjacent faces of a unit cube.
pub const CUBE_ADJACENT: f64 = 0.200_043_776_075_403_16;

/// Disc of radius `r` parallel to the receiver, its centre straight above at height h.
pub fn coaxial_disc(r: f64, h: f64) -> f64 {
    r * r / (r * r + h * h)
}

/// Disc of radius `r` parallel to the receiver at height h, its centre `a` > 0 off the normal.
pub fn offset_disc(r: f64, h: f64, a: f64) -> f64 {
    let (h, r) = (h / a, r / a);
    let z = 1.0 + h * h + r * r;
    0.5 * (1.0 - (z - 2.0 * r * r) / (z * z - 4.0 * r * r).sqrt())
}

/// Sphere of radius `r` whose centre lies at distance d ≥ r, at angle θ to the receiver's normal.
/// Domain: wholly above the horizon, d·cos θ ≥ r.
pub fn sphere_above_horizon(r: f64, d: f64, cos_theta: f64) -> f64 {
    cos_theta * (r / d).powi(2)
}

/// Openness beside a sphere that is wholly above the horizon; parameters as
/// [`sphere_above_horizon`].
pub fn openness_beside_sphere(r: f64, d: f64, cos_theta: f64) -> f64 {
    1.0 - sphere_above_horizon(r, d, cos_theta)
}

/// Openness where a half-space fills all directions i with m·i < 0; `cos_tilt` = n·m.
pub fn openness_beside_half_space(cos_tilt: f64) -> f64 {
    0.5 * (1.0 + cos_tilt)
}

/// Openness on a floor at distance d from an endless wall of height h.
pub fn openness_beside_wall(h: f64, d: f64) -> f64 {
    1.0 - 0.5 * (1.0 - d / d.hypot(h))
}

/// Openness at the centre of the floor of a pit: the rectangular opening of sides a and b at
/// height h.
pub fn openness_in_pit(a: f64, b: f64, h: f64) -> f64 {
    4.0 * parallel_rectangle(0.5 * a, 0.5 * b, h)
}

/// Factor from disc 1 of radius r₁ to a parallel coaxial disc of radius r₂ at distance h.
pub fn coaxial_discs(r1: f64, r2: f64, h: f64) -> f64 {
    let (r1, r2) = (r1 / h, r2 / h);
    let x = 1.0 + (1.0 + r2 * r2) / (r1 * r1);
    0.5 * (x - (x * x - 4.0 * (r2 / r1).powi(2)).sqrt())
}

/// Radiance inside a furnace whose walls emit 1 and have albedo ρ < 1, after up to k reflections;
/// `None`: any number.
pub fn furnace_radiance(albedo: f64, bounces: Option<i32>) -> f64 {
    let left_out = bounces.map_or(0.0, |k| albedo.powi(k + 1));
    (1.0 - left_out) / (1.0 - albedo)
}

/// Indirect irradiance in W/m² everywhere on the wall of a sphere of radius r and albedo ρ < 1, of
/// a flux of 1 W that first meets its wall; by one reflection, or by any number of them.
pub fn integrating_sphere(albedo: f64, r: f64, all_bounces: bool) -> f64 {
    let first = albedo / (4.0 * PI * r * r);
    if all_bounces {
        first / (1.0 - albedo)
    } else {
        first
    }
}

/// Cosine-weighted mean of Schlick's Fresnel factor F₀ + (1 − F₀)(1 − cos θ)⁵.
pub fn schlick_mean(f0: f64) -> f64 {
    f0 + (1.0 - f0) / 21.0
}

#[cfg(test)]
mod tests {
    use super::super::polygon::polygon_irradiance;
    use super::*;
    use glam::DVec3;

    /// Mean over one face of the irradiance from another, by the midpoint rule, which converges
    /// as 1/n² for opposite faces and as 1/n towards the shared edge of adjacent ones.
    fn mean_over_floor(n: usize, corners: [DVec3; 4]) -> f64 {
        let at = |i: usize| (i as f64 + 0.5) / n as f64;
        let sum: f64 = (0..n * n)
            .map(|k| {
                let x = DVec3::new(at(k % n), at(k / n), 0.0);
                polygon_irradiance(DVec3::Z, &corners.map(|c| c - x)).abs()
            })
            .sum();
        sum / (n * n) as f64 / PI
    }

    #[test]
    fn the_cubes_faces_agree_with_quadrature() {
        let ceiling = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let ceiling = ceiling.map(|(x, y)| DVec3::new(x, y, 1.0));
        let wall = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        let wall = wall.map(|(y, z)| DVec3::new(0.0, y, z));
        // Richardson: the midpoint errors fall by 4 (opposite) with each doubling.
        let opposite = (4.0 * mean_over_floor(64, ceiling) - mean_over_floor(32, ceiling)) / 3.0;
        assert!((opposite - CUBE_OPPOSITE).abs() < 1e-8, "{opposite}");
        let adjacent = (4.0 * mean_over_floor(64, wall) - mean_over_floor(32, wall)) / 3.0;
        assert!((adjacent - CUBE_ADJACENT).abs() < 1e-5, "{adjacent}");
        let closure = CUBE_OPPOSITE + 4.0 * CUBE_ADJACENT;
        assert!((closure - 1.0).abs() < 1e-15, "{closure}");
    }

    /// Cosine-weighted fraction of the hemisphere about +z in which `seen` holds, by the midpoint
    /// rule over cos²θ and φ. Its error is that of counting cells along the outline: below
    /// 3·10⁻⁴ (half a row of cells, 1/4096, where the outline runs along a row) for the shapes here.
    fn fraction(seen: impl Fn(DVec3) -> bool) -> f64 {
        mean(|i| f64::from(u8::from(seen(i))))
    }

    fn mean(f: impl Fn(DVec3) -> f64) -> f64 {
        const N: usize = 2048;
        let at = |i: usize| (i as f64 + 0.5) / N as f64;
        let sum: f64 = (0..N * N)
            .map(|k| {
                let (cos2, phi) = (at(k / N), 2.0 * PI * at(k % N));
                let sin = (1.0 - cos2).sqrt();
                f(DVec3::new(sin * phi.cos(), sin * phi.sin(), cos2.sqrt()))
            })
            .sum();
        sum / (N * N) as f64
    }

    fn assert_close(closed: f64, quadrature: f64, what: &str) {
        let error = (closed - quadrature).abs();
        assert!(error < 3e-4, "{what}: {closed}, by quadrature {quadrature}");
    }

    #[test]
    fn discs_and_spheres_agree_with_quadrature() {
        for (r, h, a) in [(1.0, 1.0, 0.5), (0.3, 0.7, 1.2), (2.0, 0.1, 1.9)] {
            let disc = |a: f64| {
                fraction(|i| {
                    let p = i * (h / i.z);
                    (p.x - a).hypot(p.y) < r
                })
            };
            assert_close(coaxial_disc(r, h), disc(0.0), "coaxial disc");
            assert_close(offset_disc(r, h, a), disc(a), "offset disc");
        }
        for (r, d, cos_theta) in [(1.0_f64, 2.0, 0.8), (0.5, 0.6, 0.9), (1.0, 3.0, 0.34_f64)] {
            let axis = DVec3::new((1.0 - cos_theta * cos_theta).sqrt(), 0.0, cos_theta);
            let cos_radius = (1.0 - (r / d) * (r / d)).sqrt();
            let seen = fraction(|i| i.dot(axis) > cos_radius);
            assert_close(sphere_above_horizon(r, d, cos_theta), seen, "sphere");
            assert_close(
                openness_beside_sphere(r, d, cos_theta),
                1.0 - seen,
                "openness",
            );
        }
    }

    #[test]
    fn openness_agrees_with_quadrature() {
        for tilt in [0.0_f64, 0.4, 1.3, 2.8] {
            let m = DVec3::new(tilt.sin(), 0.0, tilt.cos());
            let open = fraction(|i| m.dot(i) >= 0.0);
            assert_close(openness_beside_half_space(tilt.cos()), open, "half-space");
        }
        for (h, d) in [(1.0, 1.0), (0.2, 1.5), (5.0, 0.5)] {
            let open = fraction(|i| i.x <= 0.0 || i.z / i.x > h / d);
            assert_close(openness_beside_wall(h, d), open, "wall");
        }
        for (a, b, h) in [(2.0, 2.0, 1.0), (1.0, 4.0, 0.5)] {
            let open =
                fraction(|i| (2.0 * h * i.x / i.z).abs() < a && (2.0 * h * i.y / i.z).abs() < b);
            assert_close(openness_in_pit(a, b, h), open, "pit");
        }
    }

    #[test]
    fn coaxial_discs_agree_with_quadrature_and_are_reciprocal() {
        for (r1, r2, h) in [(1.0, 2.0, 1.0), (1.0, 0.5, 0.3), (0.7, 0.9, 2.0)] {
            const N: usize = 2000;
            // Mean over the area of disc 1: midpoints of r² in (0, r1²); the error is O(1/N²).
            let ring = |i: usize| r1 * ((i as f64 + 0.5) / N as f64).sqrt();
            let mean = (0..N).map(|i| offset_disc(r2, h, ring(i))).sum::<f64>() / N as f64;
            let (f12, f21) = (coaxial_discs(r1, r2, h), coaxial_discs(r2, r1, h));
            assert!((f12 - mean).abs() < 1e-6, "{r1} {r2} {h}: {f12} {mean}");
            assert!((r1 * r1 * f12 - r2 * r2 * f21).abs() < 1e-14);
        }
    }

    #[test]
    fn bounces_sum_up() {
        let mut sum = 0.0;
        for k in 0..200 {
            sum += 0.7_f64.powi(k);
            assert!((furnace_radiance(0.7, Some(k)) / sum - 1.0).abs() < 1e-12);
        }
        assert!((furnace_radiance(0.7, None) / sum - 1.0).abs() < 1e-12);
        let first = integrating_sphere(0.7, 2.0, false);
        assert!((integrating_sphere(0.7, 2.0, true) / (first * sum) - 1.0).abs() < 1e-12);
    }

    /// One reflection by the wall of a sphere: each patch of it radiates ρE/π, and the kernel
    /// cos·cos'/r² between any two of its points is 1/(4R²).
    #[test]
    fn an_integrating_sphere_lit_from_anywhere_agrees_with_quadrature() {
        let (albedo, radius) = (0.6, 1.5);
        let source = DVec3::new(0.4, -0.9, 0.3);
        for x in [DVec3::Z, DVec3::new(0.6, 0.0, -0.8)].map(|d| d * radius) {
            let both = [1.0, -1.0].map(|side| {
                // `mean` weighs by cos θ: divided out, and times 2πR²/2 for the area of half a sphere.
                mean(|i| {
                    let y = DVec3::new(i.x, i.y, side * i.z) * radius;
                    let (s, r) = (source - y, x - y);
                    let inward = -y / radius;
                    let lit = s.dot(inward) / (4.0 * PI * s.length().powi(3));
                    let (cos_y, cos_x) = (inward.dot(r), (-x / radius).dot(-r));
                    let kernel = cos_y * cos_x / r.length_squared().powi(2);
                    albedo / PI * lit * kernel / i.z
                }) * PI
                    * radius
                    * radius
            });
            let error = (both[0] + both[1]) / integrating_sphere(albedo, radius, false) - 1.0;
            // The midpoint rule meets 1/cos θ at the rim: O(1/√N²) of a cell.
            assert!(error.abs() < 2e-2, "{error}");
        }
    }

    #[test]
    fn the_mean_of_schlicks_factor_agrees_with_quadrature() {
        for f0 in [0.0, 0.04, 0.9] {
            let quadrature = mean(|i| f0 + (1.0 - f0) * (1.0 - i.z).powi(5));
            assert_close(schlick_mean(f0), quadrature, "Schlick");
        }
    }
}
