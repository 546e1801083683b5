//! Rectangles cut into cells.

use crate::Mesh;
use glam::Vec3;

/// A rectangle from `corner` along two orthogonal edges in metres, cut into `cells` along each, two
/// triangles a cell; its front faces `right × up`, and so do its normals.
pub fn grid(corner: Vec3, right: Vec3, up: Vec3, cells: [u32; 2]) -> Mesh {
    let [columns, rows] = cells.map(|c| c.max(1));
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        for column in 0..=columns {
            let (s, t) = (column as f32 / columns as f32, row as f32 / rows as f32);
            mesh.positions.push(corner + right * s + up * t);
        }
    }
    for row in 0..rows {
        for column in 0..columns {
            let at = |c: u32, r: u32| (row + r) * (columns + 1) + column + c;
            let (a, b, c, d) = (at(0, 0), at(1, 0), at(1, 1), at(0, 1));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh.normals = vec![right.cross(up).normalize_or(Vec3::Y); mesh.positions.len()];
    mesh.materials = vec![0; mesh.triangles.len()];
    mesh
}
