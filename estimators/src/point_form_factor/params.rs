use crate::ranges::{
    MAX_BOUNCES, MAX_CAPTURE_RESOLUTION, MAX_RECAPTURE_DISTANCE_M, MAX_RESOLUTION,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Point-to-point form factors, by their parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct PointFormFactor {
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
    /// Captures are reused while the reference point is at most this far from where they were made; 0:
    /// never reused.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = MAX_RECAPTURE_DISTANCE_M), extend("unit" = "m"))]
    pub recapture_distance: f32,
    /// Upper bound of a texel's solid angle; 0: no bound.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = 100.0), extend("unit" = "sr"))]
    pub clamp: f32,
}
