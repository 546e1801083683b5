// Twins of math.rs, function by function. A texel's surface point relative to o is direction / w.

struct TowardsTexel {
    // Unit direction I from x, zero where x is the texel's own point.
    i: vec3f,
    // (r/d)².
    r2: f32,
}

struct Reflectivity {
    diffuse: f32,
    specular: f32,
}

// P1 §2: Δω' of the text.
fn texel_omega_text(m: f32, l: f32) -> f32 {
    return 4.0 / (m * m * l * l * l + 4.0 / PI);
}

// P1, listing: Δω' of the shader.
fn texel_omega_shader(m: f32, l: f32) -> f32 {
    return 4.0 / (m * m * l * l + 4.0 / PI);
}

// P1 §2: Δω* from Δω' and (r/d)².
fn omega_published(omega: f32, r2: f32) -> f32 {
    let disc = omega * INV_PI;
    return omega / (r2 * (1.0 - disc) + disc);
}

// P1, corrected: A/d² of the disc that subtends `omega` under `cos_reference`.
fn disc_area(omega: f32, cos_reference: f32) -> f32 {
    return omega / (cos_reference * (1.0 - omega * INV_PI));
}

// P1, corrected: the disc's solid angle from x.
fn omega_corrected(area: f32, r2: f32, cos_surface: f32) -> f32 {
    let seen = area * max(cos_surface, 0.0);
    return seen / (r2 + seen * INV_PI);
}

fn towards_texel(direction: vec3f, w: f32, x: vec3f) -> TowardsTexel {
    let r = direction - x * w;
    let r2 = dot(r, r);
    let tiny = 1.17549435e-38;
    if r2 > tiny {
        return TowardsTexel(r * (1.0 / sqrt(r2)), r2);
    }
    return TowardsTexel(vec3f(0.0), r2);
}

fn cos_half(n: vec3f, i: vec3f, v: vec3f) -> f32 {
    let h = i + v;
    let h2 = dot(h, h);
    if h2 > 1e-20 {
        return dot(n, h) * (1.0 / sqrt(h2));
    }
    return 0.0;
}

// P1 §2: k_d and k_s factor of the published reflectivity.
fn reflectivity_published(n_i: f32, n_v: f32, n_h: f32, shininess: f32) -> Reflectivity {
    if n_i > 0.0 && n_v > 0.0 {
        return Reflectivity(n_i, lobe_power(n_h, shininess));
    }
    return Reflectivity(0.0, 0.0);
}

// P1, corrected: normalised, times the cosine.
fn reflectivity_corrected(n_i: f32, n_h: f32, shininess: f32, normalisation: f32) -> Reflectivity {
    let cos_theta = max(n_i, 0.0);
    return Reflectivity(
        cos_theta * INV_PI,
        cos_theta * normalisation * lobe_power(n_h, shininess),
    );
}

fn lobe_normalisation(shininess: f32) -> f32 {
    let n = shininess;
    return (n + 2.0) * (n + 4.0) / (8.0 * PI * (lobe_power(0.5, n * 0.5) + n));
}
