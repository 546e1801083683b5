//! Maps of a cube at infinity, convolved with the cosine or with a Phong lobe: cube maps whose
//! nodes are shared along the edges of faces, so that a bilinear lookup has no seam.

pub mod claims;
pub mod cpu;
pub mod gpu;
pub mod leaves;
pub mod math;
mod sources;

use interreflect_scene::CubeSpec;

/// What is convolved and into what: all that the tables depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// The captured cube, of a whole multiple of `resolution`.
    pub captured: CubeSpec,
    /// Texels along a face's edge that a convolution sums over: 64 at most, or lavapipe ends the
    /// loops of an invocation without a word.
    pub resolution: u32,
    /// Cells along a face's edge of the convolved maps.
    pub cells: u32,
}
