//! Leaf functions of direct radiance maps, over any [`Lane`].
//!
//! A photon is a lit place on a surface: its position, the radiance L that it reflects, and how
//! large it is. b is the length of the light's way to it, α the angle of the arriving light with the
//! surface's normal, r the distance to the shaded point.

use interreflect_cpu::lane::{Lane, Vector};
use std::f64::consts::{FRAC_1_PI, PI};

/// Smallest cosine that an area is divided by: only a surface lit edge-on is nearer to 0.
const EDGE_ON: f64 = 1e-6;

/// The direction I from x to a photon, and r² in m². Zero where x is the photon's own place, or
/// nearer than float32 resolves: the photon then adds nothing.
#[inline(always)]
pub fn towards_photon<L: Lane>(position: Vector<L>, x: Vector<L>) -> (Vector<L>, L) {
    let r = position - x;
    let r2 = r.dot(r);
    let tiny = L::splat(f64::from(f32::MIN_POSITIVE));
    let inverse = r2.select_gt(tiny, L::splat(1.0) / r2.max(tiny).sqrt(), L::splat(0.0));
    (r.scale(inverse), r2)
}

/// Area across the light's way over b² of one of w² texels of a view of full angle γ in radians:
/// (2·tan(γ/2w))² (eq 12 with a_j = b·tan(γ/2w) and A' = (2a_j)²), which takes the texels to be
/// equal in angle.
pub fn equal_angle_texel(full_angle: f64, texels: u32) -> f64 {
    (2.0 * (full_angle / (2.0 * f64::from(texels))).tan()).powi(2)
}

/// The same solid angle in sr for each of `samples` of a light: 2π/M (eq 11).
pub fn hemisphere_share(samples: usize) -> f64 {
    2.0 * PI / samples as f64
}

/// Area A' in m² across the light's way: `measure` per squared distance times b². Where rays are
/// parallel `measure` is the area itself and `b` is 1.
#[inline(always)]
pub fn area_across<L: Lane>(measure: L, b: L) -> L {
    measure * b * b
}

/// Area A = A'/cos α in m² of the lit surface (eq 13).
#[inline(always)]
pub fn lit_area<L: Lane>(across: L, cos_light: L) -> L {
    across / cos_light.max(L::splat(EDGE_ON))
}

/// Solid angle in sr as if every photon were as far away as the scene is large: A'/|diag|² (eq 15).
#[inline(always)]
pub fn omega_far<L: Lane>(across: L, diagonal2: L) -> L {
    across / diagonal2.max(L::splat(f64::from(f32::MIN_POSITIVE)))
}

/// Solid angle cos θ'·A/(A + r²) in sr of a photon of area A (eq 14): at most 1, for π is missing
/// from the disc formula. 0 behind the surface.
#[inline(always)]
pub fn omega_published<L: Lane>(area: L, r2: L, cos_surface: L) -> L {
    let tiny = L::splat(f64::from(f32::MIN_POSITIVE));
    cos_surface.max(L::splat(0.0)) * area / (area + r2).max(tiny)
}

/// Solid angle A·c/(r² + A·c/π) in sr of a photon of area A, c = cos θ': at most π. 0 behind the
/// surface.
#[inline(always)]
pub fn omega_corrected<L: Lane>(area: L, r2: L, cos_surface: L) -> L {
    let tiny = L::splat(f64::from(f32::MIN_POSITIVE));
    let seen = area * cos_surface.max(L::splat(0.0));
    seen / (r2 + seen * L::splat(FRAC_1_PI)).max(tiny)
}
