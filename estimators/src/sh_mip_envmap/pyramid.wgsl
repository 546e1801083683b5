// The box-filtered mip pyramid: each level from the finer one, then the borders of all.

struct Reduce {
    // Texels along a face's edge of the base and of the level that is filled.
    base: u32,
    size: u32,
    // First weight of the finer level's texels.
    first_weight: u32,
    // 1: the border takes the neighbours across the edges, else a face's own texels.
    across: u32,
}

@group(0) @binding(0) var<uniform> reduce: Reduce;
@group(0) @binding(1) var<storage, read_write> pyramid: array<vec4f>;
// Weights of the texels of a face, level by level, the finest first.
@group(0) @binding(2) var<storage, read> weights: array<f32>;

// Place of a stored texel of a level: columns and rows count the border.
fn place(size: u32, face: u32, column: u32, row: u32) -> u32 {
    return level_offset(reduce.base, size) + texel_index(size + 2u, face, column, row);
}

@compute @workgroup_size(64)
fn reduce_level(@builtin(global_invocation_id) id: vec3u) {
    let size = reduce.size;
    if id.x >= CUBE_FACES * size * size {
        return;
    }
    let column = id.x % size;
    let row = id.x / size % size;
    let face = id.x / (size * size);
    let finer = 2u * size;
    var sum = vec4f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let at = vec2u(2u * column + k % 2u, 2u * row + k / 2u);
        let weight = weights[reduce.first_weight + at.y * finer + at.x];
        sum += vec4f(pyramid[place(finer, face, at.x + 1u, at.y + 1u)].rgb, 1.0) * weight;
    }
    pyramid[place(size, face, column + 1u, row + 1u)] = vec4f(sum.rgb / sum.w, 0.0);
}

// The texel at column and row ∈ [−1, size] of a face, but for a corner of the border.
fn texel_of(size: u32, face: u32, at: vec2i) -> vec3f {
    let found = neighbour(size, face, at.x, at.y);
    return pyramid[place(size, found.x, found.y + 1u, found.z + 1u)].rgb;
}

// All borders, an invocation for each stored texel.
@compute @workgroup_size(64)
fn fill_borders(@builtin(global_invocation_id) id: vec3u) {
    var size = reduce.base;
    var index = id.x;
    while index >= CUBE_FACES * (size + 2u) * (size + 2u) {
        index -= CUBE_FACES * (size + 2u) * (size + 2u);
        if size == 1u {
            return;
        }
        size /= 2u;
    }
    let side = size + 2u;
    let column = index % side;
    let row = index / side % side;
    let face = index / (side * side);
    let at = vec2i(i32(column), i32(row)) - 1;
    let inside = clamp(at, vec2i(0), vec2i(i32(size) - 1));
    let beyond = at != inside;
    if !any(beyond) {
        return;
    }
    var value = texel_of(size, face, inside);
    if reduce.across != 0u {
        if all(beyond) {
            // Three texels meet in a corner.
            let others = texel_of(size, face, vec2i(at.x, inside.y)) + texel_of(size, face, vec2i(inside.x, at.y));
            value = (value + others) / 3.0;
        } else {
            value = texel_of(size, face, at);
        }
    }
    pyramid[place(size, face, column, row)] = vec4f(value, 0.0);
}
