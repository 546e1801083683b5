struct TexelFacts {
    vector: vec3f,
    // Of a multiple of the vector: face, (s, t), column and row.
    face: f32,
    st: vec2f,
    texel: vec2f,
}

override factor: f32 = 1.0;

@group(0) @binding(0) var<storage, read_write> facts: array<TexelFacts>;
@group(0) @binding(1) var<storage, read_write> values: array<f32>;
@group(0) @binding(2) var<storage, read_write> counters: array<u32>;
@group(0) @binding(3) var<uniform> step: vec4u;

@compute @workgroup_size(1)
fn texels(@builtin(workgroup_id) texel: vec3u, @builtin(num_workgroups) counts: vec3u) {
    let size = counts.x;
    let s = texel_centre(size, texel.x);
    let t = texel_centre(size, texel.y);
    let vector = cube_vector(texel.z, s, t);
    let c = cube_coordinates(vector * 3.0);
    facts[texel_index(size, texel.z, texel.x, texel.y)] = TexelFacts(
        vector,
        f32(c.face),
        vec2f(c.s, c.t),
        vec2f(f32(texel_at(size, c.s)), f32(texel_at(size, c.t))),
    );
}

@compute @workgroup_size(1)
fn constant() {
    values[0] = 2.0 * factor;
}

@compute @workgroup_size(1)
fn append() {
    counters[0] = 10u * counters[0] + step.x;
}
