// What a surface in a light's view is made of, with the light that arrives there.

struct TrueColors {
    // k_d.
    diffuse: vec3f,
    // Blinn–Phong exponent.
    shininess: f32,
    // k_s.
    specular: vec3f,
    // E·cos α in W/m².
    irradiance: vec3f,
    // Unit direction from which it arrives.
    to_light: vec3f,
}
