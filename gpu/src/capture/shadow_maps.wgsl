// The geometry of shadow maps, for those who write and those who read them.
// Needs the parts CUBE and LIGHTS.

// Texels along the edge of a shadow map.
const SHADOW_SIZE: u32 = 1024u;
const MAX_LIGHTS: u32 = 16u;

struct Lights {
    lights: array<Light, MAX_LIGHTS>,
    count: u32,
    // Nearest distance along a face's axis that shadow maps see.
    near: f32,
}

struct ShadowRay {
    // From the shadow origin.
    start: vec3f,
    // Unit vector.
    direction: vec3f,
}

// Where distances begin: at the light, or for directional light at a plane before the scene.
fn shadow_origin(light: Light) -> vec3f {
    let before = select(0.0, light.limit, light.kind == LIGHT_DIRECTIONAL);
    return light.position - before * light.axis;
}

// The ray through (s, t) of a layer; `face` counts for lights with a position only.
fn shadow_ray(light: Light, face: u32, st: vec2f) -> ShadowRay {
    if light.kind == LIGHT_DIRECTIONAL {
        let right = cross(light.axis, light.up);
        return ShadowRay(light.limit * (st.x * right - st.y * light.up), light.axis);
    }
    return ShadowRay(vec3f(0.0), normalize(cube_vector(face, st.x, st.y)));
}
