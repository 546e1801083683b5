//! The point-to-point form factor, over any [`Lane`].

use interreflect_cpu::lane::Lane;

/// Solid angle A·c/r² in sr of a small surface, as if it were a point; at most `largest`.
///
/// `area` is A/d², `r2` = (r/d)² ≥ 0 and `cos_surface` the cosine between the surface's normal and
/// the direction to x; 0 behind the surface and at it. Unbounded as r → 0: the singularity of
/// virtual point lights.
#[inline(always)]
pub fn point_omega<L: Lane>(area: L, r2: L, cos_surface: L, largest: L) -> L {
    let seen = area * cos_surface.max(L::splat(0.0));
    (seen / r2.max(L::splat(f64::from(f32::MIN_POSITIVE)))).min(largest)
}
