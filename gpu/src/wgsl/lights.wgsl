// Lights, and what arrives from them before any shadow: `interreflect_scene::Light::incident`.
// Needs the part MATH.

const LIGHT_POINT: u32 = 0u;
const LIGHT_CONE: u32 = 1u;
const LIGHT_SQUARE: u32 = 2u;
const LIGHT_DIRECTIONAL: u32 = 3u;
const LIGHT_AREA: u32 = 4u;

struct Light {
    // Position in metres; of directional light the centre of the scene.
    position: vec3f,
    kind: u32,
    // Unit direction into which it shines: a spot's axis, an area light's normal.
    axis: vec3f,
    // Cone: cosine of half the opening angle; square: its tangent; directional: radius of the scene.
    limit: f32,
    // Unit vector orthogonal to the axis.
    up: vec3f,
    // First layer of its shadow maps: six for a position, one for a direction.
    first_layer: u32,
    // Intensity in W/sr, directional: irradiance in W/m², area: Φ/π.
    power: vec3f,
}

struct Incident {
    // Unit direction from the point to the light.
    to_light: vec3f,
    // Irradiance in W/m² on a surface that faces the light; 0 where the light does not shine.
    irradiance: vec3f,
}

fn incident(light: Light, x: vec3f) -> Incident {
    if light.kind == LIGHT_DIRECTIONAL {
        return Incident(-light.axis, light.power);
    }
    let d = light.position - x;
    let r2 = dot(d, d);
    if r2 == 0.0 {
        return Incident(-light.axis, vec3f(0.0));
    }
    let to_light = d / sqrt(r2);
    return Incident(to_light, light.power * emitted_share(light, -to_light) / r2);
}

// Factor on the power in a unit direction away from the light.
fn emitted_share(light: Light, away: vec3f) -> f32 {
    let along = dot(away, light.axis);
    switch light.kind {
        case LIGHT_CONE: {
            return select(0.0, 1.0, along >= light.limit);
        }
        case LIGHT_SQUARE: {
            let across = abs(vec2f(dot(away, cross(light.axis, light.up)), dot(away, light.up)));
            return select(0.0, 1.0, along > 0.0 && max(across.x, across.y) <= along * light.limit);
        }
        case LIGHT_AREA: {
            return max(along, 0.0);
        }
        default: {
            return 1.0;
        }
    }
}
