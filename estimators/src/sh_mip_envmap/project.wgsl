// Coefficients of the irradiance, one workgroup a harmonic, summed in a tree.

const GROUP: u32 = 64u;

@group(0) @binding(0) var<storage, read> radiances: array<vec4f>;
// Weights of the texels: harmonic by harmonic, band factors included.
@group(0) @binding(1) var<storage, read> weights: array<f32>;
@group(0) @binding(2) var<storage, read_write> coefficients: array<vec4f>;

var<workgroup> sums: array<vec3f, GROUP>;

@compute @workgroup_size(64)
fn project(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) lane: u32) {
    let texels = arrayLength(&radiances);
    var sum = vec3f(0.0);
    for (var k = lane; k < texels; k += GROUP) {
        sum += radiances[k].rgb * weights[group.x * texels + k];
    }
    sums[lane] = sum;
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if lane < half {
            sums[lane] += sums[lane + half];
        }
        workgroupBarrier();
    }
    if lane == 0u {
        coefficients[group.x] = vec4f(sums[0], 0.0);
    }
}
