//! What classic environment mapping makes of a Blinn–Phong material.

/// Phong exponent whose lobe around the reflected direction is about as wide as the Blinn–Phong
/// lobe of this shininess around the half vector: a quarter of it (SPEC, baselines).
pub fn phong_exponent(shininess: f32) -> f32 {
    0.25 * shininess
}
