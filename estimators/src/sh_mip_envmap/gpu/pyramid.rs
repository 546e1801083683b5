//! The box-filtered mip pyramid on the GPU.

use super::super::ShMipEnvmap;
use super::super::math::level_offset;
use super::super::tables::box_weights;
use super::LEAVES;
use crate::averaging::{Target, record_average};
use crate::{EstimatorError, Frame, Gpu};
use interreflect_gpu::{GpuContext, Kernel, Shader, wgsl};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::params::Fidelity;

pub(super) const PYRAMID: Shader = Shader {
    label: "sh_mip_envmap pyramid",
    parts: &[wgsl::CUBE, LEAVES, include_str!("../pyramid.wgsl")],
};

/// As `Reduce` in pyramid.wgsl.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
pub(super) struct Reduce {
    pub(super) base: u32,
    pub(super) size: u32,
    pub(super) first_weight: u32,
    pub(super) across: u32,
}

/// All levels with their borders, the finest first, and the kernels that fill them.
pub(super) struct Pyramid {
    pub(super) texels: wgpu::Buffer,
    /// Weights of a face's captured texels.
    captured_weights: wgpu::Buffer,
    /// The kernels with their numbers of invocations, in order.
    kernels: Vec<(Kernel, u32)>,
}

impl Pyramid {
    pub(super) fn new(method: &ShMipEnvmap, context: &GpuContext) -> Result<Self, EstimatorError> {
        let (base, faces) = (method.base_size(), CUBE_FACES as u32);
        let stored = level_offset(base, 1) + faces * 9;
        let texels = context.storage_zeroed("sh_mip_envmap pyramid", 16 * u64::from(stored))?;
        let mut weights = Vec::new();
        let mut levels = Vec::new();
        for level in 1..=method.top_level() {
            let size = base >> level;
            levels.push((size, weights.len() as u32));
            weights.extend(box_weights(method.fidelity, 2 * size));
        }
        let weights = context.storage("sh_mip_envmap box weights", &weights)?;
        let kernel = |entry, size, first_weight| {
            let reduce = Reduce {
                base,
                size,
                first_weight,
                across: u32::from(method.fidelity == Fidelity::Corrected),
            };
            let reduce = context.uniform("sh_mip_envmap level", &reduce)?;
            let bindings = [(&reduce).into(), (&texels).into(), (&weights).into()];
            context.kernel(&PYRAMID, entry, &bindings)
        };
        let mut kernels = Vec::new();
        for (size, first_weight) in levels {
            let invocations = faces * size * size;
            kernels.push((kernel("reduce_level", size, first_weight)?, invocations));
        }
        kernels.push((kernel("fill_borders", 1, 0)?, stored));
        let captured = box_weights(method.fidelity, method.captured().size);
        Ok(Self {
            captured_weights: context.storage("captured box weights", &captured)?,
            texels,
            kernels,
        })
    }

    /// Records averaging of the capture to the base, every other level, and all borders.
    pub(super) fn record(
        &self,
        method: &ShMipEnvmap,
        frame: &mut Frame<'_, Gpu>,
    ) -> Result<(), EstimatorError> {
        let target = Target {
            buffer: &self.texels,
            resolution: method.base_size(),
            border: 1,
        };
        let weights = &self.captured_weights;
        record_average(frame, &method.captured(), weights, &target)?;
        for (kernel, invocations) in &self.kernels {
            kernel.record(frame.cx, [invocations.div_ceil(64), 1, 1]);
        }
        Ok(())
    }
}
