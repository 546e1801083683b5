// The angle in [0, π] whose sine and cosine are in the ratio of these, for sin ≥ 0. WGSL allows
// atan2 an error of 4096 units in the last place; this polynomial (Cephes atanf) keeps 3e-7, as the
// lanes of the CPU do.
fn angle(sin_theta: f32, cos_theta: f32) -> f32 {
    let along = abs(cos_theta);
    let steep = sin_theta > along;
    let low = min(sin_theta, along);
    let high = max(sin_theta, along);
    // tan(π/8): above, atan(t) = π/4 + atan((t − 1)/(t + 1)).
    let reduced = low > 0.41421357 * high;
    let numerator = select(low, low - high, reduced);
    let denominator = select(high, low + high, reduced);
    let t = select(0.0, numerator / denominator, denominator > 0.0);
    let z = t * t;
    var p = 8.0537445e-2;
    p = p * z - 1.3877686e-1;
    p = p * z + 1.9977711e-1;
    p = p * z - 3.333295e-1;
    var a = p * z * t + t;
    a = select(a, 0.7853981633974483 + a, reduced);
    a = select(a, 1.5707963267948966 - a, steep);
    return select(a, 3.141592653589793 - a, cos_theta < 0.0);
}
