//! Spheres from a subdivided icosahedron: triangles of nearly equal size.

use crate::Mesh;
use glam::Vec3;
use std::collections::HashMap;

/// A sphere of the given radius in metres with exact normals: an icosahedron whose edges are cut
/// into `frequency` parts, 20·frequency² triangles.
pub fn sphere(radius: f32, frequency: u32) -> Mesh {
    let frequency = frequency.max(1);
    let mut mesh = Mesh::default();
    let mut index_of = HashMap::new();
    let corners = icosahedron();
    for face in FACES {
        let [a, b, c] = face.map(|v| corners[v]);
        // Vertices on shared edges are found again by their lattice weights on the icosahedron's
        // corners, which are exact where positions would round.
        let mut vertex = |i: u32, j: u32| {
            let weights = [frequency - i - j, i, j];
            let mut key: Vec<_> = (0..3)
                .map(|k| (face[k], weights[k]))
                .filter(|w| w.1 > 0)
                .collect();
            key.sort_unstable();
            *index_of.entry(key).or_insert_with(|| {
                let [wa, wb, wc] = weights.map(|w| w as f32);
                let normal = (a * wa + b * wb + c * wc).normalize();
                mesh.normals.push(normal);
                mesh.positions.push(normal * radius);
                mesh.positions.len() as u32 - 1
            })
        };
        for i in 0..frequency {
            for j in 0..frequency - i {
                let (v, right, up) = (vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
                mesh.triangles.push([v, right, up]);
                if i + j + 1 < frequency {
                    mesh.triangles.push([right, vertex(i + 1, j + 1), up]);
                }
            }
        }
    }
    mesh.materials = vec![0; mesh.triangles.len()];
    mesh
}

/// The twelve corners (0, ±1, ±φ) and their cyclic permutations, φ the golden ratio.
fn icosahedron() -> [Vec3; 12] {
    let phi = 0.5 * (1.0 + 5.0f32.sqrt());
    let v = Vec3::new;
    [
        v(-1.0, phi, 0.0),
        v(1.0, phi, 0.0),
        v(-1.0, -phi, 0.0),
        v(1.0, -phi, 0.0),
        v(0.0, -1.0, phi),
        v(0.0, 1.0, phi),
        v(0.0, -1.0, -phi),
        v(0.0, 1.0, -phi),
        v(phi, 0.0, -1.0),
        v(phi, 0.0, 1.0),
        v(-phi, 0.0, -1.0),
        v(-phi, 0.0, 1.0),
    ]
}

/// The icosahedron's faces, counter-clockwise from outside.
const FACES: [[usize; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];
