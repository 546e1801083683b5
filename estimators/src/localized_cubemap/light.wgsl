// What a localized cube map says of a texel to gather.wgsl.

override corrected: bool = false;
// Average reflectivity from a table, not at one sample (P1 §3).
override averaged: bool = false;

// Nodes of a table along both of its axes.
const ANGLES: u32 = 128u;
const SOLID_ANGLES: u32 = 16u;

struct Lobes {
    // Exponents, ascending.
    shininess: array<vec4f, 2>,
    count: u32,
    pad: u32,
}

@group(0) @binding(5) var<uniform> lobes: Lobes;
// The cosine's table, then one for each lobe.
@group(0) @binding(6) var<storage, read> tables: array<f32>;

struct TexelLobe {
    shininess: f32,
    normalisation: f32,
    // Which table.
    table: u32,
}

// Bilinear value of a table.
fn averaged_over(table: u32, cos_theta: f32, omega: f32) -> f32 {
    let place = table_place(cos_theta, omega);
    let at = vec2f(place.first * f32(ANGLES - 1u), place.second * f32(SOLID_ANGLES - 1u));
    let cell = min(floor(at), vec2f(f32(ANGLES - 2u), f32(SOLID_ANGLES - 2u)));
    let f = at - cell;
    let first = (table * SOLID_ANGLES + u32(cell.y)) * ANGLES + u32(cell.x);
    let low = tables[first] * (1.0 - f.x) + tables[first + 1u] * f.x;
    let high = tables[first + ANGLES] * (1.0 - f.x) + tables[first + ANGLES + 1u] * f.x;
    return low * (1.0 - f.y) + high * f.y;
}

fn texel_omega(extent: f32, r2: f32, cos_surface: f32) -> f32 {
    if corrected {
        return omega_corrected(extent, r2, cos_surface);
    }
    return omega_published(extent, r2);
}

fn texel_cosine(n_i: f32, omega: f32) -> f32 {
    if averaged {
        return averaged_over(0u, n_i, omega);
    }
    return max(n_i, 0.0);
}

fn texel_lobe(shininess: f32) -> TexelLobe {
    var table = 0u;
    if averaged {
        while table + 1u < lobes.count && lobes.shininess[table / 4u][table % 4u] < shininess {
            table++;
        }
    }
    // Without lobes nothing shines, and any table will do.
    return TexelLobe(shininess, lobe_normalisation(shininess), min(1u + table, lobes.count));
}

fn texel_reflectivity(lobe: TexelLobe, n_i: f32, n_v: f32, n_h: f32, omega: f32) -> Reflectivity {
    if averaged {
        let cos_theta = averaged_over(0u, n_i, omega);
        let power = averaged_over(lobe.table, n_h, omega);
        if corrected {
            return Reflectivity(cos_theta * INV_PI, cos_theta * lobe.normalisation * power);
        }
        let lit = n_v > 0.0;
        return Reflectivity(select(0.0, cos_theta, lit), select(0.0, power, lit && n_i > 0.0));
    }
    if corrected {
        return normalised_reflectivity(n_i, n_h, lobe.shininess, lobe.normalisation);
    }
    return reflectivity_published(n_i, n_v, n_h, lobe.shininess);
}
