// A bit for each point and direction: whether the point is open there. Needs the parts POINTS and
// DIRECTIONAL, and math.wgsl.

struct Batch {
    // First and number of the bits in the word that are found.
    first: u32,
    count: u32,
    // First word of the directions' bits.
    word: u32,
    // First and number of the points to look at, among those to do.
    first_point: u32,
    points: u32,
    // Depth that points may lie behind the map's.
    margin: f32,
}

@group(0) @binding(3) var<uniform> directions: Frames;
@group(0) @binding(4) var depth_maps: texture_depth_2d_array;
@group(0) @binding(5) var<storage, read> todo: array<u32>;
@group(0) @binding(6) var<storage, read_write> visibility: array<u32>;
@group(0) @binding(7) var<uniform> batch: Batch;
// Samples that passed, as 64 bits, for each direction and point of the batch.
@group(0) @binding(8) var<storage, read> answers: array<vec2u>;

fn keep(point: u32, open: u32) {
    let mask = (0xffffffffu >> (32u - batch.count)) << batch.first;
    let index = batch.word + point;
    visibility[index] = (visibility[index] & ~mask) | (open << batch.first);
}

@compute @workgroup_size(64)
fn look_into_maps(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = point_index(group, groups, lane);
    if index >= batch.points {
        return;
    }
    let point = todo[batch.first_point + index];
    var open = 0u;
    if has_surface(point) {
        let position = point_vector(point, POSITION);
        let size = f32(textureDimensions(depth_maps).x);
        for (var i = 0u; i < batch.count; i += 1u) {
            let p = project_along(directions.frames[i], directions.centre, directions.radius, position);
            let texel = vec2u(clamp((p.xy * 0.5 + 0.5) * size, vec2f(0.0), vec2f(size - 0.5)));
            let map_depth = textureLoad(depth_maps, texel, i, 0);
            open |= u32(passes(p.z, map_depth, batch.margin)) << i;
        }
    }
    keep(point, open);
}

@compute @workgroup_size(64)
fn take_answers(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = point_index(group, groups, lane);
    if index >= batch.points {
        return;
    }
    let point = todo[batch.first_point + index];
    var open = 0u;
    if has_surface(point) {
        for (var i = 0u; i < batch.count; i += 1u) {
            open |= u32(any(answers[i * batch.points + index] != vec2u(0u))) << i;
        }
    }
    keep(point, open);
}

// Where nothing occludes.
@compute @workgroup_size(64)
fn all_open(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let index = point_index(group, groups, lane);
    if index < batch.points {
        keep(todo[batch.first_point + index], 0xffffffffu >> (32u - batch.count));
    }
}
