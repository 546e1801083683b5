// What a virtual point light says of a texel to gather.wgsl.

// Largest solid angle in sr that one texel counts.
override largest: f32 = 0.0;

struct TexelLobe {
    shininess: f32,
    normalisation: f32,
}

fn texel_omega(extent: f32, r2: f32, cos_surface: f32) -> f32 {
    return point_omega(extent, r2, cos_surface, largest);
}

fn texel_cosine(n_i: f32, omega: f32) -> f32 {
    return max(n_i, 0.0);
}

fn texel_lobe(shininess: f32) -> TexelLobe {
    return TexelLobe(shininess, lobe_normalisation(shininess));
}

fn texel_reflectivity(lobe: TexelLobe, n_i: f32, n_v: f32, n_h: f32, omega: f32) -> Reflectivity {
    return normalised_reflectivity(n_i, n_h, lobe.shininess, lobe.normalisation);
}
