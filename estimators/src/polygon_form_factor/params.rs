use crate::ranges::{
    MAX_BOUNCES, MAX_CAPTURE_RESOLUTION, MAX_RECAPTURE_DISTANCE_M, MAX_RESOLUTION,
};
use interreflect_scene::params::Fidelity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Which radiance a texel's quadrilateral has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Radiance {
    /// The texel's own, as in the paper's shader.
    #[default]
    Centre,
    /// The mean of its four corners', as in the paper's text.
    Corners,
}

/// Where the distance at a texel's corner comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Corners {
    /// What the fidelity calls for: `per_face` in `published`, `exact` in `corrected`.
    #[default]
    Fidelity,
    /// Bilinear between the texels of the same face.
    PerFace,
    /// The nearest texel; of several, the one of the lower column and row.
    Nearest,
    /// The mean of all texels that meet there, on other faces too.
    Seamless,
    /// The surface along the corner's own ray.
    Exact,
}

/// What becomes of a quadrilateral that faces away from the point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Facing {
    /// It counts negative: form factors keep their sum, and a quadrilateral across a gap in depth
    /// takes back what it covers up.
    #[default]
    Signed,
    /// It counts nothing.
    Clamped,
}

/// Polygon-to-point form factors, by their parameters.
///
/// A shader invocation has 25,300 turns of its loops at M = 64, and eight for each texel that the
/// horizon cuts: 5,000 of those would reach lavapipe's bound of 65,536.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct PolygonFormFactor {
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
    /// The paper literally, errata included, or what it meant.
    pub fidelity: Fidelity,
    /// A texel's radiance: its own (the paper's shader) or the mean of its corners' (text).
    pub radiance: Radiance,
    /// The distance at a corner: `fidelity` is `per_face` in `published`, `exact` in `corrected`.
    pub corners: Corners,
    /// `corrected` only: quadrilaterals that face away count negative, or nothing.
    pub facing: Facing,
}

impl PolygonFormFactor {
    /// Where the distance at a corner comes from, the fidelity's own choice resolved.
    pub(super) fn corners(&self) -> Corners {
        match (self.corners, self.fidelity) {
            (Corners::Fidelity, Fidelity::Published) => Corners::PerFace,
            (Corners::Fidelity, Fidelity::Corrected) => Corners::Exact,
            (corners, _) => corners,
        }
    }
}
