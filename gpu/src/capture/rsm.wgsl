// Views from the lights: the first surface that each ray meets, and through mirrors what they show.
// Needs the parts MATH, CUBE, LIGHTS, RASTER, SHADOW_MAPS, MATERIAL and
// TRUE_COLORS.

const MAX_MIRRORS: u32 = 8u;

// Bits of `Views::channels`.
const RADIANCE: u32 = 1u;
const NORMAL: u32 = 2u;
const TRUE_COLORS: u32 = 4u;

// A square of texels through which rays leave a light.
struct Frame {
    origin: vec3f,
    light: u32,
    axis: vec3f,
    // Tangent of half the full angle; of parallel rays half the width in metres.
    half_extent: f32,
    right: vec3f,
    // 1 where rays are parallel.
    orthographic: u32,
    down: vec3f,
    // Nearest distance along the axis that is seen.
    near: f32,
}

struct Views {
    // Texels along the edge of a view.
    size: u32,
    channels: u32,
    // Number of triangles, receivers' too.
    triangles: u32,
    // Nearest distance at which a ray meets anything.
    ray_start: f32,
    // Pixels of `seen` along the edge of a texel: odd, so that one lies in the middle.
    pixels: u32,
}

@group(0) @binding(0) var<uniform> views: Views;
@group(0) @binding(1) var<storage, read> frames: array<Frame>;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var<storage, read> materials: array<Material>;
// Triangle + 1, or 0, and the bits of the distance to it near the ray.
@group(0) @binding(4) var seen: texture_2d_array<u32>;
// Seven numbers a corner: position, the triangle's normal, and the bits of the material.
@group(0) @binding(5) var<storage, read> vertices: array<f32>;
// Unit normals at the triangles' corners, by which mirrors reflect.
@group(0) @binding(6) var<storage, read> corner_normals: array<vec4f>;
// Position, and the length of the way; 0 without a photon.
@group(0) @binding(7) var<storage, read_write> positions: array<vec4f>;
@group(0) @binding(8) var<storage, read_write> radiances: array<vec4f>;
// Normal, and the cosine of the arriving light.
@group(0) @binding(9) var<storage, read_write> normals: array<vec4f>;
@group(0) @binding(10) var<storage, read_write> true_colors: array<TrueColors>;

struct Ray {
    start: vec3f,
    direction: vec3f,
}

fn frame_ray(frame: Frame, st: vec2f) -> Ray {
    let across = frame.half_extent * (st.x * frame.right + st.y * frame.down);
    if frame.orthographic == 1u {
        return Ray(frame.origin + across, frame.axis);
    }
    return Ray(frame.origin, normalize(frame.axis + across));
}

struct FrameView {
    @builtin(position) position: vec4f,
    // Vertex from the frame's origin.
    @location(0) offset: vec3f,
    @location(1) @interpolate(flat) frame: u32,
    @location(2) @interpolate(flat) triangle: u32,
}

@vertex
fn vs_view(
    @location(0) position: vec3f,
    @builtin(instance_index) instance: u32,
    @builtin(vertex_index) index: u32,
) -> FrameView {
    let frame = frames[instance];
    let offset = position - frame.origin;
    let across = vec2f(dot(offset, frame.right), -dot(offset, frame.down)) / frame.half_extent;
    let along = dot(offset, frame.axis);
    var clip = vec4f(across, frame.near, along);
    if frame.orthographic == 1u {
        clip = vec4f(across, 1.0 - along / (2.0 * frame.half_extent), 1.0);
    }
    return FrameView(clip, offset, instance, index / 3u);
}

@fragment
fn fs_view(view: FrameView) -> @location(0) vec2u {
    let frame = frames[view.frame];
    let nearby = select(length(view.offset), dot(view.offset, frame.axis), frame.orthographic == 1u);
    return vec2u(view.triangle + 1u, bitcast<u32>(nearby));
}

fn corner(triangle: u32, k: u32) -> vec3f {
    let first = 7u * (3u * triangle + k);
    return vec3f(vertices[first], vertices[first + 1u], vertices[first + 2u]);
}

