// Every point looks up the convolved maps and mixes them by Schlick's factor.

struct Shade {
    cells: u32,
    f_lambda: f32,
}

@group(0) @binding(3) var<uniform> shade: Shade;

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, map_lookup(shade.cells, 0u, point_vector(point, NORMAL)));
    }
}

// Reflected radiance with this radiance in the mirrored direction.
fn reflected(point: u32, n: vec3f, v: vec3f, radiance: vec3f) -> vec3f {
    let fresnel = schlick(shade.f_lambda, dot(n, v));
    let irradiance = map_lookup(shade.cells, 0u, n);
    return fresnel_mix(fresnel, point_vector(point, DIFFUSE), irradiance, point_vector(point, SPECULAR), radiance);
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        let n = point_vector(point, NORMAL);
        let v = point_vector(point, VIEW);
        write_estimate(point, reflected(point, n, v, map_lookup(shade.cells, 1u, mirrored(n, v))));
    }
}

// No point has a lobe.
@compute @workgroup_size(64)
fn matte(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, reflected(point, point_vector(point, NORMAL), point_vector(point, VIEW), vec3f(0.0)));
    }
}
