//! Cube captures on the host, the common tongue of the two backends.

use crate::{CubeChannels, CubeSpec, conventions};
use glam::Vec3;

/// A captured cube map: planes of texels in the order of [`conventions::texel_index`].
///
/// A channel that was not asked for is an empty vector. Where a ray met no surface, `distance` is
/// +∞, `normal` is zero and `radiance` is the environment's (zero without one).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CubeImage {
    /// Texels along the edge of a face.
    pub size: u32,
    /// Radiance towards the reference point, W·m⁻²·sr⁻¹.
    pub radiance: Vec<Vec3>,
    /// Distance to the surface in metres.
    pub distance: Vec<f32>,
    /// Unit normal of the surface, turned to the reference point.
    pub normal: Vec<Vec3>,
    /// Reflections that the radiance holds beyond that of the lights' light.
    pub bounces: u32,
}

impl CubeImage {
    /// Bytes of all its texels.
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.radiance) + size_of_val(&*self.distance) + size_of_val(&*self.normal)
    }

    /// A cube of black texels with the channels of `spec`.
    pub fn new(spec: CubeSpec) -> Self {
        let texels = conventions::CUBE_FACES * (spec.size as usize).pow(2);
        let count = |asked: bool| if asked { texels } else { 0 };
        Self {
            size: spec.size,
            radiance: vec![Vec3::ZERO; count(spec.channels.radiance)],
            distance: vec![f32::INFINITY; count(spec.channels.distance)],
            normal: vec![Vec3::ZERO; count(spec.channels.normal)],
            bounces: spec.bounces,
        }
    }

    /// The spec that this image answers.
    pub fn spec(&self) -> CubeSpec {
        CubeSpec {
            size: self.size,
            channels: CubeChannels {
                radiance: !self.radiance.is_empty(),
                distance: !self.distance.is_empty(),
                normal: !self.normal.is_empty(),
            },
            bounces: self.bounces,
        }
    }

    /// Number of texels on all faces.
    pub fn texels(&self) -> usize {
        conventions::CUBE_FACES * (self.size as usize).pow(2)
    }
}
