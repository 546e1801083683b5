// Blends the means by the normal.

@group(0) @binding(3) var<storage, read> means: array<vec4f, 2>;

@compute @workgroup_size(64)
fn shade(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        let up = point_value(point, NORMAL + 1u);
        write_estimate(point, blended_irradiance(means[0].rgb, means[1].rgb, up));
    }
}
