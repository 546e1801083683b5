// Twins of math.rs, function by function.

// ∫(n·ω)⁺dω over a texel of vector solid angle Ω, which the horizon may cut.
fn cosine_weight(n: vec3f, vector: vec3f) -> f32 {
    let omega = length(vector);
    let cos_theta = dot(n, vector) / omega;
    let half_width = 0.5 * sqrt(omega);
    let risen = clamp(cos_theta + half_width, 0.0, 2.0 * half_width);
    return omega * (risen * risen / (4.0 * half_width) + max(cos_theta - half_width, 0.0));
}

// (cos/cos_max)^N, 0 for cos ≤ 0.
fn phong_weight(cos_theta: f32, cos_max: f32, exponent: f32) -> f32 {
    return lobe_power(cos_theta / cos_max, exponent);
}

struct MapTaps {
    // The node of the smallest column and row, and the nodes in a row of nodes.
    base: u32,
    side: u32,
    u: f32,
    v: f32,
}

// Nodes of one convolved map.
fn map_nodes(cells: u32) -> u32 {
    return CUBE_FACES * (cells + 1u) * (cells + 1u);
}

// The four nodes around a direction, with their bilinear weights.
fn map_taps(cells: u32, direction: vec3f) -> MapTaps {
    let at = cube_coordinates(direction);
    let place = (vec2f(at.s, at.t) * 0.5 + 0.5) * f32(cells);
    let cell = floor(clamp(place, vec2f(0.0), vec2f(f32(cells) - 1.0)));
    let side = cells + 1u;
    let base = (at.face * side + u32(cell.y)) * side + u32(cell.x);
    return MapTaps(base, side, place.x - cell.x, place.y - cell.y);
}
