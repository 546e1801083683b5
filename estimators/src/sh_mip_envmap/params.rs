use crate::fields;
use interreflect_scene::params::{Choice, Fidelity, Field, Params};

/// Window over the bands of the irradiance's spherical harmonics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Window {
    /// Every band counts whole, as in the paper; the sum may be negative.
    #[default]
    None,
    /// Band l counts (1 + cos(πl/3))/2: 1, 3/4, 1/4.
    Hanning,
}

impl Choice for Window {
    const ALL: &'static [(&'static str, Self)] =
        &[("none", Self::None), ("hanning", Self::Hanning)];
}

/// What the level of the mip pyramid is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LodMode {
    /// The level is `lod`.
    #[default]
    Absolute,
    /// `lod` is added to the level that the change of the mirrored direction between neighbouring
    /// pixels calls for, as the paper does with the hardware's level.
    Bias,
}

impl Choice for LodMode {
    const ALL: &'static [(&'static str, Self)] =
        &[("absolute", Self::Absolute), ("bias", Self::Bias)];
}

/// Parameters of [`super::ShMipEnvmap`].
///
/// The smallest resolutions keep the loops of a shader invocation, which sums up to 128² captured
/// texels, below 65,536 turns: lavapipe ends them there without a word.
#[derive(Clone, Debug, PartialEq)]
pub struct ShMipEnvmap {
    /// Texels along a face's edge of the cube that spherical harmonics are projected from.
    pub sh_resolution: u32,
    /// Window over the bands.
    pub window: Window,
    /// Texels along a face's edge of the pyramid's base.
    pub resolution: u32,
    /// Level of the pyramid, or the bias on it.
    pub lod: f32,
    /// Which of the two.
    pub lod_mode: LodMode,
    /// Reflectance at normal incidence.
    pub f_lambda: f32,
    /// Texels along a face's edge when the environment is captured.
    pub capture_resolution: u32,
    /// Reflections in the captured radiance.
    pub bounces: u32,
    /// The paper as printed, or what it meant.
    pub fidelity: Fidelity,
}

impl Default for ShMipEnvmap {
    fn default() -> Self {
        Self {
            sh_resolution: 8,
            window: Window::None,
            resolution: 64,
            lod: 3.0,
            lod_mode: LodMode::Absolute,
            f_lambda: fields::F_LAMBDA,
            capture_resolution: 256,
            bounces: 0,
            fidelity: Fidelity::Published,
        }
    }
}

impl Params for ShMipEnvmap {
    fn fields() -> Vec<Field<Self>> {
        let mut fields = maps();
        fields.extend([
            fields::f_lambda(|p: &Self| p.f_lambda, |p, v| p.f_lambda = v),
            fields::capture_resolution(
                |p: &Self| p.capture_resolution,
                |p, v| p.capture_resolution = v,
            ),
            fields::bounces(|p: &Self| p.bounces, |p, v| p.bounces = v),
            Field::fidelity(|p: &Self| p.fidelity, |p, v| p.fidelity = v),
        ]);
        fields
    }
}

/// What both maps are made of.
fn maps() -> Vec<Field<ShMipEnvmap>> {
    vec![
        Field::u32(
            "sh_resolution",
            "texels along a face's edge of the cube that the spherical harmonics are projected \
             from, rounded up to a power of two",
            8..=64,
            |p: &ShMipEnvmap| p.sh_resolution,
            |p, v| p.sh_resolution = v,
        )
        .unit("texels")
        .log(),
        Field::choice(
            "window",
            "window over the bands of the spherical harmonics, against negative values",
            |p: &ShMipEnvmap| p.window,
            |p, v| p.window = v,
        ),
        Field::u32(
            "resolution",
            "texels along a face's edge of the mip pyramid's base, rounded up to a power of two",
            8..=512,
            |p: &ShMipEnvmap| p.resolution,
            |p, v| p.resolution = v,
        )
        .unit("texels")
        .log(),
        Field::f32(
            "lod",
            "level of the mip pyramid (0: the base), or the bias on it; clamped to the pyramid",
            -10.0..=10.0,
            |p: &ShMipEnvmap| p.lod,
            |p, v| p.lod = v,
        )
        .symbol("b"),
        Field::choice(
            "lod_mode",
            "absolute: the level is lod; bias: lod is added to the level that the mirrored \
             direction's change between neighbouring pixels calls for (points of images only)",
            |p: &ShMipEnvmap| p.lod_mode,
            |p, v| p.lod_mode = v,
        ),
    ]
}
