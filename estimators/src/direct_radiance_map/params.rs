use interreflect_scene::params::Fidelity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Which of the paper's solid angles a photon has. Read by `published` only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SolidAngle {
    /// 2π/M for each of the M samples of a light.
    Eq11,
    /// cos θ'·A/(A + r²).
    #[default]
    Eq14,
    /// A'/|diag|², |diag| the diagonal of the scene's bounding box.
    Eq15,
}

/// Whose size a photon has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TexelOf {
    /// A cell of the sample grid: all light is counted.
    #[default]
    Grid,
    /// A texel of the map: with fewer samples than texels the light between them is lost.
    Texture,
}

/// How many pictures a light takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Pictures {
    /// One picture a light, in the direction that the scene gives: what it does not show is not counted.
    #[default]
    One,
    /// As many pictures as show all that the light shines on, N² samples in each (ours).
    Surround,
}

/// How lit surfaces reflect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// The same radiance in all directions.
    #[default]
    Lambertian,
    /// By k_d and k_s towards the shaded point, from true colours and normals.
    BlinnPhong,
}

/// Direct radiance maps, by their parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct DirectRadianceMap {
    /// Texels along the edge of a reflective shadow map.
    #[default(16)]
    #[schemars(range(min = 1, max = 256))]
    #[schemars(extend("symbol" = "w", "unit" = "texels", "scale" = "log"))]
    pub map_resolution: u32,
    /// Samples along the edge of the grid over a picture, at most its texels.
    #[default(3)]
    #[schemars(range(min = 1, max = 64), extend("symbol" = "N", "scale" = "log"))]
    pub samples_per_side: u32,
    /// One picture a light, or as many as show all that it shines on (ours).
    pub pictures: Pictures,
    /// The paper literally, errata included, or what it meant.
    pub fidelity: Fidelity,
    /// `published` only: a sample's solid angle by equation 11, 14 or 15.
    pub solid_angle: SolidAngle,
    /// A sample's size: its cell of the grid, or a texel of the map, which loses the light in between.
    pub texel: TexelOf,
    /// A sample's radiance (corrected: its place, normal and area too) is the mean over its cell, against flashing (§5).
    #[default(false)]
    pub mip: bool,
    /// Lit surfaces reflect by Lambert's law, or by their whole material.
    pub surface: Surface,
}
