//! Irradiance from a polygon of uniform radiance.

use glam::DVec3;

/// Irradiance in W/m² at a point with unit normal `n` from a planar polygon that radiates 1
/// W·m⁻²·sr⁻¹ (Lambert): ½·Σ Γ_i·n over the edges of the polygon clipped to the upper hemisphere.
///
/// `corners` are relative to the point. Positive when they run clockwise seen from the point. No
/// edge through the point itself gives a contribution.
pub fn polygon_irradiance(n: DVec3, corners: &[DVec3]) -> f64 {
    if corners.iter().all(|c| n.dot(*c) >= 0.0) {
        around(n, corners)
    } else {
        around(n, &clipped(n, corners))
    }
}

/// ½·Σ Γ_i·n of a polygon that is wholly above the horizon.
fn around(n: DVec3, corners: &[DVec3]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sum: f64 = corners
        .iter()
        .zip(next)
        .map(|(&a, &b)| edge(a, b).dot(n))
        .sum();
    0.5 * sum
}

/// Γ of the edge from `a` to `b`: the angle it spans times the unit normal of its plane through
/// the point, from the difference b − a, which keeps small polygons accurate.
fn edge(a: DVec3, b: DVec3) -> DVec3 {
    let c = a.cross(b - a);
    let length = c.length();
    if length == 0.0 {
        return DVec3::ZERO;
    }
    c * (length.atan2(a.dot(b)) / length)
}

/// The part of a polygon with n·R ≥ 0.
fn clipped(n: DVec3, corners: &[DVec3]) -> Vec<DVec3> {
    let mut above = Vec::with_capacity(corners.len() + 1);
    for (i, &a) in corners.iter().enumerate() {
        let b = corners[(i + 1) % corners.len()];
        let (ha, hb) = (n.dot(a), n.dot(b));
        if ha >= 0.0 {
            above.push(a);
        }
        if (ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0) {
            above.push(a + (b - a) * (ha / (ha - hb)));
        }
    }
    above
}

#[cfg(test)]
mod tests {
    use super::super::form_factors::{parallel_rectangle, perpendicular_rectangle};
    use super::super::quadrature::irradiance_by_area;
    use super::*;
    use std::f64::consts::PI;

    /// A polygon with corners on an ellipse: semi-axes along two vectors.
    fn around_ellipse(n: usize, centre: DVec3, a: DVec3, b: DVec3) -> Vec<DVec3> {
        let corner = |i: usize| {
            let (s, c) = (i as f64 / n as f64 * 2.0 * PI).sin_cos();
            centre + a * c + b * s
        };
        (0..n).map(corner).collect()
    }

    #[test]
    fn agrees_with_quadrature_over_the_area() {
        let n = DVec3::new(0.3, -0.2, 0.8).normalize();
        for (corners, centre, a, b) in [
            // Above the horizon, near and far.
            (4, DVec3::new(0.2, 0.1, 1.0), DVec3::X, DVec3::Y),
            (7, DVec3::new(0.5, -3.0, 4.0), DVec3::X * 0.3, DVec3::Z),
            // Cut by the horizon, little of it left above, and all of it below.
            (4, DVec3::new(1.0, 0.4, 0.0), DVec3::Y, DVec3::Z * 2.0),
            (5, DVec3::new(0.0, 1.0, -0.5), DVec3::X, DVec3::Z),
            (3, DVec3::new(0.0, 0.5, -2.0), DVec3::X, DVec3::Y),
            // Slivers, one of them cut.
            (4, DVec3::new(0.3, 0.5, 0.6), DVec3::X, DVec3::Y * 1e-4),
            (3, DVec3::new(1.0, 0.3, 0.0), DVec3::Y * 1e-6, DVec3::Z),
        ] {
            let corners = around_ellipse(corners, centre, a, b);
            let closed = polygon_irradiance(n, &corners).abs();
            let quadrature = irradiance_by_area(n, &corners);
            // The midpoint rule: (size/distance)²/1024², with a kink at the horizon.
            let error = (closed - quadrature).abs();
            assert!(
                error <= 2e-5 * quadrature,
                "{centre}: {closed}, by quadrature {quadrature}"
            );
        }
    }

