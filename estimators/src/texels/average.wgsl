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
const LEAST_COS: f32 = 0.25;

@group(0) @binding(0) var<uniform> average: Average;
@group(0) @binding(1) var<storage, read_write> texels: array<Texel>;
// rgb radiance, a distance (0: no surface).
@group(0) @binding(2) var captured: texture_2d_array<f32>;
@group(0) @binding(3) var normals: texture_2d_array<f32>;
// Solid angles of the captured texels of a face.
@group(0) @binding(4) var<storage, read> omegas_sr: array<f32>;
// Extents of the averaged texels of a face.
@group(0) @binding(5) var<storage, read> extents: array<f32>;

// rgb and weight.
var<workgroup> sums: array<vec4f, GROUP>;
// Sum and count over the texels with a surface: of distances, or of reciprocal depths.
var<workgroup> distances: array<vec2f, GROUP>;
var<workgroup> bent: array<vec3f, GROUP>;

fn vector_to(size: u32, texel: vec3u) -> vec3f {
    return cube_vector(texel.z, texel_centre(size, texel.x), texel_centre(size, texel.y));
}

// Sums the captured texels of one averaged texel into sums[0], distances[0] and, for a plane, bent[0].
fn sum_covered(texel: vec3u, lane: u32, weighted: bool, plane: bool) {
    let step = average.size / average.m;
    let count = step * step;
    var sum = vec4f(0.0);
    var met = vec2f(0.0);
    var normal = vec3f(0.0);
    for (var k = lane; k < count; k += GROUP) {
        let at = texel.xy * step + vec2u(k % step, k / step);
        let value = textureLoad(captured, at, texel.z, 0);
        var weight = 1.0;
        if weighted {
            weight = omegas_sr[at.y * average.size + at.x];
        }
        sum += vec4f(value.rgb, 1.0) * weight;
        if value.a > 0.0 {
            if plane {
                let ray = vector_to(average.size, vec3u(at, texel.z));
                let l = length(ray);
                met += vec2f(l / max(value.a, NEAREST_M), 1.0);
                let n = textureLoad(normals, at, texel.z, 0).xyz;
                normal += n * (weight / max(-dot(n, ray) / l, LEAST_COS));
            } else {
                met += vec2f(value.a, 1.0);
            }
        }
    }
    sums[lane] = sum;
    distances[lane] = met;
    bent[lane] = normal;
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if lane < half {
            sums[lane] += sums[lane + half];
            distances[lane] += distances[lane + half];
            bent[lane] += bent[lane + half];
        }
        workgroupBarrier();
    }
}

// A texel that is mostly open has no place: it stays at infinity.
fn has_place() -> bool {
    let step = average.size / average.m;
    return average.place != PLACE_NONE && distances[0].y > 0.0 && 2.0 * distances[0].y >= f32(step * step);
}

@compute @workgroup_size(64)
fn average_plain(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, false, false);
    if lane != 0u {
        return;
    }
    var inverse_distance = 0.0;
    if has_place() {
        inverse_distance = 1.0 / max(distances[0].x / distances[0].y, NEAREST_M);
    }
    let extent = extents[texel.y * average.m + texel.x];
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(normalize(vector_to(average.m, texel)), inverse_distance, sums[0].rgb / sums[0].w, extent, vec3f(0.0), 0.0);
}

@compute @workgroup_size(64)
fn average_middle(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, true, false);
    if lane != 0u {
        return;
    }
    let direction = normalize(vector_to(average.m, texel));
    // Of four captured texels around the middle, the one of the smallest column and row.
    let step = average.size / average.m;
    let middle = vec3u(texel.xy * step + vec2u((step - 1u) / 2u), texel.z);
    let surface = surface_along(average.size, middle, direction, average.place);
    let extent = extents[texel.y * average.m + texel.x];
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(direction, surface.inverse_distance, sums[0].rgb / sums[0].w, extent, vec3f(0.0), 0.0);
}

@compute @workgroup_size(64)
fn average_mean_plane(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, true, true);
    if lane != 0u {
        return;
    }
    let ray = vector_to(average.m, texel);
    let direction = normalize(ray);
    var inverse_distance = 0.0;
    var normal = -direction;
    if has_place() {
        inverse_distance = distances[0].x / distances[0].y / length(ray);
        if average.place == PLACE_NORMAL && dot(bent[0], bent[0]) > 0.0 {
            normal = normalize(bent[0]);
        }
    }
    let extent = extents[texel.y * average.m + texel.x] / max(-dot(normal, direction), EDGE_ON);
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(direction, inverse_distance, sums[0].rgb / sums[0].w, extent, normal, 0.0);
}
