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
    // Tangent of half the view's full angle; 0 where rays are parallel.
    half: f32,
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

// b in m, or 1 where rays are parallel.
fn way(texel: u32, half: f32) -> f32 {
    return select(1.0, positions[texel].w, half > 0.0);
}

fn extent(place: Sample) -> f32 {
    if extent_kind == 0u {
        return place.share_sr;
    }
    let across = area_across(place.measure, way(place.texel, place.half));
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

// The texels of the cell that a workgroup's sample stands for.
struct CellTexels {
    cell: vec2u,
    // The first column and row, and how many of both.
    first: vec2u,
    count: vec2u,
    // Index of the view's first texel, and of the sample.
    view: u32,
    index: u32,
}

fn cell_texels(group: vec3u) -> CellTexels {
    let n = gather.per_side;
    let cell = vec2u(group.x % n, group.x / n);
    let first = cell * gather.size / n;
    let count = ((cell + 1u) * gather.size + n - 1u) / n - first;
    return CellTexels(cell, first, count, group.y * gather.size * gather.size, group.y * n * n + group.x);
}

// Column and row of a cell's texel.
fn texel_of(texels: CellTexels, k: u32) -> vec2u {
    return texels.first + vec2u(k % texels.count.x, k / texels.count.x);
}

// Part of a cell that a texel covers.
fn covered(texels: CellTexels, texel: vec2u) -> f32 {
    return part(texels.cell.x, texel.x) * part(texels.cell.y, texel.y);
}

// One sample a workgroup: the mean over its cell, each lane a share of the texels.
@compute @workgroup_size(64)
fn gather_means(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let texels = cell_texels(group);
    var sum = Reflected(vec3f(0.0), vec3f(0.0));
    for (var k = lane; k < texels.count.x * texels.count.y; k += 64u) {
        let texel = texel_of(texels, k);
        let weight = covered(texels, texel);
        let here = reflected(texels.view + texel.y * gather.size + texel.x);
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
    let place = samples[texels.index];
    if lane == 0u && positions[place.texel].w > 0.0 {
        write_photon(texels.index, place, Reflected(lane_diffuse[0], lane_specular[0]));
    }
}

// Sums over the texels of a cell that show a photon: as `Cell` in samples.rs.
struct Cell {
    diffuse: vec3f,
    total: f32,
    specular: vec3f,
    lit: f32,
    position: vec3f,
    area: f32,
    normal: vec3f,
    shininess: f32,
    to_light: vec3f,
}

var<workgroup> cells: array<Cell, 64>;

// Solid angle of a texel over that of one in the middle of the view: 1 where rays are parallel.
fn density(half: f32, texel: vec2u) -> f32 {
    let at = half * (2.0 * (vec2f(texel) + 0.5) / f32(gather.size) - 1.0);
    let l2 = 1.0 + dot(at, at);
    return 1.0 / (l2 * sqrt(l2));
}

fn add_texel(sum: ptr<function, Cell>, texel: u32, rays: f32, half: f32) {
    let across = area_across(rays, way(texel, half));
    let cos_light = normals[texel].w;
    let area = lit_area(across, cos_light);
    let here = reflected(texel);
    (*sum).lit += rays;
    (*sum).area += lit_area(across, max(cos_light, 1.0 / f32(gather.per_side)));
    (*sum).diffuse += here.diffuse * area;
    (*sum).specular += here.specular * area;
    (*sum).position += positions[texel].xyz * rays;
    (*sum).normal += normals[texel].xyz * rays;
    if shining {
        (*sum).to_light += true_colors[texel].to_light * rays;
        (*sum).shininess += true_colors[texel].shininess * rays;
    }
}

fn both(a: Cell, b: Cell) -> Cell {
    return Cell(
        a.diffuse + b.diffuse, a.total + b.total, a.specular + b.specular, a.lit + b.lit,
        a.position + b.position, a.area + b.area, a.normal + b.normal, a.shininess + b.shininess,
        a.to_light + b.to_light,
    );
}

fn unit(v: vec3f) -> vec3f {
    let l2 = dot(v, v);
    return select(vec3f(0.0), v * inverseSqrt(max(l2, 1e-30)), l2 > 1e-30);
}

// One sample a workgroup: the mean of all that its cell shows.
@compute @workgroup_size(64)
fn gather_cells(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let texels = cell_texels(group);
    let index = texels.index;
    let place = samples[index];
    var sum = Cell(vec3f(0.0), 0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0, vec3f(0.0), 0.0, vec3f(0.0));
    for (var k = lane; k < texels.count.x * texels.count.y; k += 64u) {
        let texel = texel_of(texels, k);
        let rays = covered(texels, texel) * density(place.half, texel);
        let at = texels.view + texel.y * gather.size + texel.x;
        sum.total += rays;
        if positions[at].w > 0.0 {
            add_texel(&sum, at, rays, place.half);
        }
    }
    cells[lane] = sum;
    for (var width = 32u; width > 0u; width /= 2u) {
        workgroupBarrier();
        if lane < width {
            cells[lane] = both(cells[lane], cells[lane + width]);
        }
    }
    let all = cells[0];
    if lane != 0u || all.lit <= 0.0 {
        return;
    }
    let shininess = all.shininess / all.lit;
    if shining {
        let radiance = all.specular / all.area * lobe_normalisation(shininess);
        highlights[index] = Highlight(radiance, 0.0, unit(all.to_light), 0.0);
    }
    let area = all.area * (place.measure / all.total);
    photons[index] = Photon(all.position / all.lit, area, all.diffuse / all.area, 0.0, unit(all.normal), shininess);
}
