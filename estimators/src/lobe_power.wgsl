// cos^exponent for cos in (0, 1] and an exponent ≥ 0, 0 for cos ≤ 0. WGSL allows log2 an absolute
// error of 2⁻²¹ near 1, which a large exponent magnifies: these polynomials (Cephes logf, exp2f)
// keep a relative one, as the lanes of the CPU do.
fn lobe_power(cos_theta: f32, exponent: f32) -> f32 {
    if cos_theta <= 0.0 {
        return 0.0;
    }
    // Bits of √½: the mantissa comes to lie in [√½, √2).
    let bits = bitcast<u32>(cos_theta);
    let binary_exponent = bitcast<i32>(bits - 0x3f3504f3u) >> 23u;
    let z = bitcast<f32>(bits - (bitcast<u32>(binary_exponent) << 23u)) - 1.0;
    var p = 7.0376836e-2;
    p = p * z - 1.151461e-1;
    p = p * z + 1.1676999e-1;
    p = p * z - 1.2420141e-1;
    p = p * z + 1.4249323e-1;
    p = p * z - 1.6668058e-1;
    p = p * z + 2.0000715e-1;
    p = p * z - 2.4999994e-1;
    p = p * z + 3.3333331e-1;
    let log2_cos = (z + (z * z * z * p - 0.5 * z * z)) * 1.4426950408889634 + f32(binary_exponent);
    let y = clamp(exponent * log2_cos, -126.0, 126.0);
    let whole = round(y);
    let f = y - whole;
    var q = 1.5353362e-4;
    q = q * f + 1.3398874e-3;
    q = q * f + 9.618437e-3;
    q = q * f + 5.5503326e-2;
    q = q * f + 2.4022647e-1;
    q = q * f + 6.931472e-1;
    q = q * f + 1.0;
    return q * bitcast<f32>(bitcast<u32>(i32(whole) + 127) << 23u);
}
