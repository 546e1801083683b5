// The mean radiance of the captured cube, weighted by solid angle: one workgroup, summed in a tree.

const GROUP: u32 = 256u;

@group(0) @binding(0) var captured: texture_2d_array<f32>;
// Solid angles of the texels of a face.
@group(0) @binding(1) var<storage, read> omegas_sr: array<f32>;
@group(0) @binding(2) var<storage, read_write> mean: vec4f;

var<workgroup> sums: array<vec4f, GROUP>;

@compute @workgroup_size(256)
fn mean_radiance(@builtin(local_invocation_index) lane: u32) {
    let size = textureDimensions(captured).x;
    let face_texels = size * size;
    var sum = vec4f(0.0);
    for (var k = lane; k < CUBE_FACES * face_texels; k += GROUP) {
        let on_face = k % face_texels;
        let at = vec2u(on_face % size, on_face / size);
        sum += vec4f(textureLoad(captured, at, k / face_texels, 0).rgb, 1.0) * omegas_sr[on_face];
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
        mean = vec4f(sums[0].rgb / sums[0].w, 0.0);
    }
}
