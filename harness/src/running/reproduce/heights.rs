//! Where points are between the lowest and the highest of them.

use interreflect_scene::Points;

/// Index of each point with a surface, and its height as a share of that of all: 0 at the lowest, 1 at the highest.
pub(super) fn heights(points: &Points) -> Vec<(usize, f64)> {
    let y_of =
        |(i, point): (usize, Option<interreflect_scene::Point>)| Some((i, point?.position.y));
    let all: Vec<(usize, f32)> = points.iter().enumerate().filter_map(y_of).collect();
    let low = all.iter().map(|h| h.1).fold(f32::INFINITY, f32::min);
    let high = all.iter().map(|h| h.1).fold(f32::NEG_INFINITY, f32::max);
    let extent = f64::from((high - low).max(f32::MIN_POSITIVE));
    let share = |(i, y): (usize, f32)| (i, f64::from(y - low) / extent);
    all.into_iter().map(share).collect()
}
