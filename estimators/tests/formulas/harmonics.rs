//! Spherical harmonics and the mip pyramid.

use crate::{HEMISPHERE, integral, near, of, vector, within};
use interreflect_estimators::sh_mip_envmap::{self, Window};
use interreflect_scene::conventions::{cube_vector, texel_centre};
use std::f64::consts::PI;

const SPHERE: [f64; 2] = [0.0, PI];

/// Orthonormal, in the order 1; y, z, x; xy, yz, 3z² − 1, xz, x² − y², all positive where they should be.
#[test]
fn harmonics_are_orthonormal_ordered_and_positive() {
    use sh_mip_envmap::math::{HARMONICS, harmonics};
    for i in 0..HARMONICS {
        for j in 0..=i {
            let product = integral(SPHERE, |w| {
                let y = harmonics(of(w));
                y[i] * y[j]
            });
            within(product, f64::from(u8::from(i == j)), 1e-5);
        }
    }
    let (x, y, z) = (0.6, 0.48, 0.64);
    let found = harmonics(vector(x, y, z));
    let shape = [
        1.0,
        y,
        z,
        x,
        x * y,
        y * z,
        3.0 * z * z - 1.0,
        x * z,
        x * x - y * y,
    ];
    for (i, (found, shape)) in found.iter().zip(shape).enumerate() {
        let band =
            |l: [f64; 2]| integral(SPHERE, |w| (w.z.powi(l[0] as i32) * w.x.powf(l[1])).powi(2));
        let norm = match i {
            0 => band([0.0, 0.0]),
            1..=3 => band([1.0, 0.0]),
            4 | 5 | 7 => integral(SPHERE, |w| (w.x * w.y).powi(2)),
            6 => integral(SPHERE, |w| (3.0 * w.z * w.z - 1.0).powi(2)),
            _ => integral(SPHERE, |w| (w.x * w.x - w.y * w.y).powi(2)),
        };
        within(*found, shape / norm.sqrt(), 1e-5);
    }
}

/// Funk and Hecke: Âₗ = 2π∫₀¹ t·Pₗ(t) dt. Hann's window over three bands: (1 + cos(πl/3))/2.
#[test]
fn bands_have_the_clamped_cosine_s_factors() {
    use sh_mip_envmap::math::band_factor;
    let legendre: [fn(f64) -> f64; 3] = [|_| 1.0, |t| t, |t| 0.5 * (3.0 * t * t - 1.0)];
    for (band, indices) in [0..1, 1..4, 4..9].into_iter().enumerate() {
        let cosine = integral(HEMISPHERE, |w| w.z * legendre[band](w.z));
        let hann = 0.5 * (1.0 + (PI * band as f64 / 3.0).cos());
        for index in indices {
            within(band_factor(index, Window::None), cosine, 1e-5);
            within(band_factor(index, Window::Hanning), hann * cosine, 1e-5);
        }
    }
}

/// A level of s² has faces of (s + 2)² with its border; a direction's texel is that around it.
#[test]
fn levels_and_taps_of_the_pyramid_lie_where_they_are_stored() {
    use sh_mip_envmap::math::{biased_level, level_offset, mip_taps};
    let (mut offset, mut size) = (0, 64);
    while size > 0 {
        assert_eq!(level_offset(64, size), offset, "level of {size}");
        offset += 6 * (size + 2) * (size + 2);
        size /= 2;
    }
    // The middle of texel (column 3, row 1) of face 2 of 8²: stored at (4, 2) of its 10².
    let direction = cube_vector(2, texel_centre(8, 3), texel_centre(8, 1));
    let (at, u, v) = mip_taps(8, of(direction));
    assert_eq!(at, (2 * 10 + 2) * 10 + 4);
    assert!(u.abs() < 1e-9 && v.abs() < 1e-9, "{u} {v}");
    // A quarter of a texel to the right and half a texel down.
    let direction = cube_vector(
        2,
        texel_centre(8, 3) + 0.25 / 4.0,
        texel_centre(8, 1) + 0.5 / 4.0,
    );
    let (at, u, v) = mip_taps(8, of(direction));
    assert_eq!(at, (2 * 10 + 2) * 10 + 4);
    near(u, 0.25);
    near(v, 0.5);
    // A texel of 64² is 2/64 rad wide in the middle of a face: that is level 0, four of them level 2.
    let level = |footprint: f64, bias: f64| biased_level(footprint, 64.0, bias, 6.0);
    near(level(2.0 / 64.0, 0.0), 0.0);
    near(level(8.0 / 64.0, 0.0), 2.0);
    near(level(8.0 / 64.0, 1.5), 3.5);
    near(level(8.0 / 64.0, -3.0), 0.0);
    near(level(8.0 / 64.0, 9.0), 6.0);
    near(level(0.0, 0.0), 0.0);
}
