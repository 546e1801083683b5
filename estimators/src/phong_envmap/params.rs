use crate::fields;
use interreflect_scene::params::{Field, Params};

/// Parameters of [`super::PhongEnvmap`].
#[derive(Clone, Debug, PartialEq)]
pub struct PhongEnvmap {
    /// N: the Phong exponent of every specular lobe.
    pub exponent: f32,
    /// Reflectance at normal incidence.
    pub f_lambda: f32,
    /// Texels along a face's edge that the convolution sums over.
    pub resolution: u32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Cells along a face's edge of the convolved maps.
    pub map_resolution: u32,
    /// Reflections in the captured radiance.
    pub bounces: u32,
}

impl Default for PhongEnvmap {
    fn default() -> Self {
        Self {
            exponent: 225.0,
            f_lambda: fields::F_LAMBDA,
            resolution: 32,
            capture_resolution: 256,
            map_resolution: 32,
            bounces: 0,
        }
    }
}

impl Params for PhongEnvmap {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::f32(
                "exponent",
                "Phong exponent of every specular lobe, whatever the points' shininess",
                0.0..=1000.0,
                |p: &Self| p.exponent,
                |p, v| p.exponent = v,
            )
            .symbol("N"),
            fields::f_lambda(|p: &Self| p.f_lambda, |p, v| p.f_lambda = v),
            fields::convolution_resolution(|p: &Self| p.resolution, |p, v| p.resolution = v),
            fields::capture_resolution(
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            ),
            fields::map_resolution(|p: &Self| p.map_resolution, |p, v| p.map_resolution = v),
            fields::bounces(|p: &Self| p.bounces, |p, v| p.bounces = v),
        ]
    }
}
