struct TexelFacts {
    // Vector and solid angle.
    vector: vec4f,
    // Face, s and t of a multiple of the vector.
    coordinates: vec4f,
    // Column and row found again.
    found: vec4f,
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
        vec4f(vector, texel_solid_angle_sr(size, texel.x, texel.y)),
        vec4f(f32(c.face), c.s, c.t, 0.0),
        vec4f(f32(texel_at(size, c.s)), f32(texel_at(size, c.t)), 0.0, 0.0),
    );
}

@compute @workgroup_size(1)
fn normalisation(@builtin(workgroup_id) index: vec3u) {
    values[index.x] = blinn_phong_normalisation(values[index.x]);
}

@compute @workgroup_size(1)
fn constant() {
    values[0] = 2.0 * factor;
}

@compute @workgroup_size(1)
fn append() {
    counters[0] = 10u * counters[0] + step.x;
}

// Work that takes a time proportional to counters[0].
@compute @workgroup_size(1)
fn spin() {
    var x = counters[1];
    for (var i = 0u; i < counters[0]; i += 1u) {
        x = x * 1664525u + 1013904223u;
    }
    counters[2] = x;
}
