// What cube captures and shadow maps share: projections with reversed depth, and exact distances.
// Needs the part CUBE.

// Clip position of a point, given from the centre of the cube, on a face: depth near/w, so that
// nearer is greater and the far plane lies at infinity.
fn clip_on_face(face: u32, offset: vec3f, near: f32) -> vec4f {
    let axis = cube_vector(face, 0.0, 0.0);
    let s = cube_vector(face, 1.0, 0.0) - axis;
    let t = cube_vector(face, 0.0, 1.0) - axis;
    return vec4f(dot(offset, s), -dot(offset, t), near, dot(offset, axis));
}

// Coordinates (s, t) of a fragment whose position is in texels.
fn face_coordinates(position: vec2f, size: f32) -> vec2f {
    return 2.0 * position / size - 1.0;
}

// Distance along a unit direction to a triangle's plane, given by a vertex and the normal, both
// from the ray's origin. `nearby` is the distance to a point of the triangle close to the ray: it
// stands in where the ray is so nearly parallel to the plane that their intersection is not at
// the triangle.
fn plane_distance(direction: vec3f, vertex: vec3f, normal: vec3f, nearby: f32) -> f32 {
    let cos_theta = dot(normal, direction);
    let height = dot(normal, vertex);
    let safe = select(cos_theta, 1.0, cos_theta == 0.0);
    let distance = height / safe;
    let near_triangle = abs(distance - nearby) <= 0.02 * nearby;
    return select(nearby, distance, cos_theta != 0.0 && near_triangle);
}
