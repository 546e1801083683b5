//! What a method asks of a backend before it can run.

use crate::{Bounds, DirectionalDepthSpec};
use std::collections::BTreeSet;

/// Channels of a cube capture; what is not asked for is not captured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CubeChannels {
    /// Radiance towards the reference point: emission and reflected direct light.
    pub radiance: bool,
    /// Distance from the reference point to the surface.
    pub distance: bool,
    /// Unit normal of the surface, on the side of the reference point.
    pub normal: bool,
}

/// A cube capture around the scene's reference point, one ray through each texel's centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CubeSpec {
    /// Texels along the edge of a face.
    pub size: u32,
    /// What each texel holds.
    pub channels: CubeChannels,
    /// Reflections that captured radiance holds beyond that of the lights' light, from a coarse
    /// per-vertex solution; 0 without radiance.
    pub bounces: u32,
}

impl CubeSpec {
    /// Radiance alone, of emission and of the lights' light reflected once.
    pub fn of_radiance(size: u32) -> Self {
        Self {
            size,
            channels: CubeChannels {
                radiance: true,
                ..CubeChannels::default()
            },
            bounces: 0,
        }
    }
}

/// Channels of a light's view; what is not asked for is not captured. The surface's position is
/// always there, and how far the light came.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RsmChannels {
    /// Radiance that Lambertian reflection returns of this light alone.
    pub radiance: bool,
    /// Unit normal of the surface, and the cosine of the arriving light with it.
    pub normal: bool,
    /// The surface's reflectances, with the irradiance and its direction.
    pub true_colors: bool,
}

/// Which views of a light there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RsmViews {
    /// One view from each light, in the direction of its picture.
    #[default]
    Picture,
    /// As many views as it takes to see everything that the light may shine on.
    Surround,
}

/// Views from every light of the scene, one ray through each texel's centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct RsmSpec {
    /// Texels along the edge of a view.
    pub size: u32,
    /// Which views.
    pub views: RsmViews,
    /// What each texel holds.
    pub channels: RsmChannels,
}

/// Everything a method reads beyond its points. A capture that was not declared can't be read;
/// one that was declared and never read fails conformance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Needs {
    /// Cube captures, each readable by the spec that asked for it.
    pub cubes: BTreeSet<CubeSpec>,
    /// Depth maps along directions, each set readable by the spec that asked for it.
    pub directional_depths: BTreeSet<DirectionalDepthSpec>,
    /// The radiance that arrives from infinitely far away.
    pub environment: bool,
    /// Views from the lights, each readable by the spec that asked for it.
    pub rsms: BTreeSet<RsmSpec>,
    /// Ray queries and full light transport in the whole scene (CPU only).
    pub light_transport: bool,
    /// Captures made elsewhere will do, up to this distance in metres from the reference point; 0:
    /// each frame has its own.
    pub keep_within_m: f32,
}

impl Needs {
    /// Whether nothing is to be captured.
    pub fn no_captures(&self) -> bool {
        self.cubes.is_empty() && self.rsms.is_empty()
    }
}

/// What a method may know of a scene when it says what it needs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SceneFacts {
    /// There are surfaces to capture.
    pub captured_surfaces: bool,
    /// There are surfaces, receivers included: lights may shine on them, and they may lie between a point and the sky.
    pub any_surface: bool,
    /// Radiance arrives from infinitely far away.
    pub environment: bool,
    /// Number of point, spot, directional and area lights.
    pub lights: u32,
    /// Some captured surface emits.
    pub emitters: bool,
    /// Some captured surface is a mirror.
    pub mirrors: bool,
    /// The box around the captured surfaces: a proxy of their places. Without an extent, at the origin,
    /// where there are none.
    pub bounds: Bounds,
}
