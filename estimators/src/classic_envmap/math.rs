//! What classic environment mapping makes of a Blinn–Phong material.

use interreflect_cpu::lane::Lane;

/// Phong exponent whose lobe around the reflected direction is about as wide as the Blinn–Phong
/// lobe of this shininess around the half vector: a quarter of it (SPEC, baselines).
#[inline(always)]
pub fn phong_exponent<L: Lane>(shininess: L) -> L {
    L::from(0.25) * shininess
}
