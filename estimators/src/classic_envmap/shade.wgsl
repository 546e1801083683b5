// Every point looks up the convolved maps: irradiance first, then one map a lobe.

struct Shade {
    cells: u32,
    lobes: u32,
    pad: vec2u,
    // Phong exponents of the lobes, ascending.
    exponents: array<vec4f, 2>,
}

@group(0) @binding(3) var<uniform> shade: Shade;

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, map_lookup(shade.cells, 0u, point_vector(point, NORMAL)));
    }
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let n = point_vector(point, NORMAL);
    let reflected = mirrored(n, point_vector(point, VIEW));
    let exponent = phong_exponent(point_value(point, SHININESS));
    var lobe = 0u;
    while lobe + 1u < shade.lobes && shade.exponents[lobe / 4u][lobe % 4u] < exponent {
        lobe++;
    }
    let diffuse = map_lookup(shade.cells, 0u, n) * INV_PI;
    // Without lobes nothing shines, and any map will do.
    let specular = map_lookup(shade.cells, min(1u + lobe, shade.lobes), reflected);
    write_estimate(point, point_vector(point, DIFFUSE) * diffuse + point_vector(point, SPECULAR) * specular);
}
