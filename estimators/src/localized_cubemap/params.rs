use crate::ranges::{
    MAX_BOUNCES, MAX_CAPTURE_RESOLUTION, MAX_RECAPTURE_DISTANCE_M, MAX_RESOLUTION,
};
use interreflect_scene::params::Fidelity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Which of the paper's two formulas gives a texel's solid angle seen from the reference point.
/// Read by `published` only; `corrected` uses the exact solid angle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SolidAngle {
    /// 4/(M²l³ + 4/π), as in the text.
    #[default]
    Text,
    /// 4/(M²l² + 4/π), as in the shader.
    Shader,
}

/// How a texel's reflectivity is evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reflectivity {
    /// In the direction of its middle.
    #[default]
    Sample,
    /// Averaged over its solid angle, from a table (P1 §3).
    Table,
}

/// Localized cube maps, by their parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct LocalizedCubemap {
    /// Texels along a face's edge that shading sums over.
    #[default(4)]
    #[schemars(range(min = 1, max = MAX_RESOLUTION))]
    #[schemars(extend("symbol" = "M", "unit" = "texels", "scale" = "log"))]
    pub resolution: u32,
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
    /// Captures are reused while the reference point is at most this far from where they were made
    /// (§2); 0: never reused.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = MAX_RECAPTURE_DISTANCE_M), extend("unit" = "m"))]
    pub recapture_distance: f32,
    /// The paper literally, errata included, or what it meant.
    pub fidelity: Fidelity,
    /// `published` only: the solid angle of the text (l³) or of the shader (l²).
    pub solid_angle: SolidAngle,
    /// A texel's reflectivity: sampled at its middle, or averaged over its solid angle from a table.
    pub reflectivity: Reflectivity,
}
