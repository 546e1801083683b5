// Orthographic views along directions: `interreflect_scene::DirectionalFrame`.

const DEPTH_MAPS_AT_ONCE: u32 = 32u;

struct Frame {
    // Unit vector towards growing columns.
    right: vec3f,
    // Unit vector towards shrinking rows.
    up: vec3f,
    // Unit vector to where the view looks from.
    towards: vec3f,
}

struct Frames {
    // Sphere that is in view.
    centre: vec3f,
    radius: f32,
    frames: array<Frame, DEPTH_MAPS_AT_ONCE>,
}

// Column coordinate s, row coordinate t (both in [−1, 1]) and depth (0 nearest, 1 farthest).
fn project_along(frame: Frame, centre: vec3f, radius: f32, position: vec3f) -> vec3f {
    let offset = (position - centre) / radius;
    return vec3f(
        dot(offset, frame.right),
        -dot(offset, frame.up),
        clamp(0.5 - 0.5 * dot(offset, frame.towards), 0.0, 1.0),
    );
}
