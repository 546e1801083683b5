@compute @workgroup_size(64)
fn surface(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let i = point_index(workgroup, workgroups, lane);
    if !has_surface(i) {
        write_estimate(i, vec3f(-1.0));
        return;
    }
    write_estimate(i, point_vector(i, POSITION) + 10.0 * point_vector(i, NORMAL));
}

@compute @workgroup_size(64)
fn material(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let i = point_index(workgroup, workgroups, lane);
    if !has_surface(i) {
        write_estimate(i, vec3f(-1.0));
        return;
    }
    let reflection = 10.0 * point_vector(i, DIFFUSE) + 100.0 * point_vector(i, SPECULAR);
    let lobe = 1000.0 * point_value(i, SHININESS) + 10000.0 * point_value(i, FOOTPRINT);
    write_estimate(i, point_vector(i, VIEW) + reflection + lobe);
}
