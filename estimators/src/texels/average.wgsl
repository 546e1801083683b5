// Captured cubes averaged down to texels: one workgroup a texel, summed in a tree.

struct Average {
    // M, and texels along the captured cube's edge.
    m: u32,
    size: u32,
    // Which channels of place the capture has.
    place: u32,
    pad: u32,
}

const GROUP: u32 = 64u;
const EDGE_ON: f32 = 1e-6;

@group(0) @binding(0) var<uniform> average: Average;
@group(0) @binding(1) var<storage, read_write> texels: array<Texel>;
// rgb radiance, a distance (0: no surface).
@group(0) @binding(2) var captured: texture_2d_array<f32>;
@group(0) @binding(3) var normals: texture_2d_array<f32>;
// Solid angles of the captured texels of a face.
@group(0) @binding(4) var<storage, read> omegas_sr: array<f32>;
// Extents of the averaged texels of a face.
@group(0) @binding(5) var<storage, read> extents: array<f32>;

// rgb and weight; distance and count of texels with a surface.
var<workgroup> sums: array<vec4f, GROUP>;
var<workgroup> distances: array<vec2f, GROUP>;

// Sums the captured texels of one averaged texel into sums[0] and distances[0].
fn sum_covered(texel: vec3u, lane: u32, weighted: bool) {
    let step = average.size / average.m;
    let count = step * step;
    var sum = vec4f(0.0);
    var met = vec2f(0.0);
    for (var k = lane; k < count; k += GROUP) {
        let at = texel.xy * step + vec2u(k % step, k / step);
        let value = textureLoad(captured, at, texel.z, 0);
        var weight = 1.0;
        if weighted {
            weight = omegas_sr[at.y * average.size + at.x];
        }
        sum += vec4f(value.rgb, 1.0) * weight;
        if value.a > 0.0 {
            met += vec2f(value.a, 1.0);
        }
    }
    sums[lane] = sum;
    distances[lane] = met;
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if lane < half {
            sums[lane] += sums[lane + half];
            distances[lane] += distances[lane + half];
        }
        workgroupBarrier();
    }
}

fn texel_direction(texel: vec3u) -> vec3f {
    return normalize(cube_vector(texel.z, texel_centre(average.m, texel.x), texel_centre(average.m, texel.y)));
}

@compute @workgroup_size(64)
fn average_plain(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, false);
    if lane != 0u {
        return;
    }
    var inverse_distance = 0.0;
    // A texel that is mostly open has no place: it stays at infinity.
    if average.place != PLACE_NONE && distances[0].y > 0.0 && 2.0 * distances[0].y >= sums[0].w {
        inverse_distance = 1.0 / max(distances[0].x / distances[0].y, NEAREST_M);
    }
    let extent = extents[texel.y * average.m + texel.x];
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(texel_direction(texel), inverse_distance, sums[0].rgb / sums[0].w, extent, vec3f(0.0), 0.0);
}

@compute @workgroup_size(64)
fn average_exact(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, true);
    if lane != 0u {
        return;
    }
    let direction = texel_direction(texel);
    // Of four captured texels around the middle, the one of the smallest column and row.
    let step = average.size / average.m;
    let middle = vec3u(texel.xy * step + vec2u((step - 1u) / 2u), texel.z);
    let surface = surface_along(average.size, middle, direction, average.place);
    let extent = extents[texel.y * average.m + texel.x] / max(-dot(surface.normal, direction), EDGE_ON);
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(direction, surface.inverse_distance, sums[0].rgb / sums[0].w, extent, surface.normal, 0.0);
}
