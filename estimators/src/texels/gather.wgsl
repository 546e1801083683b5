// Every point sums over all texels. The method's own part says what a texel counts:
//   texel_omega(extent, r2, cos_surface): its solid angle in sr from the point;
//   texel_cosine(n_i, omega): the cosine at the point over that solid angle;
//   texel_reflectivity(lobe, n_i, n_v, n_h, omega): diffuse and specular factor;
//   texel_lobe(shininess): what that needs of the point's lobe.

struct Gather {
    // Reference point o.
    origin: vec3f,
    // Number of texels.
    count: u32,
}

@group(0) @binding(3) var<uniform> gather: Gather;

struct Seen {
    i: vec3f,
    omega: f32,
}

fn seen(k: u32, x: vec3f) -> Seen {
    let towards = towards_texel(texels[k].direction, texels[k].inverse_distance, x);
    let cos_surface = -dot(towards.i, texels[k].normal);
    return Seen(towards.i, texel_omega(texels[k].extent, towards.r2, cos_surface));
}

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - gather.origin;
    let n = point_vector(point, NORMAL);
    var sum = vec3f(0.0);
    for (var k = 0u; k < gather.count; k++) {
        let seen = seen(k, x);
        sum += texels[k].radiance * (seen.omega * texel_cosine(dot(n, seen.i), seen.omega));
    }
    write_estimate(point, sum);
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - gather.origin;
    let n = point_vector(point, NORMAL);
    let v = point_vector(point, VIEW);
    let lobe = texel_lobe(point_value(point, SHININESS));
    var diffuse = vec3f(0.0);
    var specular = vec3f(0.0);
    for (var k = 0u; k < gather.count; k++) {
        let seen = seen(k, x);
        let a = texel_reflectivity(lobe, dot(n, seen.i), dot(n, v), cos_half(n, seen.i, v), seen.omega);
        diffuse += texels[k].radiance * (a.diffuse * seen.omega);
        specular += texels[k].radiance * (a.specular * seen.omega);
    }
    write_estimate(point, point_vector(point, DIFFUSE) * diffuse + point_vector(point, SPECULAR) * specular);
}
