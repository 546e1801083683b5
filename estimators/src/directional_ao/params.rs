use super::sphere::MAX_LEVEL;
use interreflect_scene::params::Fidelity;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// How a depth map is kept from occluding the surface that it shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Bias {
    /// By its slope over one texel: `glPolygonOffset(1, 1)`, as in the paper.
    #[default]
    PolygonOffset,
    /// By a texel's width.
    Constant,
    /// Not at all.
    None,
}

/// How visibility is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Visibility {
    /// A lookup in the depth map.
    #[default]
    DepthMap,
    /// An occlusion query for each point, as in the paper; on the CPU the test that it makes of the
    /// drawn point.
    Queries,
    /// A ray for each point and direction (CPU).
    Rays,
}

/// What of the points that a sequence of frames is shaded at waits until the camera sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Filter {
    /// Nothing: every vertex is evaluated at once.
    #[default]
    None,
    /// Vertices of triangles that were not visible yet.
    Triangles,
    /// Vertices that were not visible yet themselves: a hidden corner of a visible triangle stays
    /// without a value.
    Vertices,
}

/// What a direction below the horizon counts where nothing is found to occlude it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BelowHorizon {
    /// Nothing.
    #[default]
    Clamped,
    /// Its negative cosine, as M_ij is printed.
    Signed,
}

/// Ambient occlusion from many directions, by its parameters.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct DirectionalAo {
    /// Subdivisions of the octahedron of directions, 0 to 4: 6, 18, 66, 258, 1026 directions.
    #[default(2)]
    #[schemars(range(max = MAX_LEVEL), extend("symbol" = "s"))]
    pub level: u32,
    /// Texels along the edge of a depth map.
    #[default(512)]
    #[schemars(range(min = 8, max = 2048), extend("unit" = "texels", "scale" = "log"))]
    pub map_resolution: u32,
    /// Depth bias that keeps a surface from occluding itself.
    pub bias: Bias,
    /// Visibility test: a lookup in the depth map, an occlusion query, or a ray (CPU).
    pub visibility: Visibility,
    /// Unoccluded directions below the horizon: count nothing, or their negative cosine as printed.
    pub below_horizon: BelowHorizon,
    /// Standard deviation of the Gaussian that blurs the environment before it is sampled.
    #[default(10.0)]
    #[schemars(range(min = 0.0, max = 90.0), extend("symbol" = "σ", "unit" = "°"))]
    pub blur_deg: f32,
    /// Evaluate only vertices of triangles that become visible, or only vertices that do (wrong at
    /// hidden corners), in sequences shaded at vertices.
    pub filter: Filter,
    /// Highest level while surfaces move other than as one rigid body; at rest it rises by one level per frame.
    #[default(MAX_LEVEL)]
    #[schemars(range(max = MAX_LEVEL))]
    pub moving_level: u32,
    /// Frame rate to hold by lowering the level below `level`; 0: none.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = 1000.0), extend("unit" = "1/s"))]
    pub target_fps: f32,
    /// The paper literally, errata included, or what it meant.
    pub fidelity: Fidelity,
}
