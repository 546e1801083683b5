// Twins of math.rs, function by function.

fn blended_irradiance(below: vec3f, above: vec3f, up: f32) -> vec3f {
    return PI * (below + (above - below) * (0.5 + 0.5 * up));
}
