//! Averaging a captured cube down to fewer texels.

mod gpu;

pub use gpu::{AVERAGE, Target, captured_radiance, record_average};

use glam::{DVec3, Vec3};
use interreflect_scene::CubeImage;
use interreflect_scene::conventions::{CUBE_FACES, texel_index};

/// Solid angles in sr of the texels of one face of `size`² texels, row by row; the other faces'
/// are the same.
///
/// As [`interreflect_scene::conventions::texel_solid_angle_sr`], with each corner computed once.
pub fn face_solid_angles_sr(size: u32) -> Vec<f32> {
    let n = size as usize;
    let edge = |i: usize| 2.0 * i as f64 / f64::from(size) - 1.0;
    let corner = |i: usize, j: usize| {
        let (a, b) = (edge(i), edge(j));
        (a * b).atan2((a * a + b * b + 1.0).sqrt())
    };
    let mut above: Vec<f64> = (0..=n).map(|i| corner(i, 0)).collect();
    let mut omegas_sr = Vec::with_capacity(n * n);
    for j in 1..=n {
        let below: Vec<f64> = (0..=n).map(|i| corner(i, j)).collect();
        for i in 0..n {
            omegas_sr.push((below[i + 1] - below[i] - above[i + 1] + above[i]) as f32);
        }
        above = below;
    }
    omegas_sr
}

/// Captured texels (index on the face, index in the cube) on a face of `size`² that one of m×m
/// texels covers. `size` is a multiple of `m`.
pub fn covered(
    m: u32,
    size: u32,
    face: usize,
    column: u32,
    row: u32,
) -> impl Iterator<Item = (usize, usize)> {
    let step = size / m;
    let face_start = texel_index(size, face, 0, 0);
    (row * step..(row + 1) * step).flat_map(move |r| {
        (column * step..(column + 1) * step).map(move |c| {
            let on_face = texel_index(size, 0, c, r);
            (on_face, face_start + on_face)
        })
    })
}

/// Mean radiance of one of m×m texels, weighted by the exact solid angles of what it covers:
/// `omegas_sr` is [`face_solid_angles_sr`] of the captured size.
pub fn mean_radiance(
    captured: &CubeImage,
    omegas_sr: &[f32],
    m: u32,
    face: usize,
    column: u32,
    row: u32,
) -> Vec3 {
    let (mut radiance, mut total) = (DVec3::ZERO, 0.0);
    for (on_face, index) in covered(m, captured.size, face, column, row) {
        let omega_sr = f64::from(omegas_sr[on_face]);
        radiance += captured.radiance[index].as_dvec3() * omega_sr;
        total += omega_sr;
    }
    (radiance / total).as_vec3()
}

/// Mean radiance of all texels of a cube of `m`² a face, in the order of texel indices; weights as
/// in [`mean_radiance`].
pub fn averaged<'a>(
    captured: &'a CubeImage,
    omegas_sr: &'a [f32],
    m: u32,
) -> impl Iterator<Item = Vec3> + 'a {
    let mean = move |(face, column, row)| mean_radiance(captured, omegas_sr, m, face, column, row);
    cube_texels(m).map(mean)
}

/// Face, column and row of every texel of a cube of `size`² a face, in the order of texel indices.
pub fn cube_texels(size: u32) -> impl Iterator<Item = (usize, u32, u32)> {
    (0..CUBE_FACES).flat_map(move |face| {
        (0..size).flat_map(move |row| (0..size).map(move |column| (face, column, row)))
    })
}

#[cfg(test)]
mod tests {
    use super::gpu::Average;
    use super::*;
    use interreflect_gpu::layout::assert_layout;

    #[test]
    fn structs_have_the_same_layout() {
        assert_layout!(AVERAGE, Average, [resolution, size, border, pad]);
    }
    use interreflect_scene::conventions::texel_solid_angle_sr;

    #[test]
    fn solid_angles_are_those_of_the_conventions() {
        for size in [1, 2, 7, 64] {
            let omegas_sr = face_solid_angles_sr(size);
            for row in 0..size {
                for column in 0..size {
                    let exact = texel_solid_angle_sr(size, column, row);
                    let ours = f64::from(omegas_sr[texel_index(size, 0, column, row)]);
                    // One rounding to float32.
                    assert!((ours / exact - 1.0).abs() < 1e-7, "{size} {column} {row}");
                }
            }
        }
    }
}
