// Latitude–longitude images: row r at θ = (r+½)π/H from +y, column c at φ = (c+½)2π/W, direction
// (sin θ sin φ, cos θ, −sin θ cos φ). Needs the part MATH.

// Bilinear radiance in a unit direction: columns wrap around, rows clamp at the poles.
fn sample_lat_long(image: texture_2d<f32>, direction: vec3f) -> vec3f {
    let size = vec2i(textureDimensions(image));
    // At the poles every φ is right, but atan2(0, 0) is undefined.
    let flat_length = length(direction.xz);
    let phi = select(0.0, atan2(direction.x, -direction.z), flat_length > 0.0);
    let theta = atan2(flat_length, direction.y);
    let turn = phi / TAU;
    let u = (turn - floor(turn)) * f32(size.x) - 0.5;
    let v = theta / PI * f32(size.y) - 0.5;
    let low = vec2i(floor(vec2f(u, v)));
    let f = vec2f(u, v) - floor(vec2f(u, v));
    let columns = (vec2i(low.x, low.x + 1) + size.x) % size.x;
    let rows = clamp(vec2i(low.y, low.y + 1), vec2i(0), vec2i(size.y - 1));
    let above = mix(
        textureLoad(image, vec2i(columns.x, rows.x), 0).rgb,
        textureLoad(image, vec2i(columns.y, rows.x), 0).rgb,
        f.x,
    );
    let below = mix(
        textureLoad(image, vec2i(columns.x, rows.y), 0).rgb,
        textureLoad(image, vec2i(columns.y, rows.y), 0).rgb,
        f.x,
    );
    return mix(above, below, f.y);
}
