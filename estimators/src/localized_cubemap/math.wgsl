// Twins of math.rs, function by function.

// P1 §2: Δω* from Δω' and (r/d)².
fn omega_published(omega: f32, r2: f32) -> f32 {
    let disc = omega * INV_PI;
    return omega / (r2 * (1.0 - disc) + disc);
}

// P1, corrected: the disc's solid angle from x.
fn omega_corrected(area: f32, r2: f32, cos_surface: f32) -> f32 {
    let seen = area * max(cos_surface, 0.0);
    return seen / max(r2 + seen * INV_PI, 1.17549435e-38);
}

// P1 §2: k_d and k_s factor of the published reflectivity.
fn reflectivity_published(n_i: f32, n_v: f32, n_h: f32, shininess: f32) -> Reflectivity {
    if n_i > 0.0 && n_v > 0.0 {
        return Reflectivity(n_i, lobe_power(n_h, shininess));
    }
    return Reflectivity(0.0, 0.0);
}

struct TablePlace {
    first: f32,
    second: f32,
}

// P1 §3: place of (cos θ, Δω) in a table of average reflectivity.
fn table_place(cos_theta: f32, omega: f32) -> TablePlace {
    let half = clamp((1.0 - cos_theta) * 0.5, 0.0, 1.0);
    return TablePlace(sqrt(sqrt(half)), sqrt(clamp(omega * INV_PI, 0.0, 1.0)));
}
