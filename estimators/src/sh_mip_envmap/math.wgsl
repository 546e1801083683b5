// Twins of math.rs, function by function. Needs the part CUBE.

const HARMONICS: u32 = 9u;

// Real spherical harmonics: 1; y, z, x; xy, yz, 3z² − 1, xz, x² − y².
fn harmonics(n: vec3f) -> array<f32, 9> {
    return array<f32, 9>(
        0.28209479177387814,
        0.4886025119029199 * n.y,
        0.4886025119029199 * n.z,
        0.4886025119029199 * n.x,
        1.0925484305920792 * (n.x * n.y),
        1.0925484305920792 * (n.y * n.z),
        0.31539156525252005 * (3.0 * (n.z * n.z) - 1.0),
        1.0925484305920792 * (n.x * n.z),
        0.5462742152960396 * (n.x * n.x - n.y * n.y),
    );
}

// Texels that are stored before a level: Σ 6(s+2)² over the finer ones.
fn level_offset(base: u32, size: u32) -> u32 {
    let levels = firstLeadingBit(base) - firstLeadingBit(size);
    return CUBE_FACES * (4u * (base * base - size * size) / 3u + 8u * (base - size) + 4u * levels);
}

// A little beyond the edge of a face the direction belongs to the other one.
const BEYOND: f32 = 1.000001;

// The texel at column and row ∈ [−1, size] of a face: face, column, row.
fn neighbour(size: u32, face: u32, column: i32, row: i32) -> vec3u {
    let inside = (2.0 * vec2f(f32(column), f32(row)) + 1.0) / f32(size) - 1.0;
    let place = clamp(inside, vec2f(-BEYOND), vec2f(BEYOND));
    let across = cube_coordinates(cube_vector(face, place.x, place.y));
    return vec3u(across.face, texel_at(size, across.s), texel_at(size, across.t));
}

struct MipTaps {
    // The stored texel of the smallest column and row, and the texels in a row.
    first: u32,
    side: u32,
    u: f32,
    v: f32,
}

// Where a direction meets a level.
fn mip_taps(size: u32, direction: vec3f) -> MipTaps {
    let at = cube_coordinates(direction);
    let place = (vec2f(at.s, at.t) * 0.5 + 0.5) * f32(size) + 0.5;
    let cell = clamp(floor(place), vec2f(0.0), vec2f(f32(size)));
    let side = size + 2u;
    let first = (at.face * side + u32(cell.y)) * side + u32(cell.x);
    return MipTaps(first, side, place.x - cell.x, place.y - cell.y);
}

// Level at which the footprint is one texel, plus a bias.
fn biased_level(footprint: f32, base: f32, bias: f32, top: f32) -> f32 {
    let texels = max(footprint * (0.5 * base), 1e-6);
    return clamp(log2(texels) + bias, 0.0, top);
}
