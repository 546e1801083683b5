//! Procedural meshes, centred at the origin, each triangle of material 0.

mod blob;
mod geodesic;
mod grid;
pub(crate) mod waves;

pub use blob::blob;
pub use geodesic::sphere;
pub use grid::grid;

use crate::{Mesh, conventions};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// To which side a closed mesh shows its front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// An object: the front is outside.
    Outward,
    /// A room: the front is inside.
    Inward,
}

/// A rectangle in the xz-plane whose front faces +y; width along x, depth along z, in metres.
pub fn quad(width: f32, depth: f32) -> Mesh {
    let (x, z) = (0.5 * width, 0.5 * depth);
    let corner = |x: f32, z: f32| Vec3::new(x, 0.0, z);
    polygons(vec![
        corner(-x, z),
        corner(x, z),
        corner(x, -z),
        corner(-x, -z),
    ])
}

/// An axis-aligned box of the given size in metres: faces +x −x +y −y +z −z, two triangles each,
/// no shared vertices.
pub fn cuboid(size: Vec3, facing: Facing) -> Mesh {
    let mut positions = Vec::with_capacity(24);
    for face in 0..conventions::CUBE_FACES {
        // (s, t, −axis) is right-handed: this order is counter-clockwise seen from inside.
        let mut corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        if facing == Facing::Outward {
            corners.reverse();
        }
        positions.extend(
            corners.map(|(s, t)| conventions::cube_vector(face, s, t).as_vec3() * 0.5 * size),
        );
    }
    polygons(positions)
}

/// Quads of four vertices each, in order, as a flat mesh.
fn polygons(positions: Vec<Vec3>) -> Mesh {
    let quads = positions.len() as u32 / 4;
    Mesh {
        triangles: (0..quads)
            .map(|q| 4 * q)
            .flat_map(|v| [[v, v + 1, v + 2], [v, v + 2, v + 3]])
            .collect(),
        materials: vec![0; 2 * quads as usize],
        normals: Vec::new(),
        positions,
    }
}

/// A torus around the y-axis: `radius` from the axis to the middle of the tube of radius `tube`,
/// in metres, with exact normals; `around` segments around the axis, half as many around the tube.
pub fn torus(radius: f32, tube: f32, around: u32) -> Mesh {
    let (columns, rows) = (around.max(3), (around / 2).max(3));
    let mut mesh = Mesh::default();
    for c in 0..columns {
        let (sin_u, cos_u) = (TAU * c as f32 / columns as f32).sin_cos();
        for r in 0..rows {
            let v = Vec2::from_angle(TAU * r as f32 / rows as f32);
            let normal = Vec3::new(v.x * cos_u, v.y, v.x * sin_u);
            mesh.normals.push(normal);
            mesh.positions
                .push(Vec3::new(cos_u, 0.0, sin_u) * radius + normal * tube);
            let at = |c: u32, r: u32| c % columns * rows + r % rows;
            let (a, b, d, e) = (at(c, r), at(c, r + 1), at(c + 1, r), at(c + 1, r + 1));
            mesh.triangles.extend([[a, b, e], [a, e, d]]);
        }
    }
    mesh.materials = vec![0; mesh.triangles.len()];
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::PI;

    /// Volume by the divergence theorem; negative when the front is inside.
    fn signed_volume(mesh: &Mesh) -> f32 {
        (0..mesh.triangles.len())
            .map(|t| mesh.corners(t))
            .map(|[a, b, c]| a.dot(b.cross(c)) / 6.0)
            .sum()
    }

    /// A closed surface uses each edge once in each direction.
    fn assert_closed(mesh: &Mesh) {
        let mut edges = std::collections::HashSet::new();
        for t in &mesh.triangles {
            for i in 0..3 {
                assert!(
                    edges.insert((t[i], t[(i + 1) % 3])),
                    "an edge is used twice"
                );
            }
        }
        assert!(
            edges.iter().all(|(a, b)| edges.contains(&(*b, *a))),
            "an edge is open"
        );
    }

    #[test]
    fn fronts_face_the_promised_side() {
        let size = Vec3::new(1.0, 2.0, 3.0);
        assert_eq!(signed_volume(&cuboid(size, Facing::Outward)), 6.0);
        assert_eq!(signed_volume(&cuboid(size, Facing::Inward)), -6.0);
        let [a, b, c] = quad(2.0, 3.0).corners(0);
        assert!((b - a).cross(c - a).y > 0.0);
        let grid = grid(Vec3::X, Vec3::Z, 2.0 * Vec3::X, [3, 5]);
        assert_eq!(grid.triangles.len(), 30);
        for t in 0..30 {
            assert_eq!(grid.normal(t), Vec3::Y);
        }
    }

    #[test]
    fn round_shapes_are_closed_and_as_large_as_their_formulas() {
        // Inscribed facets lose volume as 1/segments²: 1 % covers 16 and 96 segments.
        let close = |mesh: &Mesh, volume: f32| {
            assert_closed(mesh);
            let found = signed_volume(mesh);
            assert!((found / volume - 1.0).abs() < 0.01, "{found} for {volume}");
        };
        close(&sphere(2.0, 16), 4.0 / 3.0 * PI * 8.0);
        close(&torus(1.0, 0.3, 96), 2.0 * PI * PI * 0.09);
    }

    #[test]
    fn normals_point_out_of_the_surface() {
        for mesh in [sphere(1.0, 8), torus(1.0, 0.4, 48), blob()] {
            for (i, t) in mesh.triangles.iter().enumerate() {
                let [a, b, c] = mesh.corners(i);
                let flat = (b - a).cross(c - a).normalize();
                for v in t {
                    let n = mesh.normals[*v as usize];
                    assert!((n.length() - 1.0).abs() < 1e-5);
                    assert!(n.dot(flat) > 0.5, "triangle {i}: {}", n.dot(flat));
                }
            }
        }
    }

    #[test]
    fn the_blob_is_closed_detailed_and_both_convex_and_concave() {
        let mesh = blob();
        assert_closed(&mesh);
        assert!((15_000..30_000).contains(&mesh.triangles.len()));
        // Mean curvature's sign: on which side of the tangent plane the neighbours lie.
        let mut lean = vec![0.0f32; mesh.positions.len()];
        for t in &mesh.triangles {
            for i in 0..3 {
                let (v, w) = (t[i] as usize, t[(i + 1) % 3] as usize);
                lean[v] += mesh.normals[v].dot((mesh.positions[w] - mesh.positions[v]).normalize());
            }
        }
        let concave = lean.iter().filter(|l| **l > 0.0).count() as f32 / lean.len() as f32;
        assert!(
            (0.15..0.7).contains(&concave),
            "{concave} of the vertices are in hollows"
        );
    }
}
