//! A detailed organic shape that needs no file.

use super::sphere;
use super::waves::{gyroid, swirl};
use crate::{Mesh, normals};

/// Parts into which an edge of the icosahedron is cut: 20·32² = 20 480 triangles.
const FREQUENCY: u32 = 32;

/// Waves on the surface: wave number, amplitude relative to the radius, phase.
const WAVES: [(f32, f32, f32); 4] = [
    (1.9, 0.18, 0.4),
    (3.7, 0.11, 1.9),
    (7.3, 0.034, 4.1),
    (14.1, 0.008, 2.6),
];

/// A closed organic surface of radius about one metre with bulges, hollows and fine ripples: a
/// sphere displaced along its radius by waves of four sizes. It is the same on every call.
pub fn blob() -> Mesh {
    let mut mesh = sphere(1.0, FREQUENCY);
    for p in &mut mesh.positions {
        let direction = *p;
        // Bending space before the finer waves keeps them from lining up with the axes.
        let bent = direction + 0.35 * swirl(2.3 * direction);
        let height: f32 = WAVES
            .iter()
            .map(|(number, amplitude, phase)| amplitude * gyroid(*number * bent + *phase))
            .sum();
        *p = direction * (1.0 + height);
    }
    normals::smooth(&mut mesh);
    mesh
}
