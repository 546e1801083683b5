//! Spherical harmonics of the irradiance, and the lookup into the mip pyramid.
//!
//! A level of s² texels a face is stored as faces of (s+2)² texels, its own with a border of one
//! texel around them; levels follow one another, the finest first.

use super::params::Window;
use interreflect_cpu::lane::{Lane, Scalar, Vector};
use interreflect_scene::conventions::{CUBE_FACES, cube_coordinates, neighbour_texel};
use std::f64::consts::PI;

/// Number of spherical harmonics: bands 0, 1 and 2.
pub const HARMONICS: usize = 9;

/// Real spherical harmonics of a unit direction, orthonormal: 1; y, z, x; xy, yz, 3z² − 1, xz,
/// x² − y², all signs positive (P2).
#[inline(always)]
pub fn harmonics<L: Lane>(n: Vector<L>) -> [L; HARMONICS] {
    let k = |value: f64| L::splat(value);
    let (k1, k2) = (k(0.488_602_511_902_919_9), k(1.092_548_430_592_079_2));
    let (z2, x2_y2) = (n.z * n.z, n.x * n.x - n.y * n.y);
    [
        k(0.282_094_791_773_878_14),
        k1 * n.y,
        k1 * n.z,
        k1 * n.x,
        k2 * (n.x * n.y),
        k2 * (n.y * n.z),
        k(0.315_391_565_252_520_05) * (k(3.0) * z2 - k(1.0)),
        k2 * (n.x * n.z),
        k(0.546_274_215_296_039_6) * x2_y2,
    ]
}

/// Factor on the coefficient of harmonic `index`: the clamped cosine's Â = π, 2π/3, π/4 by band
/// (P2), times the window's.
pub fn band_factor(index: usize, window: Window) -> f64 {
    let (cosine, hanning) = match index {
        0 => (PI, 1.0),
        1..=3 => (2.0 * PI / 3.0, 0.75),
        _ => (PI / 4.0, 0.25),
    };
    match window {
        Window::None => cosine,
        Window::Hanning => cosine * hanning,
    }
}

/// Texels that are stored before a level of `size`² texels a face, in a pyramid whose base has
/// `base`² a face: Σ 6(s+2)² over the finer levels. Both are powers of two.
pub fn level_offset(base: u32, size: u32) -> u32 {
    let levels = base.ilog2() - size.ilog2();
    CUBE_FACES as u32 * (4 * (base * base - size * size) / 3 + 8 * (base - size) + 4 * levels)
}

/// [`neighbour_texel`]: the texel at column and row ∈ [−1, size] of a face, which may lie across an
/// edge.
pub fn neighbour(size: u32, face: usize, column: i32, row: i32) -> (usize, u32, u32) {
    neighbour_texel(size, face, column, row)
}

/// Where a direction, which need not be unit, meets a level of `size`² texels a face: the stored
/// texel of the smallest column and row of the four around it, counted from the level's first, and
/// the bilinear weights of the next column and row.
#[inline]
pub fn mip_taps<S: Scalar>(size: u32, direction: Vector<S>) -> (usize, S, S) {
    let (face, s, t) = cube_coordinates(direction.into());
    let half = S::from(0.5);
    let place = |v: f64| {
        // Stored texel i + 1 has its centre at (i + 1/2)/size.
        let v = (S::splat(v) * half + half) * S::from(size as f32) + half;
        let cell = v.whole().min(size as usize);
        (cell, v - S::from(cell as f32))
    };
    let ((column, u), (row, v)) = (place(s), place(t));
    let side = size as usize + 2;
    ((face * side + row) * side + column, u, v)
}

/// Level at which the mirrored direction's change `footprint` between neighbouring pixels, in
/// radians, is one texel of a pyramid whose base has `base` texels along an edge (2/`base` rad at a
/// face's centre), plus a bias; in [0, `top`]. A footprint of 0, not known, is the finest.
#[inline(always)]
pub fn biased_level<L: Lane>(footprint: L, base: L, bias: L, top: L) -> L {
    let texels = (footprint * (L::from(0.5) * base)).max(L::splat(1e-6));
    (texels.log2() + bias).max(L::from(0.0)).min(top)
}
