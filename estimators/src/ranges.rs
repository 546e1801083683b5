//! Ranges and defaults that several methods' parameters share.

/// Most texels along a face's edge that shading sums over.
///
/// It keeps the loops of a shader invocation below 65,536 turns together: lavapipe ends them there
/// without a word.
pub(crate) const MAX_RESOLUTION: u32 = 64;

/// Least texels along a face's edge that a convolution sums over, for the same reason: fewer are
/// summed from more captured texels.
pub(crate) const MIN_CONVOLUTION_RESOLUTION: u32 = 8;

/// Most texels along a face's edge when the environment is captured.
pub(crate) const MAX_CAPTURE_RESOLUTION: u32 = 1024;

/// Most reflections in the captured radiance beyond that of direct light.
pub(crate) const MAX_BOUNCES: u32 = 8;

/// Farthest from the captures' place, in metres, that a reference point may keep them.
pub(crate) const MAX_RECAPTURE_DISTANCE_M: f32 = 1000.0;

/// Most cells along a face's edge of a convolved map.
pub(crate) const MAX_MAP_RESOLUTION: u32 = 256;

/// f_λ where nothing is said: between glass (0.04) and metals (0.5 to 1).
pub(crate) const F_LAMBDA: f32 = 0.2;
