use crate::ranges::{
    MAX_BOUNCES, MAX_CAPTURE_RESOLUTION, MAX_MAP_RESOLUTION, MAX_RESOLUTION,
    MIN_CONVOLUTION_RESOLUTION,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Classic environment mapping, by its parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct ClassicEnvmap {
    /// Texels along a face's edge that the convolution sums over.
    #[default(32)]
    #[schemars(range(min = MIN_CONVOLUTION_RESOLUTION, max = MAX_RESOLUTION))]
    #[schemars(extend("unit" = "texels", "scale" = "log"))]
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
    /// Cells along a face's edge of the convolved maps.
    #[default(32)]
    #[schemars(range(min = 1, max = MAX_MAP_RESOLUTION))]
    #[schemars(extend("unit" = "cells", "scale" = "log"))]
    pub map_resolution: u32,
}
