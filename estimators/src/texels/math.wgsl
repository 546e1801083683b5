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

// As in math.rs: 2⁻⁴⁴.
const COINCIDENT: f32 = 5.684341886080802e-14;

fn towards_texel(direction: vec3f, w: f32, x: vec3f) -> TowardsTexel {
    let r = direction - x * w;
    let r2 = dot(r, r);
    if r2 > COINCIDENT {
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

// P1, corrected: normalised, times the cosine.
fn normalised_reflectivity(n_i: f32, n_h: f32, shininess: f32, normalisation: f32) -> Reflectivity {
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
