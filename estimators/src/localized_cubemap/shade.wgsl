// Every point sums over all texels.

struct Shade {
    // Reference point o.
    origin: vec3f,
    // Number of texels.
    count: u32,
}

@group(0) @binding(3) var<uniform> shade: Shade;

struct Seen {
    i: vec3f,
    omega: f32,
}

fn seen_published(texel: Texel, x: vec3f) -> Seen {
    let towards = towards_texel(texel.direction, texel.inverse_distance, x);
    return Seen(towards.i, omega_published(texel.extent, towards.r2));
}

fn seen_corrected(texel: Texel, x: vec3f) -> Seen {
    let towards = towards_texel(texel.direction, texel.inverse_distance, x);
    return Seen(towards.i, omega_corrected(texel.extent, towards.r2, -dot(towards.i, texel.normal)));
}

@compute @workgroup_size(64)
fn irradiance_published(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - shade.origin;
    let n = point_vector(point, NORMAL);
    var sum = vec3f(0.0);
    for (var k = 0u; k < shade.count; k++) {
        let seen = seen_published(texels[k], x);
        sum += texels[k].radiance * (seen.omega * max(dot(n, seen.i), 0.0));
    }
    write_estimate(point, sum);
}

@compute @workgroup_size(64)
fn irradiance_corrected(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - shade.origin;
    let n = point_vector(point, NORMAL);
    var sum = vec3f(0.0);
    for (var k = 0u; k < shade.count; k++) {
        let seen = seen_corrected(texels[k], x);
        sum += texels[k].radiance * (seen.omega * max(dot(n, seen.i), 0.0));
    }
    write_estimate(point, sum);
}

fn reflected(point: u32, diffuse: vec3f, specular: vec3f) -> vec3f {
    return point_vector(point, DIFFUSE) * diffuse + point_vector(point, SPECULAR) * specular;
}

@compute @workgroup_size(64)
fn glossy_published(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - shade.origin;
    let n = point_vector(point, NORMAL);
    let v = point_vector(point, VIEW);
    let shininess = point_value(point, SHININESS);
    var diffuse = vec3f(0.0);
    var specular = vec3f(0.0);
    for (var k = 0u; k < shade.count; k++) {
        let seen = seen_published(texels[k], x);
        let a = reflectivity_published(dot(n, seen.i), dot(n, v), cos_half(n, seen.i, v), shininess);
        diffuse += texels[k].radiance * (a.diffuse * seen.omega);
        specular += texels[k].radiance * (a.specular * seen.omega);
    }
    write_estimate(point, reflected(point, diffuse, specular));
}

@compute @workgroup_size(64)
fn glossy_corrected(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - shade.origin;
    let n = point_vector(point, NORMAL);
    let v = point_vector(point, VIEW);
    let shininess = point_value(point, SHININESS);
    let normalisation = lobe_normalisation(shininess);
    var diffuse = vec3f(0.0);
    var specular = vec3f(0.0);
    for (var k = 0u; k < shade.count; k++) {
        let seen = seen_corrected(texels[k], x);
        let a = reflectivity_corrected(dot(n, seen.i), cos_half(n, seen.i, v), shininess, normalisation);
        diffuse += texels[k].radiance * (a.diffuse * seen.omega);
        specular += texels[k].radiance * (a.specular * seen.omega);
    }
    write_estimate(point, reflected(point, diffuse, specular));
}
