// Twins of math.rs, function by function.

// Phong exponent about as wide as the Blinn–Phong lobe of this shininess.
fn phong_exponent(shininess: f32) -> f32 {
    return 0.25 * shininess;
}
