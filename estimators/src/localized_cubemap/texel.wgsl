// One texel, laid out as `Texel` in texels.rs.
struct Texel {
    direction: vec3f,
    // w = 1/d; 0 at infinity.
    inverse_distance: f32,
    radiance: vec3f,
    // Published: Δω'. Corrected: A/d².
    extent: f32,
    normal: vec3f,
    pad: f32,
}
