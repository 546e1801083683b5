// Σ_j M_ij·value_j. Needs the part POINTS and math.wgsl.

const MAX_DIRECTIONS: u32 = 1026u;

struct Direction {
    towards: vec3f,
    value: vec3f,
}

struct Light {
    count: u32,
    // Points in a word's run of bits.
    stride: u32,
    // What a cosine counts at least.
    least: f32,
    directions: array<Direction, MAX_DIRECTIONS>,
}

@group(0) @binding(3) var<uniform> light: Light;
@group(0) @binding(4) var<storage, read> visibility: array<u32>;

@compute @workgroup_size(64)
fn shade(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let n = point_vector(point, NORMAL);
    var sum = vec3f(0.0);
    var bits = 0u;
    for (var j = 0u; j < light.count; j += 1u) {
        if j % 32u == 0u {
            bits = visibility[j / 32u * light.stride + point];
        }
        let direction = light.directions[j];
        sum += open_cosine(dot(n, direction.towards), f32(bits & 1u), light.least) * direction.value;
        bits >>= 1u;
    }
    write_estimate(point, sum);
}