fn triangle_normal(triangle: u32) -> vec3f {
    let first = 21u * triangle + 3u;
    return vec3f(vertices[first], vertices[first + 1u], vertices[first + 2u]);
}

fn triangle_material(triangle: u32) -> u32 {
    return bitcast<u32>(vertices[21u * triangle + 6u]);
}

fn view_index(column: u32, row: u32, frame: u32) -> u32 {
    return (frame * views.size + row) * views.size + column;
}

fn texel_ray(frame: Frame, column: u32, row: u32) -> Ray {
    let st = vec2f(texel_centre(views.size, column), texel_centre(views.size, row));
    return frame_ray(frame, st);
}

// A surface on a light's way.
struct Met {
    triangle: u32,
    position: vec3f,
    // Unit direction in which the light arrives.
    direction: vec3f,
    // Length of the whole way.
    path: f32,
    // Product of the mirrors' reflectances.
    throughput: vec3f,
}

// What a texel's ray meets first: triangle + 1, or 0, and the bits of the distance.
//
// The rasteriser moves corners by up to 1/256 of a pixel, so the pixel in the middle may show a triangle
// beside the ray, or what lies behind one. Of the triangles that it and the pixels around it show, the nearest
// that the ray meets counts; where it meets none, what the middle shows.
fn first_seen(ray: Ray, column: u32, row: u32, view: u32) -> vec2u {
    let middle = vec2i(vec2u(column, row) * views.pixels + views.pixels / 2u);
    let last = i32(views.size * views.pixels) - 1;
    var found = textureLoad(seen, middle, view, 0).xy;
    var nearest = FAR;
    var before = 0u;
    for (var k = 0; k < 9; k++) {
        let pixel = clamp(middle + vec2i(k % 3 - 1, k / 3 - 1), vec2i(0), vec2i(last));
        let triangle = textureLoad(seen, pixel, view, 0).x;
        if triangle == 0u || triangle == before {
            continue;
        }
        before = triangle;
        let distance = triangle_distance(triangle - 1u, ray);
        if distance < nearest {
            nearest = distance;
            found = vec2u(triangle, bitcast<u32>(distance));
        }
    }
    return found;
}

fn first_met(ray: Ray, seen_here: vec2u) -> Met {
    let triangle = seen_here.x - 1u;
    let vertex = corner(triangle, 0u) - ray.start;
    let nearby = bitcast<f32>(seen_here.y);
    let distance = plane_distance(ray.direction, vertex, triangle_normal(triangle), nearby);
    let position = ray.start + distance * ray.direction;
    return Met(triangle, position, ray.direction, distance, vec3f(1.0));
}

// A photon where the light of a frame, which left it in the direction `leaving`, met a surface.
fn write_photon(index: u32, frame: Frame, leaving: vec3f, at: Met) {
    let light = lights.lights[frame.light];
    var arriving = light.power;
    if frame.orthographic == 0u {
        arriving *= emitted_share(light, leaving) / (at.path * at.path);
    }
    let along = dot(triangle_normal(at.triangle), at.direction);
    let cos_light = abs(along);
    if cos_light == 0.0 || all(arriving == vec3f(0.0)) {
        return;
    }
    let irradiance = arriving * at.throughput * cos_light;
    let material = materials[triangle_material(at.triangle)];
    positions[index] = vec4f(at.position, at.path);
    if (views.channels & RADIANCE) != 0u {
        radiances[index] = vec4f(material.albedo * INV_PI * irradiance, 0.0);
    }
    if (views.channels & NORMAL) != 0u {
        normals[index] = vec4f(-sign(along) * triangle_normal(at.triangle), cos_light);
    }
    if (views.channels & TRUE_COLORS) != 0u {
        let shininess = material.shininess;
        let specular = material.specular;
        true_colors[index] = TrueColors(material.albedo, shininess, specular, irradiance, -at.direction);
    }
}

// One texel an invocation: what the rays meet first, mirrors left out.
@compute @workgroup_size(64)
fn resolve(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= views.size * views.size {
        return;
    }
    let column = id.x % views.size;
    let row = id.x / views.size;
    let frame = frames[id.y];
    let ray = texel_ray(frame, column, row);
    let seen_here = first_seen(ray, column, row, id.y);
    if seen_here.x == 0u {
        return;
    }
    let met = first_met(ray, seen_here);
    if materials[triangle_material(met.triangle)].mirror == 0u {
        write_photon(view_index(column, row, id.y), frame, ray.direction, met);
    }
}

