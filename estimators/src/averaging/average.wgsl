// The captured cube averaged down to fewer texels, one invocation each.

struct Average {
    // Texels along the edge of the averaged and of the captured cube.
    resolution: u32,
    size: u32,
    // Texels of border around each averaged face, which are left as they are.
    border: u32,
    pad: u32,
}

@group(0) @binding(0) var<uniform> average: Average;
@group(0) @binding(1) var<storage, read_write> averaged: array<vec4f>;
@group(0) @binding(2) var captured: texture_2d_array<f32>;
// Weights of the captured texels of a face.
@group(0) @binding(3) var<storage, read> weights: array<f32>;

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
        let weight = weights[at.y * average.size + at.x];
        sum += vec4f(textureLoad(captured, at, face, 0).rgb, 1.0) * weight;
    }
    let side = average.resolution + 2u * average.border;
    let place = texel_index(side, face, column + average.border, row + average.border);
    averaged[place] = vec4f(sum.rgb / sum.w, 0.0);
}
