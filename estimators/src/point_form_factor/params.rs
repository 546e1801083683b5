use crate::fields;
use interreflect_scene::params::{Field, Params};

/// Parameters of [`super::PointFormFactor`].
///
/// The ranges keep the loops of a shader invocation below 65,536 turns together: lavapipe ends them
/// there without a word.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFormFactor {
    /// M: texels along a face's edge that shading sums over.
    pub resolution: u32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of the lights' light.
    pub bounces: u32,
    /// Distance in metres of the reference point up to which captures are kept.
    pub recapture_distance: f32,
    /// Largest solid angle in sr that one texel counts; 0 for no bound.
    pub clamp: f32,
}

impl Default for PointFormFactor {
    fn default() -> Self {
        Self {
            resolution: 4,
            capture_resolution: 256,
            bounces: 0,
            recapture_distance: 0.0,
            clamp: 0.0,
        }
    }
}

impl Params for PointFormFactor {
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
            Field::f32(
                "clamp",
                "largest solid angle that one texel counts; 0 for no bound",
                0.0..=100.0,
                |p: &Self| p.clamp,
                |p, v| p.clamp = v,
            )
            .unit("sr"),
        ]
    }
}
