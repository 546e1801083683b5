// A lit place, and what it reflects by its lobe: `Photon` and `Highlight` in samples.rs.

struct Photon {
    position: vec3f,
    // Solid angle in sr where that is the same from everywhere, else area in m².
    extent: f32,
    // Radiance that is reflected by Lambert's law.
    radiance: vec3f,
    pad: f32,
    normal: vec3f,
    shininess: f32,
}

struct Highlight {
    // Radiance at the lobe's peak.
    radiance: vec3f,
    pad: f32,
    // Unit direction from which light arrives.
    to_light: vec3f,
    pad_to_light: f32,
}
