//! Visibility and what it counts, over any [`Lane`].

use interreflect_cpu::lane::Lane;

/// Rounding of a depth in [0, 1] that two float32 computations may differ by: an orthographic
/// projection of three products and the interpolation over a triangle.
pub const DEPTH_ROUNDING: f32 = 5e-7;

/// 1 where a point's `depth` passes the depth test against the map's, which lets it lie `margin`
/// behind, else 0 (P5, §3). Depths in [0, 1], 0 nearest.
#[inline(always)]
pub fn passes<L: Lane>(depth: L, map_depth: L, margin: L) -> L {
    let rounding = L::splat(f64::from(DEPTH_ROUNDING));
    let behind = depth - (map_depth + margin + rounding);
    behind.select_gt(L::splat(0.0), L::splat(0.0), L::splat(1.0))
}

/// M_ij = n_i·l_j where the direction is open, else 0 (P5, §3.2), but no less than `least`: −1 for M_ij
/// as printed, 0 to let directions below the horizon count nothing.
#[inline(always)]
pub fn open_cosine<L: Lane>(cos_theta: L, open: L, least: L) -> L {
    cos_theta.max(least) * open
}
