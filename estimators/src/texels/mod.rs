//! A captured cube averaged to a few texels, each at its surface's place, and the sum over them:
//! what the methods share that take the texels of a cube map for small lights.

pub mod average;
pub mod gather;
pub mod gpu;
pub mod leaves;
pub mod math;

use interreflect_scene::{CubeChannels, CubeSpec, SceneFacts};

/// The capture that is averaged down to `resolution`² texels a face: of `capture_resolution`² a face,
/// rounded up so that each texel averages the same whole number. Nothing has a place, and no normal,
/// without surfaces.
pub fn capture(
    resolution: u32,
    capture_resolution: u32,
    bounces: u32,
    normals: bool,
    scene: &SceneFacts,
) -> CubeSpec {
    CubeSpec {
        size: capture_resolution.next_multiple_of(resolution),
        channels: CubeChannels {
            radiance: true,
            distance: scene.captured_surfaces,
            normal: scene.captured_surfaces && normals,
        },
        bounces,
    }
}

/// One texel, as both backends read it: three vectors of four `f32`s.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Texel {
    /// Unit direction from the reference point.
    pub direction: [f32; 3],
    /// w = 1/d in 1/m; 0 at infinity.
    pub inverse_distance: f32,
    /// Mean radiance.
    pub radiance: [f32; 3],
    /// What the method says of the texel's size: see [`average::Tables::new`].
    pub extent: f32,
    /// Unit normal of the surface; [`average::Averaging::MeanPlane`] only.
    pub normal: [f32; 3],
    /// Nothing; keeps the layout.
    pub pad: f32,
}
