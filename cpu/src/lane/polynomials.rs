//! Elementary functions of one `f32`, without fused operations or tables: the same bits everywhere.

/// Base-2 logarithm of a positive normal number, with relative accuracy near 1, where a large
/// exponent needs it: log2 x = e + log2(1 + z), the polynomial has z as a factor. Coefficients:
/// Cephes `logf`.
#[inline(always)]
pub(super) fn log2(x: f32) -> f32 {
    // Bits of √½: the mantissa comes to lie in [√½, √2).
    let shifted = x.to_bits().wrapping_sub(0x3f35_04f3);
    let exponent = (shifted as i32) >> 23;
    let z = f32::from_bits(x.to_bits().wrapping_sub((exponent as u32) << 23)) - 1.0;
    let mut p = 7.037_684e-2_f32;
    for c in [
        -1.151_461e-1,
        1.167_699_9e-1,
        -1.242_014_1e-1,
        1.424_932_3e-1,
        -1.666_805_8e-1,
        2.000_071_5e-1,
        -2.499_999_4e-1,
        3.333_333e-1,
    ] {
        p = p * z + c;
    }
    let z2 = z * z;
    let ln = z + (z2 * z * p - 0.5 * z2);
    ln * std::f32::consts::LOG2_E + exponent as f32
}

/// 2 to the power y, y clamped to [−126, 126]. Coefficients: Cephes `exp2f`.
#[inline(always)]
pub(super) fn exp2(y: f32) -> f32 {
    let y = if y > -126.0 { y } else { -126.0 };
    let y = if y < 126.0 { y } else { 126.0 };
    // Adding 1.5·2²³ rounds to the nearest whole number and leaves it in the low bits.
    const ROUND: f32 = 12_582_912.0;
    let rounded = y + ROUND;
    let f = y - (rounded - ROUND);
    let mut p = 1.535_336_2e-4_f32;
    for c in [
        1.339_887_4e-3,
        9.618_437e-3,
        5.550_332_6e-2,
        2.402_264_7e-1,
        6.931_472e-1,
        1.0,
    ] {
        p = p * f + c;
    }
    let whole = rounded.to_bits().wrapping_sub(ROUND.to_bits());
    p * f32::from_bits(whole.wrapping_add(127) << 23)
}

/// atan2(sin, cos) for sin ≥ 0: the arc tangent of the smaller over the larger magnitude, reduced
/// about π/8. Coefficients: Cephes `atanf`.
#[inline(always)]
pub(super) fn angle(sin: f32, cos: f32) -> f32 {
    use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let along = cos.abs();
    let steep = sin > along;
    let (low, high) = if steep { (along, sin) } else { (sin, along) };
    // tan(π/8): above, atan(t) = π/4 + atan((t − 1)/(t + 1)).
    let reduced = low > 0.414_213_57 * high;
    let (numerator, denominator) = if reduced {
        (low - high, low + high)
    } else {
        (low, high)
    };
    let t = if denominator > 0.0 {
        numerator / denominator
    } else {
        0.0
    };
    let z = t * t;
    let mut p = 8.053_744_5e-2_f32;
    for c in [-1.387_768_6e-1, 1.997_771_1e-1, -3.333_295e-1] {
        p = p * z + c;
    }
    let a = p * z * t + t;
    let a = if reduced { FRAC_PI_4 + a } else { a };
    let a = if steep { FRAC_PI_2 - a } else { a };
    if cos < 0.0 { PI - a } else { a }
}
