// Cube captures: radiance, distance and normal along the rays through texel centres.
// Needs the parts MATH, CUBE, LAT_LONG, LIGHTS, RASTER, SHADOW_MAPS and SHADOW_TEST, MATERIAL, and
// coarse.wgsl.

struct Capture {
    // Reference point in metres.
    origin: vec3f,
    // Texels along the edge of a face.
    size: f32,
    // Nearest distance along a face's axis that is seen.
    near: f32,
    environment_scale: f32,
    // Cosine and sine of the environment's rotation about +y.
    environment_turn: vec2f,
}

@group(0) @binding(0) var<uniform> capture: Capture;
@group(0) @binding(1) var<storage, read> materials: array<Material>;
@group(0) @binding(2) var<uniform> lights: Lights;
@group(0) @binding(3) var shadow_maps: texture_2d_array<f32>;
@group(0) @binding(4) var environment: texture_2d<f32>;

struct SurfaceView {
    @builtin(position) position: vec4f,
    // Vertex from the reference point.
    @location(0) offset: vec3f,
    @location(1) @interpolate(flat) vertex: vec3f,
    @location(2) @interpolate(flat) normal: vec3f,
    @location(3) @interpolate(flat) material: u32,
    @location(4) @interpolate(flat) face: u32,
}

// Where a fragment lies on its triangle.
struct Place {
    // Weights of the triangle's corners 1 and 2.
    @location(5) weights: vec2f,
    @location(6) @interpolate(flat) triangle: u32,
}

// A SurfaceView and a Place.
struct PlacedView {
    @builtin(position) position: vec4f,
    @location(0) offset: vec3f,
    @location(1) @interpolate(flat) vertex: vec3f,
    @location(2) @interpolate(flat) normal: vec3f,
    @location(3) @interpolate(flat) material: u32,
    @location(4) @interpolate(flat) face: u32,
    @location(5) weights: vec2f,
    @location(6) @interpolate(flat) triangle: u32,
}

struct SkyView {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) face: u32,
}

struct Texel {
    // Radiance, and the distance: 0 where there is no surface.
    @location(0) radiance_distance: vec4f,
    // Unit normal on the side of the reference point.
    @location(1) normal: vec4f,
}

struct Surface {
    // Unit direction from the reference point.
    direction: vec3f,
    distance: f32,
    // Unit normal on the side of the reference point.
    normal: vec3f,
    // Whether the reference point is on the front side.
    front: bool,
}

@vertex
fn vs_surface(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) material: u32,
    @builtin(instance_index) face: u32,
) -> SurfaceView {
    let offset = position - capture.origin;
    let clip = clip_on_face(face, offset, capture.near);
    return SurfaceView(clip, offset, offset, normal, material, face);
}

@vertex
fn vs_placed(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) material: u32,
    @builtin(instance_index) face: u32,
    @builtin(vertex_index) index: u32,
) -> PlacedView {
    let offset = position - capture.origin;
    let clip = clip_on_face(face, offset, capture.near);
    let corner = index % 3u;
    let weights = vec2f(f32(corner == 1u), f32(corner == 2u));
    return PlacedView(clip, offset, offset, normal, material, face, weights, index / 3u);
}

fn texel_direction(face: u32, position: vec2f) -> vec3f {
    let st = face_coordinates(position, capture.size);
    return normalize(cube_vector(face, st.x, st.y));
}

fn surface_at(view: SurfaceView) -> Surface {
    let direction = texel_direction(view.face, view.position.xy);
    let distance = plane_distance(direction, view.vertex, view.normal, length(view.offset));
    let front = dot(view.normal, direction) < 0.0;
    return Surface(direction, distance, select(-view.normal, view.normal, front), front);
}

fn emitted(surface: Surface, material: u32) -> vec3f {
    return select(vec3f(0.0), materials[material].emission, surface.front);
}

fn texel(surface: Surface, radiance: vec3f) -> Texel {
    return Texel(vec4f(radiance, surface.distance), vec4f(surface.normal, 0.0));
}

// Distance and normal, without radiance.
@fragment
fn fs_shape(view: SurfaceView) -> Texel {
    return texel(surface_at(view), vec3f(0.0));
}

// Emission only, for scenes without lights.
@fragment
fn fs_emitted(view: SurfaceView) -> Texel {
    let surface = surface_at(view);
    return texel(surface, emitted(surface, view.material));
}

// Emission and reflected direct light.
@fragment
fn fs_lit(view: SurfaceView) -> Texel {
    let surface = surface_at(view);
    return reflecting(surface, view.material, direct_irradiance(surface));
}

// Emission and the reflected coarse solution, for scenes without lights.
@fragment
fn fs_emitted_coarse(view: SurfaceView, place: Place) -> Texel {
    let surface = surface_at(view);
    let coarse = coarse_at(place.triangle, place.weights, surface.front);
    return reflecting(surface, view.material, coarse);
}

// Emission, reflected direct light and the reflected coarse solution.
@fragment
fn fs_lit_coarse(view: SurfaceView, place: Place) -> Texel {
    let surface = surface_at(view);
    let coarse = coarse_at(place.triangle, place.weights, surface.front);
    return reflecting(surface, view.material, direct_irradiance(surface) + coarse);
}

fn reflecting(surface: Surface, material: u32, irradiance: vec3f) -> Texel {
    let reflected = materials[material].albedo * INV_PI * irradiance;
    return texel(surface, emitted(surface, material) + reflected);
}

// Irradiance straight from the lights.
fn direct_irradiance(surface: Surface) -> vec3f {
    let x = capture.origin + surface.distance * surface.direction;
    var irradiance = vec3f(0.0);
    for (var i = 0u; i < lights.count; i += 1u) {
        let light = lights.lights[i];
        let arriving = incident(light, x);
        let cos_theta = dot(surface.normal, arriving.to_light);
        if cos_theta > 0.0 && any(arriving.irradiance > vec3f(0.0)) && reached(light, x, surface.normal) {
            irradiance += arriving.irradiance * cos_theta;
        }
    }
    return irradiance;
}

// A triangle that covers the face at infinity: drawn last, it fills the texels without a surface.
@vertex
fn vs_sky(@builtin(vertex_index) index: u32, @builtin(instance_index) face: u32) -> SkyView {
    let corner = vec2f(f32(index & 1u), f32(index >> 1u));
    return SkyView(vec4f(4.0 * corner - 1.0, 0.0, 1.0), face);
}

@fragment
fn fs_sky(view: SkyView) -> Texel {
    let d = texel_direction(view.face, view.position.xy);
    let turn = capture.environment_turn;
    let unturned = vec3f(turn.x * d.x - turn.y * d.z, d.y, turn.y * d.x + turn.x * d.z);
    let radiance = sample_lat_long(environment, unturned) * capture.environment_scale;
    return Texel(vec4f(radiance, 0.0), vec4f(0.0));
}
