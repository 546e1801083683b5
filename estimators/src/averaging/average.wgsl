// The captured cube averaged down to the texels that the convolution sums over, one invocation each.

struct Average {
    // Texels along the edge of the averaged and of the captured cube.
    resolution: u32,
    size: u32,
}

@group(0) @binding(0) var<uniform> average: Average;
@group(0) @binding(1) var<storage, read_write> sources: array<Source>;
@group(0) @binding(2) var captured: texture_2d_array<f32>;
// Solid angles of the captured texels of a face.
@group(0) @binding(3) var<storage, read> omegas_sr: array<f32>;

@compute @workgroup_size(64)
fn average_radiance(@builtin(global_invocation_id) id: vec3u) {
    let count = CUBE_FACES * average.resolution * average.resolution;
    if id.x >= count {
        return;
    }
    let column = id.x % average.resolution;
    let row = id.x / average.resolution % average.resolution;
    let face = id.x / (average.resolution * average.resolution);
    let step = average.size / average.resolution;
    var sum = vec4f(0.0);
    for (var k = 0u; k < step * step; k++) {
        let at = vec2u(column, row) * step + vec2u(k % step, k / step);
        let omega_sr = omegas_sr[at.y * average.size + at.x];
        sum += vec4f(textureLoad(captured, at, face, 0).rgb, 1.0) * omega_sr;
    }
    sources[id.x].radiance = sum.rgb / sum.w;
}
