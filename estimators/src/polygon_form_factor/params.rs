use crate::fields;
use interreflect_scene::params::{Choice, Fidelity, Field, Params};

/// Which radiance a texel's quadrilateral has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Radiance {
    /// The texel's own, as in the paper's shader.
    #[default]
    Centre,
    /// The mean of its four corners', as in the paper's text.
    Corners,
}

impl Choice for Radiance {
    const ALL: &'static [(&'static str, Self)] =
        &[("centre", Self::Centre), ("corners", Self::Corners)];
}

/// Where the distance at a texel's corner comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

impl Choice for Corners {
    const ALL: &'static [(&'static str, Self)] = &[
        ("fidelity", Self::Fidelity),
        ("per_face", Self::PerFace),
        ("nearest", Self::Nearest),
        ("seamless", Self::Seamless),
        ("exact", Self::Exact),
    ];
}

/// What becomes of a quadrilateral that faces away from the point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Facing {
    /// It counts negative: form factors keep their sum, and a quadrilateral across a gap in depth
    /// takes back what it covers up.
    #[default]
    Signed,
    /// It counts nothing.
    Clamped,
}

impl Choice for Facing {
    const ALL: &'static [(&'static str, Self)] =
        &[("signed", Self::Signed), ("clamped", Self::Clamped)];
}

/// Parameters of [`super::PolygonFormFactor`].
///
/// The ranges keep the loops of a shader invocation below 65,536 turns together, where lavapipe ends
/// them without a word: 25,300 at M = 64, and eight for each texel that the horizon cuts, of which
/// there would have to be 5,000.
#[derive(Clone, Debug, PartialEq)]
pub struct PolygonFormFactor {
    /// M: texels along a face's edge that shading sums over.
    pub resolution: u32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of the lights' light.
    pub bounces: u32,
    /// Distance in metres of the reference point up to which captures are kept.
    pub recapture_distance: f32,
    /// The paper as printed, or what it meant.
    pub fidelity: Fidelity,
    /// Which radiance a quadrilateral has.
    pub radiance: Radiance,
    /// Where the distance at a corner comes from.
    pub corners: Corners,
    /// What becomes of quadrilaterals that face away; read by `corrected` only.
    pub facing: Facing,
}

impl Default for PolygonFormFactor {
    fn default() -> Self {
        Self {
            resolution: 4,
            capture_resolution: 256,
            bounces: 0,
            recapture_distance: 0.0,
            fidelity: Fidelity::Published,
            radiance: Radiance::Centre,
            corners: Corners::Fidelity,
            facing: Facing::Signed,
        }
    }
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

impl Params for PolygonFormFactor {
    fn fields() -> Vec<Field<Self>> {
        vec![
            fields::resolution(|p: &Self| p.resolution, |p, v| p.resolution = v),
            fields::capture_resolution(
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            ),
            fields::bounces(|p: &Self| p.bounces, |p, v| p.bounces = v),
            fields::recapture_distance(
                |p: &Self| p.recapture_distance,
                |p, v| p.recapture_distance = v,
            ),
            Field::fidelity(|p: &Self| p.fidelity, |p, v| p.fidelity = v),
            Field::choice(
                "radiance",
                "a texel's radiance: its own (the paper's shader) or the mean of its corners' (text)",
                |p: &Self| p.radiance,
                |p, v| p.radiance = v,
            ),
            Field::choice(
                "corners",
                "the distance at a corner: fidelity is per_face in published, exact in corrected",
                |p: &Self| p.corners,
                |p, v| p.corners = v,
            ),
            Field::choice(
                "facing",
                "corrected only: quadrilaterals that face away count negative, or nothing",
                |p: &Self| p.facing,
                |p, v| p.facing = v,
            ),
        ]
    }
}
