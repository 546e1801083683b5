use super::super::quadrature::{N, irradiance_by_area, over_hemisphere, over_sphere, over_square};
use super::*;
use glam::DVec3;

fn assert_close(closed: f64, quadrature: f64, tolerance: f64, what: &str) {
    let error = (closed - quadrature).abs();
    assert!(
        error < tolerance,
        "{what}: {closed}, by quadrature {quadrature}"
    );
}

/// Cosine-weighted fraction of the hemisphere about +z in which `seen` holds.
fn fraction(seen: impl Fn(DVec3) -> bool) -> f64 {
    over_hemisphere(|i| f64::from(u8::from(seen(i)))) / PI
}

/// Error of [`fraction`]: half a row of cells, where an outline runs along a row.
const OUTLINE: f64 = 0.5 / N as f64 + 1e-4;

#[test]
fn rectangles_agree_with_quadrature_over_the_area() {
    for (a, b, c) in [(1.0, 1.0, 1.0), (0.3, 2.0, 0.5), (0.01, 0.02, 1.0)] {
        let corners = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b)];
        let quadrature = irradiance_by_area(DVec3::Z, &corners.map(|(x, y)| DVec3::new(x, y, c)));
        // The midpoint rule: (side/distance)²/1024² of it.
        let closed = parallel_rectangle(a, b, c);
        assert_close(closed, quadrature / PI, 2e-5 * closed, "parallel");
    }
    for (height, width, distance) in [(1.0, 1.0, 1.0), (2.0, 0.5, 0.4), (0.2, 3.0, 2.0)] {
        let corners = [(0.0, 0.0), (0.0, height), (width, height), (width, 0.0)];
        let corners = corners.map(|(x, z)| DVec3::new(x, distance, z));
        let quadrature = irradiance_by_area(DVec3::Z, &corners);
        let closed = perpendicular_rectangle(height, width, distance);
        assert_close(closed, quadrature / PI, 2e-5 * closed, "perpendicular");
    }
}

/// Mean over pairs of points in the unit interval of a function of how far they are apart, by the
/// triangular density of that distance.
fn apart(u: f64) -> f64 {
    2.0 * (1.0 - u)
}

#[test]
fn the_cubes_faces_agree_with_quadrature_over_both() {
    let kernel = |u: f64, v: f64| apart(u) * apart(v) / (PI * (u * u + v * v + 1.0).powi(2));
    // The midpoint rule: 1/1024².
    assert_close(over_square(N, kernel), CUBE_OPPOSITE, 1e-6, "opposite");

    // One point on the floor at distance x from the shared edge, the other on the wall at height z.
    let over_both = |cells: usize| {
        let along_the_edge = |x: f64, z: f64| {
            let at = |k: usize| (k as f64 + 0.5) / cells as f64;
            let kernel = |v: f64| apart(v) * x * z / (PI * (x * x + z * z + v * v).powi(2));
            (0..cells).map(|k| kernel(at(k))).sum::<f64>() / cells as f64
        };
        over_square(cells, along_the_edge)
    };
    // The kernel rises as 1/r² towards the edge, and the cells there, 1/n of all, are integrated
    // badly: an error of first order, which two sizes eliminate, and of second order, 1/128².
    let quadrature = 2.0 * over_both(256) - over_both(128);
    assert_close(quadrature, CUBE_ADJACENT, 1e-5, "adjacent");
    let closure = CUBE_OPPOSITE + 4.0 * CUBE_ADJACENT;
    assert!((closure - 1.0).abs() < 1e-15, "{closure}");
}

/// Factor to a disc of radius r at height h, its centre `a` off the normal, by ∫ cos θ cos θ'/(πr²) dA
/// with cells even in the squared radius and the angle.
fn disc_by_area(cells: usize, r: f64, h: f64, a: f64) -> f64 {
    let kernel = |u: f64, v: f64| {
        let (s, c) = (2.0 * PI * v).sin_cos();
        let (x, y) = (r * u.sqrt() * c - a, r * u.sqrt() * s);
        h * h / (x * x + y * y + h * h).powi(2)
    };
    over_square(cells, kernel) * r * r
}

#[test]
fn discs_agree_with_quadrature_over_the_area() {
    for (r, h, a) in [(1.0, 1.0, 0.5), (0.3, 0.7, 1.2), (2.0, 0.4, 1.9)] {
        let closed = [(0.0, coaxial_disc(r, h)), (a, offset_disc(r, h, a))];
        for (a, closed) in closed {
            // The midpoint rule: k²/(12·1024²) with k of the farthest place on the disc.
            let k = ((r + a) / h) * ((r + a) / h);
            assert_close(closed, disc_by_area(N, r, h, a), k * k * 1e-7, "disc");
        }
    }
}

