// A texel at infinity, laid out as `Source` in map.rs.
struct Source {
    // Vector solid angle in sr.
    vector: vec3f,
    pad: f32,
    radiance: vec3f,
    pad2: f32,
}
