// One texel, laid out as `Texel` in mod.rs.
struct Texel {
    direction: vec3f,
    // w = 1/d; 0 at infinity.
    inverse_distance: f32,
    radiance: vec3f,
    // What the method says of the texel's size.
    extent: f32,
    normal: vec3f,
    pad: f32,
}
