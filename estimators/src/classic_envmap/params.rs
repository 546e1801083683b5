use crate::fields;
use interreflect_scene::params::{Field, Params};

/// Parameters of [`super::ClassicEnvmap`].
#[derive(Clone, Debug, PartialEq)]
pub struct ClassicEnvmap {
    /// Texels along a face's edge that the convolution sums over.
    pub resolution: u32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of the lights' light.
    pub bounces: u32,
    /// Cells along a face's edge of the convolved maps.
    pub map_resolution: u32,
}

impl Default for ClassicEnvmap {
    fn default() -> Self {
        Self {
            resolution: 32,
            capture_resolution: 256,
            bounces: 0,
            map_resolution: 32,
        }
    }
}

impl Params for ClassicEnvmap {
    fn fields() -> Vec<Field<Self>> {
        vec![
            fields::convolution_resolution(|p: &Self| p.resolution, |p, v| p.resolution = v),
            fields::capture_resolution(
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            ),
            fields::bounces(|p: &Self| p.bounces, |p, v| p.bounces = v),
            fields::map_resolution(|p: &Self| p.map_resolution, |p, v| p.map_resolution = v),
        ]
    }
}
