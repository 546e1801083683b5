//! Form factors of polygons.

use crate::{near, vector, within};
use interreflect_cpu::lane::Vector;
use interreflect_estimators::polygon_form_factor;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Lambert's formula for a rectangle whose corner lies above the point, at height c, with sides a and b:
/// F = 1/2π·[A/√(1+A²)·atan(B/√(1+A²)) + B/√(1+B²)·atan(A/√(1+B²))].
#[test]
fn polygons_have_their_form_factors_whole_and_clipped() {
    use polygon_form_factor::math::{clipped_quad, edge_angle, edge_cosine, edge_integral};
    let n = vector(0.0, 0.0, 1.0);
    let factor = |a: f64, b: f64| {
        let term = |x: f64, y: f64| {
            let root = (1.0 + x * x).sqrt();
            x / root * (y / root).atan()
        };
        (term(a, b) + term(b, a)) / TAU
    };
    let (a, b, c) = (1.5, 0.7, 2.0);
    // Clockwise seen from below.
    let corners = [
        vector(0.0, 0.0, c),
        vector(a, 0.0, c),
        vector(a, b, c),
        vector(0.0, b, c),
    ];
    let heights = |corners: &[Vector<f64>; 4]| corners.map(|r| r.z);
    let whole = clipped_quad(&corners, &heights(&corners), n);
    let expected = PI * factor(a / c, b / c);
    within(whole.abs(), expected, 1e-9);
    let sign = whole.signum();
    let mut turned = corners;
    turned.reverse();
    within(clipped_quad(&turned, &heights(&turned), n), -whole, 1e-9);
    // A wall of height 1 and width 1 from the floor up, 1 m away, one corner straight ahead: X = Y = 1 of
    // the perpendicular rectangle. Its part below the floor counts nothing.
    let wall = [
        vector(1.0, 0.0, -3.0),
        vector(1.0, 1.0, -3.0),
        vector(1.0, 1.0, 1.0),
        vector(1.0, 0.0, 1.0),
    ];
    let beside = clipped_quad(&wall, &heights(&wall), n).abs();
    let root = 2_f64.sqrt();
    let perpendicular = (FRAC_PI_4 - (1.0 / root) * (1.0 / root).atan()) / TAU;
    within(beside, PI * perpendicular, 1e-9);
    // An edge of 90° in a plane through the normal adds nothing, in the plane of the point its angle.
    let (x, y) = (vector(2.0, 0.0, 0.0), vector(0.0, 3.0, 0.0));
    near(edge_angle(x, y), FRAC_PI_2);
    near(edge_integral(x, y, n), FRAC_PI_2);
    near(edge_integral(y, x, n), -FRAC_PI_2);
    near(edge_cosine(x, y, n), 1.0);
    near(edge_integral(n, x, n), 0.0);
    assert!(sign != 0.0);
}

/// A wall's own plane is below the horizon of a point on it, by sixteen roundings of float32 of what R is
/// made of, and no more.
#[test]
fn the_horizon_lies_sixteen_roundings_high() {
    use polygon_form_factor::math::corner_height;
    let (n, in_plane) = (vector(0.0, 0.0, 1.0), vector(1.0, 0.0, 0.0));
    let sixteen = 16.0 * f64::from(f32::EPSILON);
    for (w, reach) in [(0.0, 0.0), (1.0, 1.0), (0.5, 6.0)] {
        let height = corner_height(in_plane, n, w, reach);
        let scale = 1.0 + w * reach;
        assert!((height / (-sixteen * scale) - 1.0).abs() < 0.1, "{height}");
    }
    near(
        corner_height(vector(0.0, 0.0, 0.5), n, 0.0, 0.0) + 2e-6,
        0.5,
    );
}
