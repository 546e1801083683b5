// Constants and functions of light reflection.

const PI: f32 = 3.14159265358979;
const TAU: f32 = 6.28318530717959;
const INV_PI: f32 = 0.318309886183791;

// Factor (n+2)(n+4)/(8π(2^(−n/2)+n)) that makes Blinn–Phong's (N·H)ⁿ (N·I) reflect all of a
// head-on beam. Domain n ≥ 0.
fn blinn_phong_normalisation(shininess: f32) -> f32 {
    let n = shininess;
    return (n + 2.0) * (n + 4.0) / (8.0 * PI * (exp2(-0.5 * n) + n));
}
