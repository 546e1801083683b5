// Shadow maps: distances from each light to the first surface, at exact texel centres.
// Needs the parts MATH, CUBE, LIGHTS and RASTER.

// Layers of the instance index that a light takes: instance = light · 6 + face.
struct ShadowView {
    @builtin(position) position: vec4f,
    // Vertex from the light, or from the plane where directional light starts.
    @location(0) offset: vec3f,
    @location(1) @interpolate(flat) vertex: vec3f,
    @location(2) @interpolate(flat) normal: vec3f,
    @location(3) @interpolate(flat) instance: u32,
}

@group(0) @binding(0) var<uniform> lights: Lights;

@vertex
fn vs_shadow(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @builtin(instance_index) instance: u32,
) -> ShadowView {
    let light = lights.lights[instance / CUBE_FACES];
    let offset = position - shadow_origin(light);
    var clip: vec4f;
    if light.kind == LIGHT_DIRECTIONAL {
        let right = cross(light.axis, light.up);
        let across = vec2f(dot(offset, right), dot(offset, light.up)) / light.limit;
        clip = vec4f(across, 1.0 - dot(offset, light.axis) / (2.0 * light.limit), 1.0);
    } else {
        clip = clip_on_face(instance % CUBE_FACES, offset, lights.near);
    }
    return ShadowView(clip, offset, offset, normal, instance);
}

@fragment
fn fs_shadow(view: ShadowView) -> @location(0) vec4f {
    let light = lights.lights[view.instance / CUBE_FACES];
    let st = face_coordinates(view.position.xy, f32(SHADOW_SIZE));
    let ray = shadow_ray(light, view.instance % CUBE_FACES, st);
    let vertex = view.vertex - ray.start;
    let nearby = dot(view.offset - ray.start, ray.direction);
    return vec4f(plane_distance(ray.direction, vertex, view.normal, nearby), 0.0, 0.0, 0.0);
}
