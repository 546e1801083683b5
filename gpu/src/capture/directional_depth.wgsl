// Depth maps along directions, and points that are tested against them. Depth alone is written.
// Needs the parts POINTS and DIRECTIONAL.

@group(0) @binding(3) var<uniform> directions: Frames;
// Depth that a point is drawn before its place.
@group(0) @binding(4) var<uniform> margin: f32;

fn clip_along(layer: u32, position: vec3f) -> vec4f {
    let p = project_along(directions.frames[layer], directions.centre, directions.radius, position);
    return vec4f(p.x, -p.y, p.z, 1.0);
}

@vertex
fn vs_depth(
    @location(0) position: vec3f,
    @builtin(instance_index) layer: u32,
) -> @invariant @builtin(position) vec4f {
    return clip_along(layer, position);
}

@vertex
fn vs_point(
    @builtin(vertex_index) index: u32,
    @builtin(instance_index) layer: u32,
) -> @invariant @builtin(position) vec4f {
    // Nothing lies beside the sphere: points out there are tested against its empty border.
    let clip = clip_along(layer, point_vector(index, POSITION));
    let inside = clamp(clip.xy, vec2f(-0.9999), vec2f(0.9999));
    return vec4f(inside, max(clip.z - margin, 0.0), 1.0);
}
