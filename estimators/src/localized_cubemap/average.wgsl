// Captured cubes averaged down to texels: one workgroup a texel, summed in a tree.

struct Average {
    // M, and texels along the captured cube's edge.
    m: u32,
    size: u32,
    // 1: Δω' of the shader, not of the text.
    shader_omega: u32,
    // 1: there are distances, and where corrected looks for them normals.
    located: u32,
}

const GROUP: u32 = 64u;
const NEAREST_M: f32 = 1e-30;
const EDGE_ON: f32 = 1e-6;

@group(0) @binding(0) var<uniform> average: Average;
@group(0) @binding(1) var<storage, read_write> texels: array<Texel>;
// rgb radiance, a distance (0: no surface).
@group(0) @binding(2) var captured: texture_2d_array<f32>;
// Solid angles of the captured texels of a face.
@group(0) @binding(3) var<storage, read> omegas_sr: array<f32>;
// Solid angles of the averaged texels of a face.
@group(0) @binding(4) var<storage, read> texel_omegas_sr: array<f32>;
@group(0) @binding(5) var normals: texture_2d_array<f32>;

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

fn texel_vector(texel: vec3u) -> vec3f {
    return cube_vector(texel.z, texel_centre(average.m, texel.x), texel_centre(average.m, texel.y));
}

@compute @workgroup_size(64)
fn average_published(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, false);
    if lane != 0u {
        return;
    }
    let vector = texel_vector(texel);
    let m = f32(average.m);
    let l = length(vector);
    var inverse_distance = 0.0;
    // A texel that is mostly open has no place: it stays at infinity.
    if average.located != 0u && distances[0].y > 0.0 && 2.0 * distances[0].y >= sums[0].w {
        inverse_distance = 1.0 / max(distances[0].x / distances[0].y, NEAREST_M);
    }
    var omega = texel_omega_text(m, l);
    if average.shader_omega != 0u {
        omega = texel_omega_shader(m, l);
    }
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(vector / l, inverse_distance, sums[0].rgb / sums[0].w, omega, vec3f(0.0), 0.0);
}

// Distance at which the ray along `direction` meets the plane that a neighbouring ray, along
// `near`, met at distance `d`; d itself where the plane is almost edge-on to either.
fn distance_along(direction: vec3f, near: vec3f, d: f32, normal: vec3f) -> f32 {
    let at_near = -dot(normal, near);
    let at_direction = -dot(normal, direction);
    if at_near < 2.0 * at_direction && at_direction < 2.0 * at_near {
        return d * (at_near / at_direction);
    }
    return d;
}

@compute @workgroup_size(64)
fn average_corrected(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    sum_covered(texel, lane, true);
    if lane != 0u {
        return;
    }
    let direction = normalize(texel_vector(texel));
    var inverse_distance = 0.0;
    var normal = -direction;
    if average.located != 0u {
        // Of four captured texels around the middle, the one of the smallest column and row.
        let step = average.size / average.m;
        let near = texel.xy * step + vec2u((step - 1u) / 2u);
        let distance = textureLoad(captured, near, texel.z, 0).a;
        if distance > 0.0 {
            normal = textureLoad(normals, near, texel.z, 0).xyz;
            let along = normalize(cube_vector(texel.z, texel_centre(average.size, near.x), texel_centre(average.size, near.y)));
            inverse_distance = 1.0 / max(distance_along(direction, along, distance, normal), NEAREST_M);
        }
    }
    let omega = texel_omegas_sr[texel.y * average.m + texel.x];
    let area = disc_area(omega, max(-dot(normal, direction), EDGE_ON));
    texels[texel_index(average.m, texel.z, texel.x, texel.y)] =
        Texel(direction, inverse_distance, sums[0].rgb / sums[0].w, area, normal, 0.0);
}
