// Every point looks up the convolved maps: irradiance first, then one map a lobe.

struct Shade {
    cells: u32,
    lobes: u32,
    pad: vec2u,
    // Phong exponents of the lobes, ascending.
    exponents: array<vec4f, 2>,
}

@group(0) @binding(3) var<uniform> shade: Shade;
@group(0) @binding(4) var<storage, read> maps: array<vec4f>;

// Bilinear value of map `index` in a direction.
fn lookup(index: u32, direction: vec3f) -> vec3f {
    let taps = map_taps(shade.cells, direction);
    let base = index * map_nodes(shade.cells) + taps.base;
    return maps[base].rgb * ((1.0 - taps.u) * (1.0 - taps.v))
        + maps[base + 1u].rgb * (taps.u * (1.0 - taps.v))
        + maps[base + taps.side].rgb * ((1.0 - taps.u) * taps.v)
        + maps[base + taps.side + 1u].rgb * (taps.u * taps.v);
}

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, lookup(0u, point_vector(point, NORMAL)));
    }
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let n = point_vector(point, NORMAL);
    let v = point_vector(point, VIEW);
    let reflected = n * (2.0 * dot(n, v)) - v;
    let exponent = phong_exponent(point_value(point, SHININESS));
    var lobe = 0u;
    while lobe + 1u < shade.lobes && shade.exponents[lobe / 4u][lobe % 4u] < exponent {
        lobe++;
    }
    let diffuse = lookup(0u, n) * INV_PI;
    let specular = lookup(1u + lobe, reflected);
    write_estimate(point, point_vector(point, DIFFUSE) * diffuse + point_vector(point, SPECULAR) * specular);
}
