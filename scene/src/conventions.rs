//! Axes, cube-face order and texel geometry: the one place that fixes them.
//!
//! A cube map has edge 2 around its reference point. Faces come in the order +x −x +y −y +z −z
//! and are laid out as Vulkan, Direct3D and WebGPU sample them, so a captured cube can be bound
//! as a hardware cube texture as it is. Texel (0, 0) is at s = t = −1; `s` grows with the column,
//! `t` with the row.

use glam::DVec3;

/// Number of faces of a cube map.
pub const CUBE_FACES: usize = 6;

/// Vector `L` from the centre of the cube of edge 2 to the point (s, t) ∈ [−1, 1]² of a face.
///
/// Not normalised: its largest component has magnitude 1.
#[inline]
pub fn cube_vector(face: usize, s: f64, t: f64) -> DVec3 {
    match face {
        0 => DVec3::new(1.0, -t, -s),
        1 => DVec3::new(-1.0, -t, s),
        2 => DVec3::new(s, 1.0, t),
        3 => DVec3::new(s, -1.0, -t),
        4 => DVec3::new(s, -t, 1.0),
        5 => DVec3::new(-s, -t, -1.0),
        _ => unreachable!("a cube has six faces, asked for face {face}"),
    }
}

/// The unit axis of a face (its centre) and the directions in which `s` and `t` grow.
pub fn cube_frame(face: usize) -> (DVec3, DVec3, DVec3) {
    let axis = cube_vector(face, 0.0, 0.0);
    (
        axis,
        cube_vector(face, 1.0, 0.0) - axis,
        cube_vector(face, 0.0, 1.0) - axis,
    )
}

/// Face and coordinates (s, t) in [−1, 1]² at which a direction leaves the cube; inverse of
/// [`cube_vector`]. Ties between axes go to x, then y.
#[inline]
pub fn cube_coordinates(direction: DVec3) -> (usize, f64, f64) {
    let d = direction;
    let m = d.abs();
    if m.x >= m.y && m.x >= m.z {
        let face = usize::from(d.x < 0.0);
        (face, if face == 0 { -d.z } else { d.z } / m.x, -d.y / m.x)
    } else if m.y >= m.z {
        let face = 2 + usize::from(d.y < 0.0);
        (face, d.x / m.y, if face == 2 { d.z } else { -d.z } / m.y)
    } else {
        let face = 4 + usize::from(d.z < 0.0);
        (face, if face == 4 { d.x } else { -d.x } / m.z, -d.y / m.z)
    }
}

/// Coordinate s or t ∈ (−1, 1) of the centre of texel `index` on a face of `size` texels an edge.
#[inline]
pub fn texel_centre(size: u32, index: u32) -> f64 {
    (2.0 * f64::from(index) + 1.0) / f64::from(size) - 1.0
}

/// Exact solid angle in sr of texel (column, row) on a face of `size` texels an edge.
///
/// Difference over the four corners (a, b) of atan2(a·b, √(a² + b² + 1)); over all texels of all
/// faces it sums to 4π.
pub fn texel_solid_angle_sr(size: u32, column: u32, row: u32) -> f64 {
    let edge = |i: u32| 2.0 * f64::from(i) / f64::from(size) - 1.0;
    let corner = |a: f64, b: f64| (a * b).atan2((a * a + b * b + 1.0).sqrt());
    let (a0, a1, b0, b1) = (edge(column), edge(column + 1), edge(row), edge(row + 1));
    corner(a1, b1) - corner(a0, b1) - corner(a1, b0) + corner(a0, b0)
}

/// Index of texel (face, column, row) in every capture image and buffer: faces, then rows.
#[inline]
pub fn texel_index(size: u32, face: usize, column: u32, row: u32) -> usize {
    (face * size as usize + row as usize) * size as usize + column as usize
}

/// The texel (face, column, row) at column and row ∈ [−1, size] of a face of `size`² texels: of this
/// face, or the one across an edge. Not for corners of the border, where three texels meet.
pub fn neighbour_texel(size: u32, face: usize, column: i32, row: i32) -> (usize, u32, u32) {
    // A little beyond the edge the direction belongs to the other face.
    const BEYOND: f64 = 1.0 + 1e-6;
    let inside = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(size) - 1.0;
    let place = |i: i32| inside(i).clamp(-BEYOND, BEYOND);
    let (face, s, t) = cube_coordinates(cube_vector(face, place(column), place(row)));
    let texel =
        |v: f64| ((v * 0.5 + 0.5) * f64::from(size)).clamp(0.0, f64::from(size) - 0.5) as u32;
    (face, texel(s), texel(t))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solid_angles_of_a_cube_sum_to_the_sphere() {
        for size in [1, 2, 3, 16, 64] {
            let face: f64 = (0..size)
                .flat_map(|y| (0..size).map(move |x| texel_solid_angle_sr(size, x, y)))
                .sum();
            let error = (6.0 * face - 4.0 * std::f64::consts::PI).abs();
            assert!(error < 1e-11, "size {size}: {error}");
        }
    }

    #[test]
    fn coordinates_invert_vectors_on_every_face() {
        for face in 0..CUBE_FACES {
            for (s, t) in [(0.0, 0.0), (0.5, -0.25), (-0.9, 0.7)] {
                let (f, s2, t2) = cube_coordinates(cube_vector(face, s, t) * 3.0);
                assert_eq!(f, face);
                assert!((s - s2).abs() < 1e-15 && (t - t2).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn frames_are_left_handed_like_hardware_cubes() {
        for face in 0..CUBE_FACES {
            let (axis, s, t) = cube_frame(face);
            assert_eq!(s.cross(t), -axis, "face {face}");
        }
    }
}
