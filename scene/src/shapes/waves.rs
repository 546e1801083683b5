//! Smooth functions of space without a preferred direction, the same on every call: what organic
//! shapes are displaced by.

use glam::Vec3;

/// The gyroid's function, a smooth wave without a preferred direction; within ±1.5.
pub(crate) fn gyroid(p: Vec3) -> f32 {
    let (s, c) = (p.map(f32::sin), p.map(f32::cos));
    s.dot(Vec3::new(c.y, c.z, c.x))
}

/// A smooth vector field that turns space around.
pub(crate) fn swirl(p: Vec3) -> Vec3 {
    Vec3::new((p.y + 0.7).sin(), (p.z + 1.3).sin(), (p.x + 2.1).sin())
}
