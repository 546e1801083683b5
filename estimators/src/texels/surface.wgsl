// The surface along a ray, from the captured texel beside it. Needs the part CUBE; the shader binds
// `captured` (rgb radiance, a distance, 0: no surface) and `normals`.

const NEAREST_M: f32 = 1e-30;

// Which channels of place the capture has.
const PLACE_NONE: u32 = 0u;
const PLACE_DISTANCE: u32 = 1u;
const PLACE_NORMAL: u32 = 2u;

struct Surface {
    // 1/d in 1/m, 0 where there is no surface.
    inverse_distance: f32,
    normal: vec3f,
}

// Distance at which the ray along `direction` meets the plane that a neighbouring ray, along
// `near`, met at distance `d`; d itself where the plane is almost edge-on to either.
fn distance_along(direction: vec3f, near: vec3f, d: f32, normal: vec3f) -> f32 {
    let at_near = -dot(normal, near);
    let at_direction = -dot(normal, direction);
    if at_near < 2.0 * at_direction && at_direction < 2.0 * at_near {
        return d * (at_near / at_direction);
    }
    return d;
}

// The surface that captured texel `near` (column, row, face) of `size`² lies on, along a direction.
fn surface_along(size: u32, near: vec3u, direction: vec3f, place: u32) -> Surface {
    if place == PLACE_NONE {
        return Surface(0.0, -direction);
    }
    let distance = textureLoad(captured, near.xy, near.z, 0).a;
    if distance <= 0.0 {
        return Surface(0.0, -direction);
    }
    var normal = -direction;
    if place == PLACE_NORMAL {
        normal = textureLoad(normals, near.xy, near.z, 0).xyz;
    }
    let along = normalize(cube_vector(near.z, texel_centre(size, near.x), texel_centre(size, near.y)));
    return Surface(1.0 / max(distance_along(direction, along, distance, normal), NEAREST_M), normal);
}