    /// Closer than quadrature can tell: the closed forms of rectangles, both of them tried by it.
    #[test]
    fn agrees_with_the_closed_forms_of_rectangles_to_rounding() {
        for (a, b, c) in [(1.0, 1.0, 1.0), (10.0, 5.0, 1e-3), (0.01, 0.02, 1.0)] {
            let square = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b)];
            let above = square.map(|(x, y)| DVec3::new(x, y, c));
            // It stands on the receiver's plane: cut exactly at the horizon.
            let ahead = square.map(|(x, z)| DVec3::new(x, c, z));
            for (corners, exact) in [
                (above, parallel_rectangle(a, b, c)),
                (ahead, perpendicular_rectangle(b, a, c)),
            ] {
                let f = polygon_irradiance(DVec3::Z, &corners).abs() / PI;
                assert!((f / exact - 1.0).abs() < 1e-11, "{a} {b} {c}: {f} {exact}");
            }
        }
    }

    /// Fractions of the hemisphere as the point nears the polygon; at height h what is missing is h
    /// over the distance to the other edges.
    #[test]
    fn ends_at_one_inside_half_on_an_edge_and_a_quarter_in_a_right_corner() {
        let h = 1e-9;
        let square = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)];
        for (x, y, exact) in [
            (0.3, 0.6, 1.0),
            (0.0, 0.4, 0.5),
            (0.7, 1.0, 0.5),
            (0.0, 0.0, 0.25),
            (1.0, 0.0, 0.25),
            (1.5, 0.5, 0.0),
        ] {
            let corners = square.map(|(s, t)| DVec3::new(s - x, t - y, h));
            let f = polygon_irradiance(DVec3::Z, &corners).abs() / PI;
            assert!((f - exact).abs() < 10.0 * h, "({x}, {y}): {f}");
        }
    }

    #[test]
    fn a_polygon_through_the_point_gives_nothing_that_is_not_a_number() {
        let degenerate = [DVec3::ZERO, DVec3::X, DVec3::X, DVec3::new(0.0, 1.0, 1.0)];
        assert!(polygon_irradiance(DVec3::Z, &degenerate).is_finite());
        assert_eq!(polygon_irradiance(DVec3::Z, &[]), 0.0);
    }

    #[test]
    fn a_rectangle_half_below_the_horizon_counts_its_upper_half_only() {
        let corners = |low: f64| {
            [
                DVec3::new(-1.0, 1.0, low),
                DVec3::new(-1.0, 1.0, 2.0),
                DVec3::new(1.0, 1.0, 2.0),
                DVec3::new(1.0, 1.0, low),
            ]
        };
        let whole = polygon_irradiance(DVec3::Z, &corners(-3.0));
        let upper = polygon_irradiance(DVec3::Z, &corners(0.0));
        assert!(
            (whole - upper).abs() < 1e-14 && upper > 0.1,
            "{whole} {upper}"
        );
    }

    #[test]
    fn closes_inside_a_box_and_reverses_with_the_winding() {
        let n = DVec3::new(0.2, -0.5, 0.7).normalize();
        let x = DVec3::new(0.3, -0.2, 0.6);
        let mut sum = 0.0;
        for face in 0..6 {
            let mut corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)]
                .map(|(s, t)| interreflect_scene::conventions::cube_vector(face, s, t) - x);
            let f = polygon_irradiance(n, &corners);
            corners.reverse();
            assert!((f + polygon_irradiance(n, &corners)).abs() < 1e-14);
            sum += f;
        }
        assert!((sum / PI - 1.0).abs() < 1e-13, "{sum}");
    }
}
