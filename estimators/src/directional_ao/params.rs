use super::sphere::MAX_LEVEL;
use interreflect_scene::params::{Choice, Fidelity, Field, Params};

/// How a depth map is kept from occluding the surface that it shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bias {
    /// By its slope over one texel: `glPolygonOffset(1, 1)`, as in the paper.
    PolygonOffset,
    /// By a texel's width.
    Constant,
    /// Not at all.
    None,
}

impl Choice for Bias {
    const ALL: &'static [(&'static str, Self)] = &[
        ("polygon_offset", Self::PolygonOffset),
        ("constant", Self::Constant),
        ("none", Self::None),
    ];
}

/// How visibility is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Visibility {
    /// A look into the depth map.
    DepthMap,
    /// An occlusion query for each point, as in the paper (GPU).
    Queries,
    /// A ray for each point and direction (CPU).
    Rays,
}

impl Choice for Visibility {
    const ALL: &'static [(&'static str, Self)] = &[
        ("depth_map", Self::DepthMap),
        ("queries", Self::Queries),
        ("rays", Self::Rays),
    ];
}

/// Parameters of [`super::DirectionalAo`].
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionalAo {
    /// s: how often the octahedron of directions is subdivided.
    pub level: u32,
    /// Texels along the edge of a depth map.
    pub map_resolution: u32,
    /// Bias of the depth maps.
    pub bias: Bias,
    /// How visibility is found.
    pub visibility: Visibility,
    /// Standard deviation in degrees of the Gaussian that blurs the environment.
    pub blur_deg: f32,
    /// Only vertices about to be seen are evaluated.
    pub filter: bool,
    /// Highest level while surfaces move.
    pub moving_level: u32,
    /// Frames per second that the level is held to; 0 for none.
    pub target_fps: f32,
    /// The paper's weights, or those that are right.
    pub fidelity: Fidelity,
}

impl Default for DirectionalAo {
    fn default() -> Self {
        Self {
            level: 2,
            map_resolution: 512,
            bias: Bias::PolygonOffset,
            visibility: Visibility::DepthMap,
            blur_deg: 10.0,
            filter: false,
            moving_level: MAX_LEVEL,
            target_fps: 0.0,
            fidelity: Fidelity::Published,
        }
    }
}

impl Params for DirectionalAo {
    fn fields() -> Vec<Field<Self>> {
        let mut fields = looks();
        fields.extend(frames());
        fields.push(Field::fidelity(
            |p: &Self| p.fidelity,
            |p, v| p.fidelity = v,
        ));
        fields
    }
}

/// How one frame looks.
fn looks() -> Vec<Field<DirectionalAo>> {
    vec![
        Field::u32(
            "level",
            "how often the octahedron of directions is subdivided: 6, 18, 66, 258, 1026 directions",
            0..=MAX_LEVEL,
            |p: &DirectionalAo| p.level,
            |p, v| p.level = v,
        )
        .symbol("s"),
        Field::u32(
            "map_resolution",
            "texels along the edge of a depth map",
            8..=2048,
            |p: &DirectionalAo| p.map_resolution,
            |p, v| p.map_resolution = v,
        )
        .unit("texels")
        .log(),
        Field::choice(
            "bias",
            "what keeps a depth map from occluding the surface that it shows",
            |p: &DirectionalAo| p.bias,
            |p, v| p.bias = v,
        ),
        Field::choice(
            "visibility",
            "how a point is found open: a look into the depth map, an occlusion query (GPU), or a \
             ray (CPU)",
            |p: &DirectionalAo| p.visibility,
            |p, v| p.visibility = v,
        ),
        Field::f32(
            "blur_deg",
            "standard deviation of the Gaussian that blurs the environment before it is sampled",
            0.0..=90.0,
            |p: &DirectionalAo| p.blur_deg,
            |p, v| p.blur_deg = v,
        )
        .symbol("σ")
        .unit("°"),
    ]
}

/// What is saved from frame to frame.
fn frames() -> Vec<Field<DirectionalAo>> {
    vec![
        Field::bool(
            "filter",
            "evaluate only vertices that are about to be seen (sequences shaded at vertices)",
            |p: &DirectionalAo| p.filter,
            |p, v| p.filter = v,
        ),
        Field::u32(
            "moving_level",
            "highest level while surfaces move; refined by one level a frame when they rest",
            0..=MAX_LEVEL,
            |p: &DirectionalAo| p.moving_level,
            |p, v| p.moving_level = v,
        ),
        Field::f32(
            "target_fps",
            "frames per second that the level is held to, below `level`; 0 for none",
            0.0..=1000.0,
            |p: &DirectionalAo| p.target_fps,
            |p, v| p.target_fps = v,
        )
        .unit("1/s"),
    ]
}
