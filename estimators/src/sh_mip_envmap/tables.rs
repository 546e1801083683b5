//! What depends on the parameters alone: weights of texels.

use super::ShMipEnvmap;
use super::math::{HARMONICS, band_factor, harmonics};
use crate::averaging::{cube_texels, face_solid_angles_sr};
use glam::DVec3;
use interreflect_cpu::lane::Vector;
use interreflect_scene::conventions::{cube_vector, texel_centre, texel_solid_angle_sr};
use interreflect_scene::params::Fidelity;

/// Nodes and weights of the Gauss–Legendre rule of four points on [−1, 1].
const GAUSS: [(f64, f64); 4] = [
    (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
    (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
];

/// Weights of the averaged texels in the coefficients of the irradiance, in sr: harmonic by
/// harmonic the texels in the order of their indices, band factors included.
///
/// `published` takes Y at a texel's centre times its exact solid angle, `corrected` ∫Y dω over it.
pub(super) fn harmonic_weights(params: &ShMipEnvmap) -> Vec<f32> {
    let size = params.sh_size();
    let texels: Vec<[f64; HARMONICS]> = cube_texels(size)
        .map(|(face, column, row)| match params.fidelity {
            Fidelity::Published => at_centre(size, face, column, row),
            Fidelity::Corrected => over_texel(size, face, column, row),
        })
        .collect();
    let factor = |i| band_factor(i, params.window);
    (0..HARMONICS)
        .flat_map(|i| texels.iter().map(move |y| (factor(i) * y[i]) as f32))
        .collect()
}

fn harmonics_along(direction: DVec3) -> [f64; HARMONICS] {
    let d = direction.normalize();
    harmonics(Vector::new(d.x, d.y, d.z))
}

fn at_centre(size: u32, face: usize, column: u32, row: u32) -> [f64; HARMONICS] {
    let centre = cube_vector(face, texel_centre(size, column), texel_centre(size, row));
    let omega_sr = texel_solid_angle_sr(size, column, row);
    harmonics_along(centre).map(|y| y * omega_sr)
}

/// ∫Y dω by a product rule over the texel's square, where dω = ds dt/(1 + s² + t²)^(3/2): a
/// relative error below 1e-7 at 8² texels a face.
fn over_texel(size: u32, face: usize, column: u32, row: u32) -> [f64; HARMONICS] {
    let half = 1.0 / f64::from(size);
    let mut sum = [0.0; HARMONICS];
    for (v, weight_v) in GAUSS {
        for (u, weight_u) in GAUSS {
            let s = texel_centre(size, column) + half * u;
            let t = texel_centre(size, row) + half * v;
            let direction = cube_vector(face, s, t);
            let omega_sr = half * half * weight_u * weight_v / direction.length().powi(3);
            for (sum, y) in sum.iter_mut().zip(harmonics_along(direction)) {
                *sum += y * omega_sr;
            }
        }
    }
    sum
}

/// Weights of the texels of a face of `size`² in a box-filtered mean: all the same in
/// `published`, their solid angles in `corrected`.
pub(super) fn box_weights(fidelity: Fidelity, size: u32) -> Vec<f32> {
    match fidelity {
        Fidelity::Published => vec![1.0; (size * size) as usize],
        Fidelity::Corrected => face_solid_angles_sr(size),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn weights_are_orthogonal_to_a_constant_and_sum_to_pi_in_band_0() {
        for fidelity in [Fidelity::Published, Fidelity::Corrected] {
            let params = ShMipEnvmap {
                fidelity,
                ..ShMipEnvmap::default()
            };
            let weights = harmonic_weights(&params);
            let texels = weights.len() / HARMONICS;
            for (i, weights) in weights.chunks_exact(texels).enumerate() {
                let sum: f64 = weights.iter().map(|w| f64::from(*w)).sum();
                // Y₀ = 1/√4π, and E = π under a constant environment.
                let expected = if i == 0 { PI * (4.0 * PI).sqrt() } else { 0.0 };
                // Roundings of 384 numbers of 0.1 to float32, and the rule's stated error.
                assert!((sum - expected).abs() < 2e-6, "{fidelity:?} {i}: {sum}");
            }
        }
    }
}
