// Twins of math.rs, function by function.

// A·c/r², at most `largest`.
fn point_omega(area: f32, r2: f32, cos_surface: f32, largest: f32) -> f32 {
    let seen = area * max(cos_surface, 0.0);
    return min(seen / max(r2, 1.17549435e-38), largest);
}
