use crate::ranges::{MAX_BOUNCES, MAX_CAPTURE_RESOLUTION};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Constant ambient light, by its parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct ConstantAmbient {
    /// Texels along a face's edge when the environment is captured.
    #[default(64)]
    #[schemars(range(min = 1, max = MAX_CAPTURE_RESOLUTION))]
    #[schemars(extend("unit" = "texels", "scale" = "log"))]
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of direct light, from coarse radiosity at the
    /// vertices.
    #[default(0)]
    #[schemars(range(max = MAX_BOUNCES))]
    pub bounces: u32,
}
