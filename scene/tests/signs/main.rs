//! Directions, turns and signs of cameras, motions, lights and their frames, each against a value
//! worked out by hand: tilted up vectors, images that are not square, objects off centre.
#![allow(clippy::unwrap_used, reason = "tests")]

mod cameras;
mod captures;
mod lights;
mod motions;

use glam::Vec3;
use interreflect_scene::Mesh;

/// A few roundings of float32 numbers near 1.
pub(crate) const ROUNDING: f32 = 2e-6;

#[track_caller]
pub(crate) fn near(found: Vec3, expected: Vec3) {
    let apart = found.distance(expected);
    let allowed = ROUNDING * expected.length().max(1.0);
    assert!(apart <= allowed, "{found} is not {expected}");
}

/// A box from −2 to 2 about a centre, its corners and three further vertices.
pub(crate) fn boxed(centre: Vec3, more: &[Vec3]) -> Mesh {
    let mut positions = vec![centre - 2.0 * Vec3::ONE, centre + 2.0 * Vec3::ONE];
    positions.extend(more.iter().map(|p| centre + 2.0 * *p));
    Mesh {
        normals: vec![Vec3::Y; positions.len()],
        positions,
        triangles: vec![[0, 1, 2]],
        materials: vec![0],
    }
}
