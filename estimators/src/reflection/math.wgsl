// Twins of math.rs, function by function. Needs the part MATH.

// Mirrors the direction to the viewer about the normal.
fn mirrored(n: vec3f, v: vec3f) -> vec3f {
    return n * (2.0 * dot(n, v)) - v;
}

// Schlick's Fresnel factor F = f_λ + (1 − f_λ)(1 − cos θ)⁵, cos θ clamped to [0, 1].
fn schlick(f_lambda: f32, cos_theta: f32) -> f32 {
    let away = 1.0 - clamp(cos_theta, 0.0, 1.0);
    let squared = away * away;
    return f_lambda + (1.0 - f_lambda) * (squared * squared * away);
}

// L_o = (1 − F)·k_d/π·E + F·k_s·L.
fn fresnel_mix(fresnel: f32, diffuse: vec3f, irradiance: vec3f, specular: vec3f, radiance: vec3f) -> vec3f {
    return (1.0 - fresnel) * (diffuse * irradiance * INV_PI) + fresnel * (specular * radiance);
}
