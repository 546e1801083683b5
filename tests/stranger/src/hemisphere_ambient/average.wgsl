// The mean radiance from below and from above, weighted by solid angle: one invocation each.

@group(0) @binding(0) var captured: texture_2d_array<f32>;
@group(0) @binding(1) var<storage, read_write> means: array<vec4f, 2>;

// Four times the solid angle of a texel, but for a factor that all texels share.
fn weight(size: u32, column: u32, row: u32) -> f32 {
    let s = texel_centre(size, column);
    let t = texel_centre(size, row);
    let e = 1.0 / f32(size);
    return corner(s + e, t + e) - corner(s - e, t + e) - corner(s + e, t - e) + corner(s - e, t - e);
}

fn corner(s: f32, t: f32) -> f32 {
    return atan2(s * t, sqrt(s * s + t * t + 1.0));
}

@compute @workgroup_size(2)
fn average(@builtin(local_invocation_index) above: u32) {
    let size = textureDimensions(captured).x;
    var sum = vec4f(0.0);
    for (var face = 0u; face < CUBE_FACES; face++) {
        for (var row = 0u; row < size; row++) {
            for (var column = 0u; column < size; column++) {
                let up = cube_vector(face, texel_centre(size, column), texel_centre(size, row)).y;
                if (up >= 0.0) == (above == 1u) {
                    let radiance = textureLoad(captured, vec2u(column, row), face, 0).rgb;
                    sum += vec4f(radiance, 1.0) * weight(size, column, row);
                }
            }
        }
    }
    means[above] = vec4f(sum.rgb / sum.w, 0.0);
}
