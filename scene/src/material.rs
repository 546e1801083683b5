//! Surface materials.

use crate::params::Choice;
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A surface: Lambertian plus normalised Blinn–Phong reflection, two-sided; emission leaves the
/// front side only (the side from which the corners run counter-clockwise).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Diffuse albedo ρ = k_d, each channel in [0, 1].
    pub albedo: Vec3,
    /// Specular albedo k_s of the Blinn–Phong lobe, each channel in [0, 1].
    pub specular: Vec3,
    /// Blinn–Phong exponent n ≥ 0.
    pub shininess: f32,
    /// Emitted radiance in W·m⁻²·sr⁻¹, each channel ≥ 0.
    pub emission: Vec3,
    /// A perfect mirror with reflectance `specular`; `albedo` and `shininess` are then ignored.
    pub mirror: bool,
}

impl Material {
    /// A Lambertian surface of the given albedo that emits nothing.
    pub fn diffuse(albedo: Vec3) -> Self {
        Self {
            albedo,
            specular: Vec3::ZERO,
            shininess: 5.0,
            emission: Vec3::ZERO,
            mirror: false,
        }
    }

    /// A black surface that emits the given radiance from its front side.
    pub fn emitter(emission: Vec3) -> Self {
        Self {
            emission,
            ..Self::diffuse(Vec3::ZERO)
        }
    }
}

/// How surfaces reflect direct light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ReflectionLaw {
    /// k_d/π.
    #[default]
    Lambert,
    /// k_d/π and the normalised Blinn–Phong lobe of k_s.
    BlinnPhong,
}

impl Choice for ReflectionLaw {}

/// How direct light is computed for a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DirectLight {
    /// How surfaces reflect it.
    pub law: ReflectionLaw,
    /// Whether all objects cast shadows; without, light shines through them.
    pub shadows: bool,
}

impl From<ReflectionLaw> for DirectLight {
    fn from(law: ReflectionLaw) -> Self {
        Self { law, shadows: true }
    }
}

/// Factor (n+2)(n+4)/(8π(2^(−n/2)+n)) that makes Blinn–Phong's `(N·H)ⁿ (N·I)` reflect all of a
/// head-on beam. Domain n ≥ 0; SPEC P1, corrected.
pub fn blinn_phong_normalisation(shininess: f64) -> f64 {
    let n = shininess;
    (n + 2.0) * (n + 4.0) / (8.0 * std::f64::consts::PI * ((-n / 2.0).exp2() + n))
}
