// Twins of math.rs, function by function.

// E = πL.
fn ambient_irradiance(radiance: vec3f) -> vec3f {
    return radiance * PI;
}

// (k_d + k_s)·L.
fn ambient_reflection(diffuse: vec3f, specular: vec3f, radiance: vec3f) -> vec3f {
    return (diffuse + specular) * radiance;
}
