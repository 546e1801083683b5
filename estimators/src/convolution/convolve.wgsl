// The convolved maps, one invocation a node: E(n) = Σ L·∫(n·ω)⁺dω or the Phong-filtered radiance.

struct Convolve {
    // Nodes of a map, and texels to sum over.
    nodes: u32,
    sources: u32,
    // First node to write.
    first: u32,
    exponent: f32,
}

@group(0) @binding(0) var<uniform> convolve: Convolve;
// Vector solid angles and radiances of the texels at infinity.
@group(0) @binding(1) var<storage, read> vectors: array<vec4f>;
@group(0) @binding(2) var<storage, read> radiances: array<vec4f>;
@group(0) @binding(3) var<storage, read> directions: array<vec4f>;
@group(0) @binding(4) var<storage, read_write> maps: array<vec4f>;

@compute @workgroup_size(64)
fn convolve_cosine(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= convolve.nodes {
        return;
    }
    let n = directions[id.x].xyz;
    var sum = vec3f(0.0);
    for (var k = 0u; k < convolve.sources; k++) {
        sum += radiances[k].rgb * cosine_weight(n, vectors[k].xyz);
    }
    maps[convolve.first + id.x] = vec4f(sum, 0.0);
}

@compute @workgroup_size(64)
fn convolve_phong(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= convolve.nodes {
        return;
    }
    let r = directions[id.x].xyz;
    var cos_max = 0.0;
    for (var k = 0u; k < convolve.sources; k++) {
        let vector = vectors[k].xyz;
        cos_max = max(cos_max, dot(r, vector) / length(vector));
    }
    var sum = vec4f(0.0);
    for (var k = 0u; k < convolve.sources; k++) {
        let vector = vectors[k].xyz;
        let omega_sr = length(vector);
        let cos_theta = dot(r, vector) / omega_sr;
        let weight = omega_sr * phong_weight(cos_theta, cos_max, convolve.exponent);
        sum += vec4f(radiances[k].rgb, 1.0) * weight;
    }
    maps[convolve.first + id.x] = vec4f(sum.rgb / sum.w, 0.0);
}
