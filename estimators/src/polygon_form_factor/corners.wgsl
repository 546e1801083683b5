// The corners and radiances of the quadrilaterals, one invocation each.

struct Build {
    // M, and texels along the captured cube's edge.
    m: u32,
    size: u32,
    // Which channels of place the capture has.
    place: u32,
    // 1: corners have the surface along their own rays.
    exact: u32,
    // 1: a texel's radiance is the mean of its corners'.
    mean_radiance: u32,
    pad: u32,
}

// In a list of texels: none.
const NONE: u32 = 0xffffffffu;

@group(0) @binding(0) var<uniform> build: Build;
@group(0) @binding(1) var<storage, read> texels: array<Texel>;
@group(0) @binding(2) var captured: texture_2d_array<f32>;
@group(0) @binding(3) var normals: texture_2d_array<f32>;
// The texels that meet at each corner.
@group(0) @binding(4) var<storage, read> meeting: array<vec4u>;
// The captured texel beside each corner.
@group(0) @binding(5) var<storage, read> beside: array<u32>;
// Directions of the corners.
@group(0) @binding(6) var<storage, read> directions: array<vec4f>;
// Direction and w = 1/d of each corner.
@group(0) @binding(7) var<storage, read_write> corners: array<vec4f>;
@group(0) @binding(8) var<storage, read_write> radiances: array<vec4f>;

// 1 over the mean distance of the texels that meet at a corner; 0 if most lie at infinity.
fn mean_inverse_distance(corner: u32) -> f32 {
    var sum = 0.0;
    var met = 0u;
    var count = 0u;
    for (var k = 0u; k < 4u; k++) {
        let texel = meeting[corner][k];
        if texel != NONE {
            count++;
            let w = texels[texel].inverse_distance;
            if w > 0.0 {
                sum += 1.0 / w;
                met++;
            }
        }
    }
    if met > 0u && 2u * met >= count {
        return f32(met) / sum;
    }
    return 0.0;
}

@compute @workgroup_size(64)
fn build_corners(@builtin(global_invocation_id) id: vec3u) {
    let side = build.m + 1u;
    if id.x >= CUBE_FACES * side * side {
        return;
    }
    let direction = directions[id.x].xyz;
    var w = 0.0;
    if build.exact != 0u {
        let near = beside[id.x];
        let size = build.size;
        let at = vec3u(near % size, near / size % size, near / (size * size));
        w = surface_along(size, at, direction, build.place).inverse_distance;
    } else {
        w = mean_inverse_distance(id.x);
    }
    corners[id.x] = vec4f(direction, w);
}

// Mean radiance of the texels that meet at a corner.
fn radiance_at(corner: u32) -> vec3f {
    var sum = vec4f(0.0);
    for (var k = 0u; k < 4u; k++) {
        let texel = meeting[corner][k];
        if texel != NONE {
            sum += vec4f(texels[texel].radiance, 1.0);
        }
    }
    return sum.rgb / sum.w;
}

@compute @workgroup_size(64)
fn build_radiances(@builtin(global_invocation_id) id: vec3u) {
    let m = build.m;
    if id.x >= CUBE_FACES * m * m {
        return;
    }
    var radiance = texels[id.x].radiance;
    if build.mean_radiance != 0u {
        let side = m + 1u;
        let first = (id.x / (m * m) * side + id.x / m % m) * side + id.x % m;
        let top = radiance_at(first) + radiance_at(first + 1u);
        let bottom = radiance_at(first + side) + radiance_at(first + side + 1u);
        radiance = (top + bottom) * 0.25;
    }
    radiances[id.x] = vec4f(radiance, 0.0);
}
