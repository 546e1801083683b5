// Cube-face order, axes and texel geometry: +x −x +y −y +z −z, texel (0, 0) at s = t = −1.

const CUBE_FACES: u32 = 6u;

struct CubeCoordinates {
    face: u32,
    s: f32,
    t: f32,
}

// Vector from the centre of the cube of edge 2 to (s, t) ∈ [−1, 1]² of a face; not normalised.
fn cube_vector(face: u32, s: f32, t: f32) -> vec3f {
    switch face {
        case 0u: { return vec3f(1.0, -t, -s); }
        case 1u: { return vec3f(-1.0, -t, s); }
        case 2u: { return vec3f(s, 1.0, t); }
        case 3u: { return vec3f(s, -1.0, -t); }
        case 4u: { return vec3f(s, -t, 1.0); }
        default: { return vec3f(-s, -t, -1.0); }
    }
}

// Face and (s, t) at which a direction ≠ 0 leaves the cube. Ties between axes go to x, then y.
fn cube_coordinates(direction: vec3f) -> CubeCoordinates {
    let d = direction;
    let m = abs(d);
    if m.x >= m.y && m.x >= m.z {
        let positive = d.x >= 0.0;
        return CubeCoordinates(select(1u, 0u, positive), select(d.z, -d.z, positive) / m.x, -d.y / m.x);
    }
    if m.y >= m.z {
        let positive = d.y >= 0.0;
        return CubeCoordinates(select(3u, 2u, positive), d.x / m.y, select(-d.z, d.z, positive) / m.y);
    }
    let positive = d.z >= 0.0;
    return CubeCoordinates(select(5u, 4u, positive), select(-d.x, d.x, positive) / m.z, -d.y / m.z);
}

// Coordinate s or t ∈ (−1, 1) of the centre of texel `index` on a face of `size` texels an edge.
fn texel_centre(size: u32, index: u32) -> f32 {
    return (2.0 * f32(index) + 1.0) / f32(size) - 1.0;
}

// Column or row of the texel that holds the coordinate s or t ∈ [−1, 1].
fn texel_at(size: u32, coordinate: f32) -> u32 {
    return u32(clamp((coordinate * 0.5 + 0.5) * f32(size), 0.0, f32(size) - 0.5));
}

// Index of texel (face, column, row) in every capture image and buffer: faces, then rows.
fn texel_index(size: u32, face: u32, column: u32, row: u32) -> u32 {
    return (face * size + row) * size + column;
}
