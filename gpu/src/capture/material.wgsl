// Surface materials, as captures read them.

struct Material {
    // ρ = k_d; 0 for a mirror.
    albedo: vec3f,
    // Blinn–Phong exponent.
    shininess: f32,
    // Emitted radiance of the front side.
    emission: vec3f,
    // 1 for a mirror.
    mirror: u32,
    // k_s, or a mirror's reflectance.
    specular: vec3f,
}
