use crate::fields;
use interreflect_scene::params::{Field, Params};

/// Parameters of [`super::ConstantAmbient`].
#[derive(Clone, Debug, PartialEq)]
pub struct ConstantAmbient {
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of the lights' light.
    pub bounces: u32,
}

impl Default for ConstantAmbient {
    fn default() -> Self {
        Self {
            capture_resolution: 64,
            bounces: 0,
        }
    }
}

impl Params for ConstantAmbient {
    fn fields() -> Vec<Field<Self>> {
        vec![
            fields::capture_resolution(
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            ),
            fields::bounces(|p: &Self| p.bounces, |p, v| p.bounces = v),
        ]
    }
}
