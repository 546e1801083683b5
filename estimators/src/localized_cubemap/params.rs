use crate::fields;
use interreflect_scene::params::{Choice, Fidelity, Field, Params};

/// Which of the paper's two formulas gives a texel's solid angle seen from the reference point.
/// Read by `published` only; `corrected` uses the exact solid angle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SolidAngle {
    /// 4/(M²l³ + 4/π), as in the text.
    #[default]
    Text,
    /// 4/(M²l² + 4/π), as in the shader.
    Shader,
}

impl Choice for SolidAngle {
    const ALL: &'static [(&'static str, Self)] = &[("text", Self::Text), ("shader", Self::Shader)];
}

/// How a texel's reflectivity is evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reflectivity {
    /// In the direction of its middle.
    #[default]
    Sample,
    /// Averaged over its solid angle, from a table (P1 §3).
    Table,
}

impl Choice for Reflectivity {
    const ALL: &'static [(&'static str, Self)] =
        &[("sample", Self::Sample), ("table", Self::Table)];
}

/// Parameters of [`super::LocalizedCubemap`].
///
/// The ranges keep the loops of a shader invocation below 65,536 turns together: lavapipe ends them
/// there without a word.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalizedCubemap {
    /// M: texels along a face's edge that shading sums over.
    pub resolution: u32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance beyond that of the lights' light.
    pub bounces: u32,
    /// Distance in metres of the reference point from where captures were made, up to which they are
    /// kept (P1 §2).
    pub recapture_distance: f32,
    /// The paper as printed, or what it meant.
    pub fidelity: Fidelity,
    /// Which published solid angle.
    pub solid_angle: SolidAngle,
    /// How a texel's reflectivity is evaluated.
    pub reflectivity: Reflectivity,
}

impl Default for LocalizedCubemap {
    fn default() -> Self {
        Self {
            resolution: 4,
            capture_resolution: 256,
            bounces: 0,
            recapture_distance: 0.0,
            fidelity: Fidelity::Published,
            solid_angle: SolidAngle::Text,
            reflectivity: Reflectivity::Sample,
        }
    }
}

impl Params for LocalizedCubemap {
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
                "solid_angle",
                "published only: the solid angle of the text (l³) or of the shader (l²)",
                |p: &Self| p.solid_angle,
                |p, v| p.solid_angle = v,
            ),
            Field::choice(
                "reflectivity",
                "a texel's reflectivity: sampled at its middle, or averaged over its solid angle \
                 from a table",
                |p: &Self| p.reflectivity,
                |p, v| p.reflectivity = v,
            ),
        ]
    }
}
