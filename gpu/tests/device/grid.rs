//! Dispatches of more than one row of workgroups, as long lists of points have them.

use crate::{Case, ensure};
use glam::Vec3;
use interreflect_gpu::{GpuContext, GpuError, GpuEstimate, GpuPoints, Shader, wgsl};
use interreflect_scene::{LANES, Point, PointLayout, Points};
use libtest_mimic::Failed;
use std::sync::Arc;

pub(crate) const CASES: &[Case] = &[(
    "grid::every_row_of_workgroups_does_its_own_points",
    every_row_does_its_own_points,
)];

const POINTS: Shader = Shader {
    label: "points test",
    parts: &[wgsl::POINTS, include_str!("points.wgsl")],
};

/// A list that takes seven workgroups in one row is laid out in rows of other lengths; some to spare.
fn every_row_does_its_own_points(context: &Arc<GpuContext>) -> Result<(), Failed> {
    let len = 6 * LANES + 5;
    let place = |i: usize| Vec3::new(i as f32, 1.0, -0.5 * i as f32);
    let points = (0..len).map(|i| {
        Some(Point {
            position: place(i),
            normal: Vec3::Y,
            ..Point::default()
        })
    });
    let points = Points::new(PointLayout::Surface, points);
    let uploaded = GpuPoints::upload(context, &points)?;
    for grid in [[7, 1, 1], [4, 2, 1], [3, 3, 1], [1, 7, 1]] {
        let estimate = GpuEstimate::new(context, len)?;
        let kernel = context.kernel(&POINTS, "surface", &uploaded.bindings(&estimate))?;
        context.record("points", |cx| {
            kernel.record(cx, grid);
            Ok::<_, GpuError>(())
        })?;
        let found = estimate.download(context)?;
        for i in 0..len {
            let expected = place(i) + 10.0 * Vec3::Y;
            ensure!(
                found.get(i) == expected,
                "{grid:?}, point {i}: {} instead of {expected}",
                found.get(i)
            );
        }
    }
    Ok(())
}
