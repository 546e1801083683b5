// Points and estimates in blocks of LANES lanes of f32 planes. A shader that includes this part
// finds the points in slots 0 and 1 and the estimate in slot 2; its own bindings start at 3.

const LANES: u32 = 64u;
const POSITION: u32 = 0u;
const NORMAL: u32 = 3u;
const MASK: u32 = 6u;
const VIEW: u32 = 7u;
const DIFFUSE: u32 = 10u;
const SPECULAR: u32 = 13u;
const SHININESS: u32 = 16u;
const FOOTPRINT: u32 = 17u;
const ESTIMATE_PLANES: u32 = 3u;

struct PointsInfo {
    // Number of points.
    count: u32,
    // Planes in a block.
    planes: u32,
}

@group(0) @binding(0) var<storage, read> points: array<f32>;
@group(0) @binding(1) var<uniform> points_info: PointsInfo;
@group(0) @binding(2) var<storage, read_write> estimate: array<f32>;

// Index of the point of an invocation: workgroups of LANES lanes, laid out in rows of workgroups.
fn point_index(workgroup: vec3u, workgroups: vec3u, lane: u32) -> u32 {
    return (workgroup.y * workgroups.x + workgroup.x) * LANES + lane;
}

// Value of a plane at a point.
fn point_value(index: u32, plane: u32) -> f32 {
    return points[((index / LANES) * points_info.planes + plane) * LANES + index % LANES];
}

// Value of three planes from `plane` on at a point.
fn point_vector(index: u32, plane: u32) -> vec3f {
    return vec3f(
        point_value(index, plane),
        point_value(index, plane + 1u),
        point_value(index, plane + 2u),
    );
}

// Whether the index is that of a point with a surface.
fn has_surface(index: u32) -> bool {
    if index >= points_info.count {
        return false;
    }
    return point_value(index, MASK) != 0.0;
}

// Writes the estimate of a point.
fn write_estimate(index: u32, value: vec3f) {
    if index >= points_info.count {
        return;
    }
    let base = (index / LANES) * ESTIMATE_PLANES * LANES + index % LANES;
    estimate[base] = value.x;
    estimate[base + LANES] = value.y;
    estimate[base + 2u * LANES] = value.z;
}

// The estimate of a point, as it is so far.
fn read_estimate(index: u32) -> vec3f {
    let base = (index / LANES) * ESTIMATE_PLANES * LANES + index % LANES;
    return vec3f(estimate[base], estimate[base + LANES], estimate[base + 2u * LANES]);
}
