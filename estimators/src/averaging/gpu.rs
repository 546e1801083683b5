//! The averaging on the GPU.

use crate::{EstimatorError, Gpu, Inputs};
use interreflect_gpu::{GpuCx, Shader, wgsl};
use interreflect_scene::CubeSpec;
use interreflect_scene::conventions::CUBE_FACES;

/// One invocation sums what one averaged texel covers.
pub(crate) const AVERAGE: Shader = Shader {
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
pub(crate) struct Target<'a> {
    /// One `vec4f` for each texel of each face, those of the border included.
    pub(crate) buffer: &'a wgpu::Buffer,
    /// Texels along a face's edge.
    pub(crate) resolution: u32,
    /// Texels of border around each face, which are left as they are.
    pub(crate) border: u32,
}

/// Records the averaging of a declared capture, whose texels count by `weights` (one for each
/// texel of a face).
pub(crate) fn record_average(
    cx: &mut GpuCx,
    inputs: &Inputs<'_, Gpu>,
    spec: &CubeSpec,
    weights: &wgpu::Buffer,
    target: &Target<'_>,
) -> Result<(), EstimatorError> {
    let captured = inputs.cube(spec)?;
    let missing = || EstimatorError::Missing("the radiance of the captured cube".into());
    let radiance = captured.radiance_distance().ok_or_else(missing)?;
    let average = Average {
        resolution: target.resolution,
        size: spec.size,
        border: target.border,
        pad: 0,
    };
    let average = cx.context().uniform("average", &average)?;
    let bindings = [
        (&average).into(),
        target.buffer.into(),
        radiance.into(),
        weights.into(),
    ];
    let kernel = cx
        .context()
        .kernel(&AVERAGE, "average_radiance", &bindings)?;
    let texels = CUBE_FACES as u32 * target.resolution.pow(2);
    kernel.record(cx, [texels.div_ceil(64), 1, 1]);
    Ok(())
}