#[test]
fn spheres_agree_with_quadrature() {
    for (r, d, cos_theta) in [(1.0_f64, 2.0, 0.8), (0.5, 0.6, 0.9), (1.0, 3.0, 0.34_f64)] {
        let axis = DVec3::new((1.0 - cos_theta * cos_theta).sqrt(), 0.0, cos_theta);
        let cos_radius = (1.0 - (r / d) * (r / d)).sqrt();
        let seen = fraction(|i| i.dot(axis) > cos_radius);
        let sphere = sphere_above_horizon(r, d, cos_theta);
        assert_close(sphere, seen, OUTLINE, "sphere");
        let open = openness_beside_sphere(r, d, cos_theta);
        assert_close(open, 1.0 - seen, OUTLINE, "openness");
    }
}

#[test]
fn openness_agrees_with_quadrature() {
    for tilt in [0.0_f64, 0.4, 1.3, 2.8] {
        let m = DVec3::new(tilt.sin(), 0.0, tilt.cos());
        let open = fraction(|i| m.dot(i) >= 0.0);
        let closed = openness_beside_half_space(tilt.cos());
        assert_close(closed, open, OUTLINE, "half-space");
    }
    for (h, d) in [(1.0, 1.0), (0.2, 1.5), (5.0, 0.5)] {
        let open = fraction(|i| i.x <= 0.0 || i.z / i.x > h / d);
        assert_close(openness_beside_wall(h, d), open, OUTLINE, "wall");
    }
    for (a, b, h) in [(2.0, 2.0, 1.0), (1.0, 4.0, 0.5)] {
        let open = fraction(|i| (2.0 * h * i.x / i.z).abs() < a && (2.0 * h * i.y / i.z).abs() < b);
        assert_close(openness_in_pit(a, b, h), open, OUTLINE, "pit");
    }
}

#[test]
fn coaxial_discs_agree_with_quadrature_over_both_and_are_reciprocal() {
    const CELLS: usize = 256;
    for (r1, r2, h) in [(1.0, 2.0, 1.0), (1.0, 0.5, 0.7), (0.7, 0.9, 2.0_f64)] {
        // By symmetry the places on disc 1 lie along its radius, even in area.
        let ring = |i: usize| r1 * ((i as f64 + 0.5) / CELLS as f64).sqrt();
        let from_ring = |i: usize| disc_by_area(CELLS, r2, h, ring(i));
        let mean = (0..CELLS).map(from_ring).sum::<f64>() / CELLS as f64;
        let (f12, f21) = (coaxial_discs(r1, r2, h), coaxial_discs(r2, r1, h));
        // The midpoint rule: (radius/height)²/256².
        assert_close(f12, mean, 2e-5, "coaxial discs");
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

/// Radiance in a furnace obeys L = 1 + ρ/π·∫ L cos θ dω, from one number of reflections to the next.
#[test]
fn a_furnace_reflects_what_the_last_reflection_gave() {
    let (albedo, mut radiance) = (0.6, 1.0);
    for k in 1..5 {
        radiance = 1.0 + albedo / PI * over_hemisphere(|_| radiance);
        // A constant is integrated exactly, but for rounding.
        assert_close(furnace_radiance(albedo, Some(k)), radiance, 1e-9, "furnace");
    }
}

/// One reflection by the wall of a sphere: each patch of it radiates ρE/π.
#[test]
fn an_integrating_sphere_lit_from_anywhere_agrees_with_quadrature() {
    let (albedo, radius) = (0.6, 1.5);
    let source = DVec3::new(0.4, -0.9, 0.3);
    for x in [DVec3::Z, DVec3::new(0.6, 0.0, -0.8)].map(|d| d * radius) {
        let sum = over_sphere(|d| {
            let (y, inward) = (d * radius, -d);
            let (s, r) = (source - y, x - y);
            let lit = s.dot(inward) / (4.0 * PI * s.length().powi(3));
            let (cos_y, cos_x) = (inward.dot(r), (-x / radius).dot(-r));
            let kernel = cos_y * cos_x / r.length_squared().powi(2);
            albedo / PI * lit * kernel * radius * radius
        });
        // The midpoint rule: (radius/distance to the source)⁴/1024².
        let error = sum / integrating_sphere(albedo, radius, false) - 1.0;
        assert!(error.abs() < 1e-4, "{error}");
    }
}

#[test]
fn the_mean_of_schlicks_factor_agrees_with_quadrature() {
    for f0 in [0.0, 0.04, 0.9] {
        let quadrature = over_hemisphere(|i| f0 + (1.0 - f0) * (1.0 - i.z).powi(5)) / PI;
        // Its slope in cos²θ is endless at the horizon: N^(−3/2).
        assert_close(schlick_mean(f0), quadrature, 3e-5, "Schlick");
    }
}
