use crate::ranges::{F_LAMBDA, MAX_BOUNCES, MAX_CAPTURE_RESOLUTION};
use interreflect_scene::params::Fidelity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Window over the bands of the irradiance's spherical harmonics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Window {
    /// Every band counts whole, as in the paper; the sum may be negative.
    #[default]
    None,
    /// Band l counts (1 + cos(πl/3))/2: 1, 3/4, 1/4.
    Hanning,
}

/// What the level of the mip pyramid is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LodMode {
    /// The level is `lod`.
    #[default]
    Absolute,
    /// `lod` is added to the level that the change of the mirrored direction between neighbouring
    /// pixels calls for, as the paper does with the hardware's level.
    Bias,
}

/// Spherical harmonics and a mip pyramid, by their parameters.
///
/// The smallest resolutions keep the loops of a shader invocation, which sums up to 128² captured
/// texels, below 65,536 turns: lavapipe ends them there without a word.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct ShMipEnvmap {
    /// Texels along a face's edge of the cube that the spherical harmonics are projected from, rounded
    /// up to a power of two.
    #[default(8)]
    #[schemars(range(min = 8, max = 64), extend("unit" = "texels", "scale" = "log"))]
    pub sh_resolution: u32,
    /// Window over the bands of the spherical harmonics, against negative values.
    pub window: Window,
    /// Texels along a face's edge of the mip pyramid's base, rounded up to a power of two.
    #[default(64)]
    #[schemars(range(min = 8, max = 512), extend("unit" = "texels", "scale" = "log"))]
    pub resolution: u32,
    /// Level of the mip pyramid (0: the base), or the bias on it; clamped to the pyramid.
    #[default(3.0)]
    #[schemars(range(min = -10.0, max = 10.0), extend("symbol" = "b"))]
    pub lod: f32,
    /// `absolute`: the level is `lod`; `bias`: `lod` is added to the level that the mirrored
    /// direction's change between neighbouring pixels calls for (points of images only).
    pub lod_mode: LodMode,
    /// Reflectance at normal incidence in Schlick's Fresnel factor, which weighs k_d and k_s.
    #[default(F_LAMBDA)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "f_λ"))]
    pub f_lambda: f32,
    /// Texels along a face's edge when the environment is captured.
    #[default(256)]
    #[schemars(range(min = 1, max = MAX_CAPTURE_RESOLUTION))]
    #[schemars(extend("unit" = "texels", "scale" = "log"))]
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of direct light, from coarse radiosity at the
    /// vertices.
    #[default(0)]
    #[schemars(range(max = MAX_BOUNCES))]
    pub bounces: u32,
    /// The paper literally, errata included, or what it meant.
    pub fidelity: Fidelity,
}
