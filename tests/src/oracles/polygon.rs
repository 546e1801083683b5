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
    use super::super::form_factors::*;
    use super::*;
    use std::f64::consts::PI;

    /// A rectangle in the plane z = c with one corner above the point.
    fn parallel(a: f64, b: f64, c: f64) -> [DVec3; 4] {
        [
            DVec3::new(0.0, 0.0, c),
            DVec3::new(a, 0.0, c),
            DVec3::new(a, b, c),
            DVec3::new(0.0, b, c),
        ]
    }

    #[test]
    fn agrees_with_the_closed_form_of_a_parallel_rectangle() {
        for (a, b, c) in [
            (1.0, 1.0, 1.0),
            (0.3, 2.0, 0.5),
            (10.0, 5.0, 1e-3),
            (0.01, 0.02, 1.0),
        ] {
            let f = polygon_irradiance(DVec3::Z, &parallel(a, b, c)) / PI;
            let exact = parallel_rectangle(a, b, c);
            assert!((f / exact - 1.0).abs() < 1e-11, "{a} {b} {c}: {f} {exact}");
        }
    }

    #[test]
    fn agrees_with_the_closed_form_of_a_perpendicular_rectangle() {
        for (height, width, distance) in [(1.0, 1.0, 1.0), (2.0, 0.5, 0.1), (0.2, 3.0, 2.0)] {
            // Stands on the receiver's plane: clipped exactly at the horizon.
            let corners = [
                DVec3::new(0.0, distance, 0.0),
                DVec3::new(0.0, distance, height),
                DVec3::new(width, distance, height),
                DVec3::new(width, distance, 0.0),
            ];
            let f = polygon_irradiance(DVec3::Z, &corners).abs() / PI;
            let exact = perpendicular_rectangle(height, width, distance);
            assert!(
                (f / exact - 1.0).abs() < 1e-11,
                "{height} {width} {distance}"
            );
        }
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
