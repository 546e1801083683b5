use crate::ranges::{
    F_LAMBDA, MAX_BOUNCES, MAX_CAPTURE_RESOLUTION, MAX_MAP_RESOLUTION, MAX_RESOLUTION,
    MIN_CONVOLUTION_RESOLUTION,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Phong-filtered environment maps, by their parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct PhongEnvmap {
    /// Phong exponent of every specular lobe, whatever the points' shininess.
    #[default(225.0)]
    #[schemars(range(min = 0.0, max = 1000.0), extend("symbol" = "N"))]
    pub exponent: f32,
    /// Reflectance at normal incidence in Schlick's Fresnel factor, which weighs k_d and k_s.
    #[default(F_LAMBDA)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "f_λ"))]
    pub f_lambda: f32,
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
    /// Cells along a face's edge of the convolved maps.
    #[default(32)]
    #[schemars(range(min = 1, max = MAX_MAP_RESOLUTION))]
    #[schemars(extend("unit" = "cells", "scale" = "log"))]
    pub map_resolution: u32,
    /// Reflections in the captured radiance beyond that of direct light, from coarse radiosity at the
    /// vertices.
    #[default(0)]
    #[schemars(range(max = MAX_BOUNCES))]
    pub bounces: u32,
}
