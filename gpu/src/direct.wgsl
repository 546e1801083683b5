// Direct light at points. Needs MATH, POINTS, CUBE, LIGHTS, SHADOW_MAPS and SHADOW_TEST.

// Points reflect by their whole material, else by Lambert's law.
override shining: bool = false;

@group(0) @binding(3) var<uniform> lights: Lights;
@group(0) @binding(4) var shadow_maps: texture_2d_array<f32>;

// Factor that makes the lobe reflect all of a head-on beam: `blinn_phong_normalisation`.
fn normalisation(shininess: f32) -> f32 {
    return (shininess + 2.0) * (shininess + 4.0) / (8.0 * PI * (exp2(-0.5 * shininess) + shininess));
}

// f_r in 1/sr of a point's material, for light from a direction.
fn reflectance(point: u32, n: vec3f, to_light: vec3f) -> vec3f {
    let lambert = point_vector(point, DIFFUSE) * INV_PI;
    if !shining {
        return lambert;
    }
    let between = to_light + point_vector(point, VIEW);
    let cos_half = max(dot(n, between) * inverseSqrt(max(dot(between, between), 1e-30)), 0.0);
    let shininess = point_value(point, SHININESS);
    // pow(0, 0) is not defined.
    let lobe = select(pow(cos_half, shininess), 1.0, shininess == 0.0);
    return lambert + point_vector(point, SPECULAR) * (lobe * normalisation(shininess));
}

// What a light that reaches the point adds.
fn reflected_from(point: u32, x: vec3f, n: vec3f, light: Light) -> vec3f {
    let arriving = incident(light, x);
    let cos_theta = max(dot(n, arriving.to_light), 0.0);
    return arriving.irradiance * cos_theta * reflectance(point, n, arriving.to_light);
}

@compute @workgroup_size(64)
fn shadowed(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION);
    let n = point_vector(point, NORMAL);
    var radiance = vec3f(0.0);
    for (var i = 0u; i < lights.count; i++) {
        let light = lights.lights[i];
        let reflected = reflected_from(point, x, n, light);
        if any(reflected > vec3f(0.0)) && reached(light, x, n) {
            radiance += reflected;
        }
    }
    write_estimate(point, radiance);
}

@compute @workgroup_size(64)
fn unshadowed(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION);
    let n = point_vector(point, NORMAL);
    var radiance = vec3f(0.0);
    for (var i = 0u; i < lights.count; i++) {
        radiance += reflected_from(point, x, n, lights.lights[i]);
    }
    write_estimate(point, radiance);
}
