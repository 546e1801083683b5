//! Smooth vertex normals for meshes that bring none.

use crate::Mesh;
use glam::Vec3;
use std::collections::HashMap;

/// Gives a mesh smooth vertex normals: vertices at the same place become one, and each normal is
/// the mean of its triangles' normals, weighted by the angle at the vertex (Thürmer and Wüthrich,
/// *Computing Vertex Normals from Polygonal Facets*, 1998), so that it does not depend on how the
/// surface is cut into triangles.
///
/// Where the mean vanishes the vertex takes the normal of one of its triangles. Triangles of zero
/// area must have been dropped.
pub fn smooth(mesh: &mut Mesh) {
    weld(mesh);
    let mut sums = vec![Vec3::ZERO; mesh.positions.len()];
    let mut fallback = vec![Vec3::Y; mesh.positions.len()];
    for t in 0..mesh.triangles.len() {
        let p = mesh.corners(t);
        let normal = (p[1] - p[0]).cross(p[2] - p[0]).normalize_or_zero();
        for i in 0..3 {
            let v = mesh.triangles[t][i] as usize;
            let (a, b) = (p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
            sums[v] += normal * a.cross(b).length().atan2(a.dot(b));
            if normal != Vec3::ZERO {
                fallback[v] = normal;
            }
        }
    }
    mesh.normals = sums
        .into_iter()
        .zip(fallback)
        .map(|(sum, other)| sum.try_normalize().unwrap_or(other))
        .collect();
}

/// Makes vertices with the same position one, in the order in which triangles use them; vertices
/// that no triangle uses go.
fn weld(mesh: &mut Mesh) {
    let mut index_of = HashMap::with_capacity(mesh.positions.len());
    let mut positions = Vec::new();
    for corner in mesh.triangles.iter_mut().flatten() {
        let p = mesh.positions[*corner as usize] + 0.0; // −0 and 0 are the same place
        *corner = *index_of
            .entry(p.to_array().map(f32::to_bits))
            .or_insert_with(|| {
                positions.push(p);
                positions.len() as u32 - 1
            });
    }
    mesh.positions = positions;
}
