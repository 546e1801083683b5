//! The averaging on the GPU.

use crate::{EstimatorError, Frame, Gpu};
use interreflect_gpu::{Binding, GpuCube, Shader, wgsl};
use interreflect_scene::CubeSpec;
use interreflect_scene::conventions::CUBE_FACES;

/// One invocation sums what one averaged texel covers.
pub const AVERAGE: Shader = Shader {
    label: "average of a captured cube",
    parts: &[wgsl::CUBE, include_str!("average.wgsl")],
};

/// As `Average` in average.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Average {
    pub(super) resolution: u32,
    pub(super) size: u32,
    pub(super) border: u32,
    pub(super) pad: u32,
}

/// Where an averaged cube goes.
pub struct Target<'a> {
    /// One `vec4f` for each texel of each face, those of the border included.
    pub buffer: &'a wgpu::Buffer,
    /// Texels along a face's edge.
    pub resolution: u32,
    /// Texels of border around each face, which are left as they are.
    pub border: u32,
}

/// Records the averaging of a declared capture, whose texels count by `weights` (one for each
/// texel of a face).
pub fn record_average(
    frame: &mut Frame<'_, Gpu>,
    spec: &CubeSpec,
    weights: &wgpu::Buffer,
    target: &Target<'_>,
) -> Result<(), EstimatorError> {
    let radiance = captured_radiance(frame.cube(spec)?)?;
    let average = Average {
        resolution: target.resolution,
        size: spec.size,
        border: target.border,
        pad: 0,
    };
    let average = frame.context().uniform("average", &average)?;
    let bindings = [
        (&average).into(),
        target.buffer.into(),
        radiance,
        weights.into(),
    ];
    let kernel = frame
        .context()
        .kernel(&AVERAGE, "average_radiance", &bindings)?;
    let texels = CUBE_FACES as u32 * target.resolution.pow(2);
    kernel.record(frame.cx, [texels.div_ceil(64), 1, 1]);
    Ok(())
}

/// The captured radiance as a binding, with distance in its fourth channel where that was captured.
///
/// # Errors
/// [`EstimatorError::Missing`] if the cube was captured without radiance.
pub fn captured_radiance(captured: &GpuCube) -> Result<Binding<'_>, EstimatorError> {
    let missing = || EstimatorError::Missing("the radiance of the captured cube".into());
    let radiance = captured.radiance_distance().ok_or_else(missing)?;
    Ok(radiance.into())
}
