//! Reflective shadow maps on the host.
//!
//! What the first ray of a light meets is lit; a reflective shadow map is a list of lit places
//! (Frisvad et al., *Direct Radiance Mapping*, §3).

use crate::{Bounds, LightFrame, RsmChannels, RsmSpec, RsmViews, Scene, conventions};
use glam::Vec3;

/// Mirrors that a ray of a light is followed through, at most.
pub const MAX_MIRRORS: usize = 8;

/// What a surface is made of, with the light that arrives there: what its radiance towards any
/// direction follows from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrueColors {
    /// k_d.
    pub diffuse: Vec3,
    /// k_s.
    pub specular: Vec3,
    /// Blinn–Phong exponent.
    pub shininess: f32,
    /// Irradiance E·cos α in W/m² from the view's light alone, through the mirrors on the way.
    pub irradiance: Vec3,
    /// Unit direction from which it arrives.
    pub to_light: Vec3,
}

/// Reflective shadow maps of every light of a scene: planes of texels, frame by frame, rows of
/// columns ([`view_index`]).
///
/// A channel that was not asked for is an empty vector. Where a ray met no surface, or one that the
/// light does not shine on, `path_m` is 0 and the texel is no photon. A mirror is none either: the
/// texel shows what the ray meets after at most [`MAX_MIRRORS`] of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RsmImage {
    /// Texels along the edge of a view.
    pub size: u32,
    /// Which views there are.
    pub views: RsmViews,
    /// What each texel holds.
    pub channels: RsmChannels,
    /// Where the views are taken from.
    pub frames: Vec<LightFrame>,
    /// Box around all surfaces.
    pub bounds: Bounds,
    /// Position of the surface in metres.
    pub position: Vec<Vec3>,
    /// Length b of the light's way in metres, from its frame's origin and over all mirrors; 0 where
    /// there is no photon.
    pub path_m: Vec<f32>,
    /// Radiance ρ/π·E·cos α that the surface reflects of this light alone, W·m⁻²·sr⁻¹.
    pub radiance: Vec<Vec3>,
    /// Unit normal of the surface, on the side of the arriving light.
    pub normal: Vec<Vec3>,
    /// Cosine cos α between that normal and the arriving light; there with the normal.
    pub cos_light: Vec<f32>,
    /// What the surface is made of.
    pub true_colors: Vec<TrueColors>,
}

impl RsmImage {
    /// Bytes of all its texels.
    pub fn bytes(&self) -> usize {
        let places = size_of_val(&*self.position) + size_of_val(&*self.path_m);
        let light = size_of_val(&*self.radiance) + size_of_val(&*self.cos_light);
        let surfaces = size_of_val(&*self.normal) + size_of_val(&*self.true_colors);
        places + light + surfaces
    }

    /// Views without a photon, with the channels of `spec`.
    pub fn new(scene: &Scene, spec: RsmSpec) -> Self {
        let frames = scene.light_frames(spec.views);
        Self::blank(frames, Bounds::of_all(scene), spec)
    }

    /// Views from these frames without a photon.
    pub fn blank(frames: Vec<LightFrame>, bounds: Bounds, spec: RsmSpec) -> Self {
        let texels = frames.len() * (spec.size as usize).pow(2);
        let count = |asked: bool| if asked { texels } else { 0 };
        let channels = spec.channels;
        Self {
            size: spec.size,
            views: spec.views,
            channels,
            frames,
            bounds,
            position: vec![Vec3::ZERO; texels],
            path_m: vec![0.0; texels],
            radiance: vec![Vec3::ZERO; count(channels.radiance)],
            normal: vec![Vec3::ZERO; count(channels.normal)],
            cos_light: vec![0.0; count(channels.normal)],
            true_colors: vec![TrueColors::default(); count(channels.true_colors)],
        }
    }

    /// The spec that this image answers.
    pub fn spec(&self) -> RsmSpec {
        RsmSpec {
            size: self.size,
            views: self.views,
            channels: self.channels,
        }
    }

    /// Number of texels in all views.
    pub fn texels(&self) -> usize {
        self.frames.len() * (self.size as usize).pow(2)
    }
}

/// Index of a texel in the images and buffers of views of `size`² texels: frames, then rows.
#[inline]
pub fn view_index(size: u32, frame: usize, column: u32, row: u32) -> usize {
    conventions::texel_index(size, frame, column, row)
}
