// Photons from the views of the lights. Needs MATH, TRUE_COLORS, the power of lobes, the leaves of
// the texels and of math.wgsl, and photon.wgsl.

// What a photon's extent is: 0 by eq 11, 1 by eq 15, 2 an area.
override extent_kind: u32 = 2u;
// Lit surfaces reflect by their whole material.
override shining: bool = false;
// Normals were captured.
override normals_known: bool = true;

struct Gather {
    // Number of samples.
    samples: u32,
    // N: samples along the edge of a view.
    per_side: u32,
    // w: texels along the edge of a view.
    size: u32,
    // |diag|² of the scene's bounding box in m².
    diagonal2: f32,
}

// A place in the views, as `Sample` in samples.rs.
struct Sample {
    texel: u32,
    measure: f32,
    parallel: u32,
    share_sr: f32,
}

@group(0) @binding(0) var<uniform> gather: Gather;
@group(0) @binding(1) var<storage, read> samples: array<Sample>;
@group(0) @binding(2) var<storage, read> positions: array<vec4f>;
@group(0) @binding(3) var<storage, read> radiances: array<vec4f>;
@group(0) @binding(4) var<storage, read> normals: array<vec4f>;
@group(0) @binding(5) var<storage, read> true_colors: array<TrueColors>;
@group(0) @binding(6) var<storage, read_write> photons: array<Photon>;
@group(0) @binding(7) var<storage, read_write> highlights: array<Highlight>;

// What a texel reflects by Lambert's law, and k_s·E.
struct Reflected {
    diffuse: vec3f,
    specular: vec3f,
}

fn reflected(texel: u32) -> Reflected {
    if shining {
        let colors = true_colors[texel];
        let diffuse = colors.diffuse * INV_PI * colors.irradiance;
        return Reflected(diffuse, colors.specular * colors.irradiance);
    }
    return Reflected(radiances[texel].rgb, vec3f(0.0));
}

fn extent(place: Sample) -> f32 {
    if extent_kind == 0u {
        return place.share_sr;
    }
    let across = area_across(place.measure, select(positions[place.texel].w, 1.0, place.parallel == 1u));
    if extent_kind == 1u {
        return omega_far(across, gather.diagonal2);
    }
    return lit_area(across, normals[place.texel].w);
}

fn write_photon(index: u32, place: Sample, light: Reflected) {
    var normal = vec3f(0.0);
    if normals_known {
        normal = normals[place.texel].xyz;
    }
    var shininess = 0.0;
    if shining {
        let colors = true_colors[place.texel];
        shininess = colors.shininess;
        highlights[index] = Highlight(light.specular * lobe_normalisation(shininess), 0.0, colors.to_light, 0.0);
    }
    let position = positions[place.texel].xyz;
    photons[index] = Photon(position, extent(place), light.diffuse, 0.0, normal, shininess);
}

// One sample an invocation: what the texel at the middle of its cell shows.
@compute @workgroup_size(64)
fn gather_middles(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= gather.samples {
        return;
    }
    let place = samples[id.x];
    if positions[place.texel].w > 0.0 {
        write_photon(id.x, place, reflected(place.texel));
    }
}

var<workgroup> lane_diffuse: array<vec3f, 64>;
var<workgroup> lane_specular: array<vec3f, 64>;

// Part of a cell, along a row or column, that a texel covers; n texels' units, `size` a cell's.
fn part(cell: u32, texel: u32) -> f32 {
    let n = gather.per_side;
    let low = max(cell * gather.size, texel * n);
    let high = min((cell + 1u) * gather.size, (texel + 1u) * n);
    return f32(high - low) / f32(gather.size);
}

// One sample a workgroup: the mean over its cell, each lane a share of the texels.
@compute @workgroup_size(64)
fn gather_means(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let n = gather.per_side;
    let cell = vec2u(group.x % n, group.x / n);
    let first = cell * gather.size / n;
    let count = ((cell + 1u) * gather.size + n - 1u) / n - first;
    let view = group.y * gather.size * gather.size;
    var sum = Reflected(vec3f(0.0), vec3f(0.0));
    for (var k = lane; k < count.x * count.y; k += 64u) {
        let texel = first + vec2u(k % count.x, k / count.x);
        let weight = part(cell.x, texel.x) * part(cell.y, texel.y);
        let here = reflected(view + texel.y * gather.size + texel.x);
        sum.diffuse += here.diffuse * weight;
        sum.specular += here.specular * weight;
    }
    lane_diffuse[lane] = sum.diffuse;
    lane_specular[lane] = sum.specular;
    for (var width = 32u; width > 0u; width /= 2u) {
        workgroupBarrier();
        if lane < width {
            lane_diffuse[lane] += lane_diffuse[lane + width];
            lane_specular[lane] += lane_specular[lane + width];
        }
    }
    let index = group.y * n * n + group.x;
    let place = samples[index];
    if lane == 0u && positions[place.texel].w > 0.0 {
        write_photon(index, place, Reflected(lane_diffuse[0], lane_specular[0]));
    }
}
