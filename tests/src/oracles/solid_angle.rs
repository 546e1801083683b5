//! Solid angles.

use glam::DVec3;

/// Solid angle in sr of a convex planar polygon, its corners relative to the point: triangles of a
/// fan, each by the formula of Van Oosterom and Strackee.
pub fn polygon_solid_angle_sr(corners: &[DVec3]) -> f64 {
    let triangle = |a: DVec3, b: DVec3, c: DVec3| {
        let (la, lb, lc) = (a.length(), b.length(), c.length());
        let along = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        2.0 * a.dot(b.cross(c)).atan2(along)
    };
    let rest = corners.windows(2).skip(1);
    rest.map(|edge| triangle(corners[0], edge[0], edge[1]))
        .sum::<f64>()
        .abs()
}
