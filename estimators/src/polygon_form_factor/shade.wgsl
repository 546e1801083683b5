// Every point gathers from all quadrilaterals, row by row over each face: an edge is integrated once
// for both texels beside it.

override corrected: bool = false;
// Quadrilaterals that face away count negative.
override facing_signed: bool = false;

// Corners along the edge of a face, at most.
const MAX_SIDE: u32 = 65u;

struct Shade {
    // Reference point o.
    origin: vec3f,
    m: u32,
    // For each face the ends of the edge whose angle the published form factor reuses.
    reused: array<vec4u, 6>,
}

@group(0) @binding(3) var<uniform> shade: Shade;
// Direction and w = 1/d of each corner.
@group(0) @binding(4) var<storage, read> corners: array<vec4f>;
@group(0) @binding(5) var<storage, read> radiances: array<vec4f>;

struct Point {
    x: vec3f,
    // |x|.
    reach: f32,
    n: vec3f,
}

// A corner from the point, and its height above the horizon.
fn seen(face: u32, i: u32, j: u32, point: Point) -> vec4f {
    let side = shade.m + 1u;
    let corner = corners[(face * side + j) * side + i];
    let r = corner.xyz - point.x * corner.w;
    return vec4f(r, corner_height(r, point.n, corner.w, point.reach));
}

// Value of an edge, which changes its sign with the order of its ends. Corrected, it is read only
// where both ends are above the horizon.
fn edge(a: vec4f, b: vec4f, n: vec3f) -> f32 {
    if !corrected {
        return edge_cosine(a.xyz, b.xyz, n);
    }
    if a.w > 0.0 && b.w > 0.0 {
        return edge_integral(a.xyz, b.xyz, n);
    }
    return 0.0;
}

// Irradiance from a texel of radiance 1; `contour` is the sum over its edges.
fn quad(face: u32, r: array<vec3f, 4>, h: vec4f, contour: f32, n: vec3f) -> f32 {
    var r_at = r;
    if !corrected {
        let reused = shade.reused[face];
        return max(0.5 * edge_angle(r_at[reused.x], r_at[reused.y]) * contour, 0.0);
    }
    let lowest = min(min(h.x, h.y), min(h.z, h.w));
    let highest = max(max(h.x, h.y), max(h.z, h.w));
    var irradiance = 0.0;
    if lowest > 0.0 {
        irradiance = 0.5 * contour;
    } else if highest > 0.0 {
        irradiance = clipped_quad(r, h, n);
    }
    return select(max(irradiance, 0.0), irradiance, facing_signed);
}

@compute @workgroup_size(64)
fn irradiance(@builtin(workgroup_id) group: vec3u, @builtin(num_workgroups) groups: vec3u, @builtin(local_invocation_index) lane: u32) {
    let point = point_index(group, groups, lane);
    if !has_surface(point) {
        return;
    }
    let x = point_vector(point, POSITION) - shade.origin;
    let n = point_vector(point, NORMAL);
    let at = Point(x, length(x), n);
    let m = shade.m;
    var tops: array<f32, MAX_SIDE>;
    var sum = vec3f(0.0);
    for (var face = 0u; face < 6u; face++) {
        for (var i = 0u; i < m; i++) {
            tops[i] = edge(seen(face, i, 0u, at), seen(face, i + 1u, 0u, at), n);
        }
        for (var j = 0u; j < m; j++) {
            var above = seen(face, 0u, j, at);
            var below = seen(face, 0u, j + 1u, at);
            var left = edge(above, below, n);
            for (var i = 0u; i < m; i++) {
                let above_right = seen(face, i + 1u, j, at);
                let below_right = seen(face, i + 1u, j + 1u, at);
                let right = edge(above_right, below_right, n);
                let bottom = edge(below, below_right, n);
                let contour = left + bottom - right - tops[i];
                let r = array<vec3f, 4>(above.xyz, below.xyz, below_right.xyz, above_right.xyz);
                let heights = vec4f(above.w, below.w, below_right.w, above_right.w);
                sum += radiances[(face * m + j) * m + i].rgb * quad(face, r, heights, contour, n);
                tops[i] = bottom;
                above = above_right;
                below = below_right;
                left = right;
            }
        }
    }
    if corrected {
        sum = max(sum, vec3f(0.0));
    }
    write_estimate(point, sum);
}
