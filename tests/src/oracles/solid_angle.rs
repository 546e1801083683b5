//! Solid angle of a polygon.

use glam::DVec3;

/// Solid angle in sr of a convex planar polygon, seen from the origin of its corners; the winding
/// does not matter.
///
/// A fan of triangles, each by tan(Ω/2) = |a·(b × c)| / (abc + (a·b)c + (b·c)a + (c·a)b)
/// (Van Oosterom & Strackee, The Solid Angle of a Plane Triangle, 1983), the triple product from
/// differences of corners, which keeps small polygons accurate. Domain: the origin is not in the
/// polygon's plane, where the answer jumps between 0 and 2π.
pub fn polygon_solid_angle_sr(corners: &[DVec3]) -> f64 {
    let Some((&apex, rest)) = corners.split_first() else {
        return 0.0;
    };
    rest.windows(2).map(|e| triangle(apex, e[0], e[1])).sum()
}

fn triangle(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let (la, lb, lc) = (a.length(), b.length(), c.length());
    let volume = a.dot((b - a).cross(c - a)).abs();
    let rest = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * volume.atan2(rest)
}

#[cfg(test)]
mod tests {
    use super::super::quadrature::over_polygon;
    use super::*;
    use std::f64::consts::PI;

    /// ∫ cos θ'/r² dA over the polygon.
    fn by_area(corners: &[DVec3]) -> f64 {
        let across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let normal = across.normalize();
        over_polygon(corners, |y| y.dot(normal).abs() / y.length().powi(3))
    }

    /// A regular polygon around (0, 0, h), tilted about x, its centre moved by `offset`.
    fn regular(n: usize, radius: f64, tilt: f64, centre: DVec3) -> Vec<DVec3> {
        let corner = |i: usize| {
            let (s, c) = (i as f64 / n as f64 * 2.0 * PI).sin_cos();
            centre + radius * DVec3::new(c, s * tilt.cos(), s * tilt.sin())
        };
        (0..n).map(corner).collect()
    }

    #[test]
    fn agrees_with_quadrature_over_the_area() {
        for (n, radius, tilt, centre) in [
            (3, 1.0, 0.0, DVec3::new(0.0, 0.0, 1.0)),
            (4, 0.02, 0.4, DVec3::new(0.5, -0.2, 0.3)),
            (5, 2.0, 1.1, DVec3::new(-0.4, 0.3, -0.9)),
            (8, 3.0, 0.2, DVec3::new(1.0, 2.0, 0.7)),
        ] {
            let mut corners = regular(n, radius, tilt, centre);
            let (closed, quadrature) = (polygon_solid_angle_sr(&corners), by_area(&corners));
            // The midpoint rule with 1024² cells a triangle: (size/distance)²/1024², relative.
            let error = (closed / quadrature - 1.0).abs();
            assert!(error < 2e-5, "{n}: {closed}, by quadrature {quadrature}");
            corners.reverse();
            let reversed = polygon_solid_angle_sr(&corners);
            assert!((reversed / closed - 1.0).abs() < 1e-13, "{n}: {reversed}");
        }
    }

    #[test]
    fn keeps_its_accuracy_for_small_and_for_thin_polygons() {
        // A thin or small piece far away: A·cos θ'/r², good to (size/distance)².
        for (width, height) in [(1e-6, 1e-6), (1e-9, 1e-3), (1e-12, 1e-4)] {
            let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
                .map(|(x, y)| DVec3::new(x, y, 2.0));
            let point = width * height / 4.0;
            let error = polygon_solid_angle_sr(&corners) / point - 1.0;
            assert!(error.abs() < 2.0 * height * height + 1e-12, "{error}");
        }
    }

    #[test]
    fn fills_the_sphere_inside_a_box_and_half_of_it_close_to_a_plane() {
        let x = DVec3::new(0.3, -0.7, 0.99);
        let face = |face| {
            [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)]
                .map(|(s, t)| interreflect_scene::conventions::cube_vector(face, s, t) - x)
        };
        let sum: f64 = (0..6).map(|f| polygon_solid_angle_sr(&face(f))).sum();
        assert!((sum / (4.0 * PI) - 1.0).abs() < 1e-14, "{sum}");
        // A square seen from 1e-8 of its side: 2π less the light past its edge, 4√2·1e-8·2.
        let near = regular(4, 1.0, 0.0, DVec3::new(0.01, 0.02, 1e-8));
        let omega = polygon_solid_angle_sr(&near);
        assert!((omega / (2.0 * PI) - 1.0).abs() < 1e-7, "{omega}");
        assert_eq!(polygon_solid_angle_sr(&[]), 0.0);
    }
}
