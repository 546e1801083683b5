// Every point receives the same.

@group(0) @binding(3) var<storage, read> mean: vec4f;

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, ambient_irradiance(mean.rgb));
    }
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, ambient_reflection(point_vector(point, DIFFUSE), point_vector(point, SPECULAR), mean.rgb));
    }
}