// The nearest triangle of each lane, then in [0] of all.
var<workgroup> lane_distances: array<f32, 64>;
var<workgroup> lane_triangles: array<u32, 64>;

const NOTHING: u32 = 0xffffffffu;
const FAR: f32 = 3.4e38;

// Distance along a ray to a triangle, or FAR. The edges belong to it, to some roundings.
fn triangle_distance(triangle: u32, ray: Ray) -> f32 {
    let a = corner(triangle, 0u);
    let ab = corner(triangle, 1u) - a;
    let ac = corner(triangle, 2u) - a;
    let p = cross(ray.direction, ac);
    let volume = dot(ab, p);
    if volume == 0.0 {
        return FAR;
    }
    let from_a = ray.start - a;
    let q = cross(from_a, ab);
    let u = dot(from_a, p) / volume;
    let v = dot(ray.direction, q) / volume;
    let distance = dot(ac, q) / volume;
    let inside = min(min(u, v), 1.0 - u - v) >= -1e-6;
    return select(FAR, distance, inside && distance > views.ray_start);
}

// Direction in which a mirror sends light on, by the normal between its corners'.
fn mirrored(at: Met) -> vec3f {
    let a = corner(at.triangle, 0u);
    let ab = corner(at.triangle, 1u) - a;
    let ac = corner(at.triangle, 2u) - a;
    let n = cross(ab, ac);
    let from_a = at.position - a;
    let area2 = dot(n, n);
    let v = dot(cross(from_a, ac), n) / area2;
    let w = dot(cross(ab, from_a), n) / area2;
    let first = 3u * at.triangle;
    let sum = (1.0 - v - w) * corner_normals[first].xyz + v * corner_normals[first + 1u].xyz
        + w * corner_normals[first + 2u].xyz;
    let normal = normalize(sum);
    return normalize(at.direction - 2.0 * dot(at.direction, normal) * normal);
}

// One texel a workgroup: the light's way through mirrors, each lane a share of the triangles.
@compute @workgroup_size(64)
fn follow(@builtin(workgroup_id) texel: vec3u, @builtin(local_invocation_index) lane: u32) {
    let frame = frames[texel.z];
    let ray = texel_ray(frame, texel.x, texel.y);
    let seen_here = first_seen(ray, texel.x, texel.y, texel.z);
    if seen_here.x == 0u {
        return;
    }
    var met = first_met(ray, seen_here);
    if materials[triangle_material(met.triangle)].mirror == 0u {
        return;
    }
    for (var mirrors = 0u; mirrors < MAX_MIRRORS; mirrors++) {
        let mirror = met.triangle;
        met.throughput *= materials[triangle_material(mirror)].specular;
        met.direction = mirrored(met);
        let onwards = Ray(met.position, met.direction);
        var distance = FAR;
        var nearest = NOTHING;
        for (var i = lane; i < views.triangles; i += 64u) {
            let to_triangle = triangle_distance(i, onwards);
            if to_triangle < distance && i != mirror {
                distance = to_triangle;
                nearest = i;
            }
        }
        lane_distances[lane] = distance;
        lane_triangles[lane] = nearest;
        for (var width = 32u; width > 0u; width /= 2u) {
            workgroupBarrier();
            if lane < width && lane_distances[lane + width] < lane_distances[lane] {
                lane_distances[lane] = lane_distances[lane + width];
                lane_triangles[lane] = lane_triangles[lane + width];
            }
        }
        let found = workgroupUniformLoad(&lane_triangles[0]);
        if found == NOTHING {
            return;
        }
        let step = workgroupUniformLoad(&lane_distances[0]);
        met.triangle = found;
        met.path += step;
        met.position += step * met.direction;
        if materials[triangle_material(found)].mirror == 0u {
            if lane == 0u {
                write_photon(view_index(texel.x, texel.y, texel.z), frame, ray.direction, met);
            }
            return;
        }
    }
}
