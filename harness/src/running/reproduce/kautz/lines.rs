//! Mirrored directions along lines over the faces of the cube, and the kinks of what is seen there.

use super::border::mirroring;
use glam::Vec3;
use interreflect_scene::{Estimate, Point, PointLayout, Points};

/// Points of a line.
const STEPS: usize = 1024;

/// Three lines on each of six faces, away from their edges, as pixels see them whose mirrored direction changes by
/// `footprint` radians from one to the next.
pub(super) fn points(footprint: f32) -> Points {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let mut points = Vec::new();
    for i in 0..3 {
        let (a, b, c) = (axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3]);
        for (side, height) in [-1.0, 1.0]
            .into_iter()
            .flat_map(|s| [-0.43, 0.11, 0.57].map(|h| (s, h)))
        {
            for step in 0..STEPS {
                let along = 0.8 * (2.0 * step as f32 / (STEPS - 1) as f32 - 1.0);
                let direction = a * side + b * along + c * height;
                points.push(Some(Point {
                    footprint,
                    ..mirroring(direction.normalize())
                }));
            }
        }
    }
    Points::new(PointLayout::Material, points)
}

/// The strongest change of slope from step to step of each line, over the mean slope, in the mean of all lines: how much of
/// an angle a value's graph has.
pub(super) fn kinks(estimate: &Estimate) -> f64 {
    let values: Vec<f64> = estimate
        .iter()
        .map(|v| f64::from(v.element_sum()))
        .collect();
    let lines = || values.chunks_exact(STEPS);
    let strongest = |line: &[f64]| {
        let changes = line.windows(3).map(|v| (v[0] - 2.0 * v[1] + v[2]).abs());
        changes.fold(0.0, f64::max)
    };
    let slope = |line: &[f64]| -> f64 { line.windows(2).map(|v| (v[1] - v[0]).abs()).sum() };
    let steps = (STEPS - 1) as f64;
    lines().map(strongest).sum::<f64>() / (lines().map(slope).sum::<f64>() / steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_graph_with_angles_has_stronger_kinks_than_a_smooth_one() {
        let graph = |value: &dyn Fn(f64) -> f64| {
            let mut all = Estimate::new(STEPS);
            for i in 0..STEPS {
                let t = i as f64 / STEPS as f64;
                all.set(i, Vec3::splat((2.0 + value(t)) as f32));
            }
            kinks(&all)
        };
        let smooth = graph(&|t| (20.0 * t).sin());
        let angles = graph(&|t| ((10.0 * t) % 2.0 - 1.0).abs());
        assert!(angles > 2.0 * smooth, "{angles} {smooth}");
        assert_eq!(points(0.1).len(), 18 * STEPS);
    }
}
