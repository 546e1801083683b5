// Twins of math.rs, function by function.

struct TowardsPhoton {
    // Unit direction I from x, zero where x is the photon's own place.
    i: vec3f,
    r2: f32,
}

fn towards_photon(position: vec3f, x: vec3f) -> TowardsPhoton {
    let r = position - x;
    let r2 = dot(r, r);
    if r2 > 1.17549435e-38 {
        return TowardsPhoton(r * (1.0 / sqrt(r2)), r2);
    }
    return TowardsPhoton(vec3f(0.0), r2);
}

// A'; eq 12.
fn area_across(measure: f32, b: f32) -> f32 {
    return measure * b * b;
}

// A = A'/cos α; eq 13.
fn lit_area(across: f32, cos_light: f32) -> f32 {
    return across / max(cos_light, 1e-6);
}

// Eq 15.
fn omega_far(across: f32, diagonal2: f32) -> f32 {
    return across / max(diagonal2, 1.17549435e-38);
}

// Eq 14.
fn omega_published(area: f32, r2: f32, cos_surface: f32) -> f32 {
    return max(cos_surface, 0.0) * area / max(area + r2, 1.17549435e-38);
}

// The disc formula.
fn omega_corrected(area: f32, r2: f32, cos_surface: f32) -> f32 {
    let seen = area * max(cos_surface, 0.0);
    return seen / max(r2 + seen * INV_PI, 1.17549435e-38);
}
