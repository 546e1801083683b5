// Every point evaluates the harmonics and looks the pyramid up.

struct Shade {
    // Texels along a face's edge of the pyramid's base, and its coarsest level.
    base: u32,
    top: u32,
    lod: f32,
    // 1: lod is a bias on the footprint's level.
    bias: u32,
    f_lambda: f32,
}

@group(0) @binding(3) var<uniform> shade: Shade;
@group(0) @binding(4) var<storage, read> coefficients: array<vec4f>;
@group(0) @binding(5) var<storage, read> pyramid: array<vec4f>;

// E(n) = Σ Â_i·L_i·Y_i(n).
fn irradiance_along(n: vec3f) -> vec3f {
    var y = harmonics(n);
    var sum = vec3f(0.0);
    for (var i = 0u; i < HARMONICS; i++) {
        sum += coefficients[i].rgb * y[i];
    }
    return sum;
}

// Bilinear radiance of a level.
fn bilinear(level: u32, direction: vec3f) -> vec3f {
    let size = shade.base >> level;
    let taps = mip_taps(size, direction);
    let first = level_offset(shade.base, size) + taps.first;
    let below = first + taps.side;
    return pyramid[first].rgb * ((1.0 - taps.u) * (1.0 - taps.v))
        + pyramid[first + 1u].rgb * (taps.u * (1.0 - taps.v))
        + pyramid[below].rgb * ((1.0 - taps.u) * taps.v)
        + pyramid[below + 1u].rgb * (taps.u * taps.v);
}

// Trilinear radiance at a level in [0, top].
fn trilinear(level: f32, direction: vec3f) -> vec3f {
    let fine = min(u32(level), shade.top);
    let fraction = level - f32(fine);
    let value = bilinear(fine, direction);
    if fraction <= 0.0 || fine == shade.top {
        return value;
    }
    return value * (1.0 - fraction) + bilinear(fine + 1u, direction) * fraction;
}

fn level_at(point: u32) -> f32 {
    if shade.bias != 0u {
        return biased_level(point_value(point, FOOTPRINT), f32(shade.base), shade.lod, f32(shade.top));
    }
    return clamp(shade.lod, 0.0, f32(shade.top));
}

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        write_estimate(point, irradiance_along(point_vector(point, NORMAL)));
    }
}

// Reflected radiance with this radiance in the mirrored direction.
fn reflected(point: u32, n: vec3f, v: vec3f, radiance: vec3f) -> vec3f {
    let fresnel = schlick(shade.f_lambda, dot(n, v));
    return fresnel_mix(fresnel, point_vector(point, DIFFUSE), irradiance_along(n), point_vector(point, SPECULAR), radiance);
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if has_surface(point) {
        let n = point_vector(point, NORMAL);
        let v = point_vector(point, VIEW);
        write_estimate(point, reflected(point, n, v, trilinear(level_at(point), mirrored(n, v))));
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
