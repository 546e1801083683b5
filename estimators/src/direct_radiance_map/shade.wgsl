// Every point sums over the photons, or over one part of them after another.

// What a photon counts: 0 its extent, 1 by eq 14, 2 by the disc formula.
override formula: u32 = 1u;
// Lit surfaces reflect by their whole material.
override shining: bool = false;

struct Shade {
    // First photon of this part, and number of photons in it.
    first: u32,
    count: u32,
    // 1 where parts before this one have been summed.
    adds: u32,
    pad: u32,
}

@group(0) @binding(3) var<uniform> shade: Shade;
@group(0) @binding(5) var<storage, read> highlights: array<Highlight>;

struct Seen {
    i: vec3f,
    omega: f32,
}

fn seen(k: u32, x: vec3f) -> Seen {
    let towards = towards_photon(photons[k].position, x);
    let cos_surface = -dot(towards.i, photons[k].normal);
    var omega = photons[k].extent;
    if formula == 1u {
        omega = omega_published(omega, towards.r2, cos_surface);
    } else if formula == 2u {
        omega = omega_corrected(omega, towards.r2, cos_surface);
    }
    return Seen(towards.i, omega);
}

// Radiance of a photon against the direction `i`.
fn radiance_against(k: u32, i: vec3f) -> vec3f {
    if !shining {
        return photons[k].radiance;
    }
    let half = cos_half(photons[k].normal, highlights[k].to_light, -i);
    return photons[k].radiance + highlights[k].radiance * lobe_power(half, photons[k].shininess);
}

fn write_sum(point: u32, value: vec3f) {
    if shade.adds == 1u {
        write_estimate(point, read_estimate(point) + value);
    } else {
        write_estimate(point, value);
    }
}

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION);
    let n = point_vector(point, NORMAL);
    var sum = vec3f(0.0);
    for (var k = shade.first; k < shade.first + shade.count; k++) {
        let seen = seen(k, x);
        sum += radiance_against(k, seen.i) * (seen.omega * max(dot(n, seen.i), 0.0));
    }
    write_sum(point, sum);
}

@compute @workgroup_size(64)
fn glossy(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION);
    let n = point_vector(point, NORMAL);
    let v = point_vector(point, VIEW);
    let shininess = point_value(point, SHININESS);
    let normalisation = lobe_normalisation(shininess);
    var diffuse = vec3f(0.0);
    var specular = vec3f(0.0);
    for (var k = shade.first; k < shade.first + shade.count; k++) {
        let seen = seen(k, x);
        let a = normalised_reflectivity(dot(n, seen.i), cos_half(n, seen.i, v), shininess, normalisation);
        let radiance = radiance_against(k, seen.i);
        diffuse += radiance * (a.diffuse * seen.omega);
        specular += radiance * (a.specular * seen.omega);
    }
    write_sum(point, point_vector(point, DIFFUSE) * diffuse + point_vector(point, SPECULAR) * specular);
}
