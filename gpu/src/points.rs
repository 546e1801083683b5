//! Points and estimates on the GPU: the same bytes as on the host.

use crate::{Binding, GpuContext, GpuCx, GpuError};
use bytemuck::{Pod, Zeroable};
use interreflect_scene::{Estimate, LANES, PointLayout, Points};

/// Most workgroups along one axis of a dispatch, in WebGPU's default limits.
const MAX_WORKGROUPS: usize = 65535;

/// The WGSL struct `PointsInfo`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(crate) struct PointsInfo {
    pub(crate) count: u32,
    pub(crate) planes: u32,
}

/// A list of points in one storage buffer.
#[derive(Clone, Debug)]
pub struct GpuPoints {
    buffer: wgpu::Buffer,
    info: wgpu::Buffer,
    layout: PointLayout,
    len: usize,
}

/// An estimate in one storage buffer.
#[derive(Clone, Debug)]
pub struct GpuEstimate {
    buffer: wgpu::Buffer,
    len: usize,
}

impl GpuContext {
    /// Number of points of a layout that fit into one storage binding, and whose estimate does.
    pub fn max_points(&self, layout: PointLayout) -> usize {
        let planes = layout.planes().max(Estimate::PLANES);
        let block = planes * LANES * size_of::<f32>();
        let bytes = self.device().limits().max_storage_buffer_binding_size as usize;
        bytes / block * LANES
    }
}

impl GpuPoints {
    /// Uploads points.
    ///
    /// # Errors
    /// [`GpuError::TooManyPoints`] beyond [`GpuContext::max_points`], or if the device has no room.
    pub fn upload(context: &GpuContext, points: &Points) -> Result<Self, GpuError> {
        let max = context.max_points(points.layout());
        if points.len() > max {
            return Err(GpuError::TooManyPoints {
                points: points.len(),
                max,
            });
        }
        let info = PointsInfo {
            count: points.len() as u32,
            planes: points.layout().planes() as u32,
        };
        Ok(Self {
            buffer: context.storage("points", points.blocks())?,
            info: context.uniform("points info", &info)?,
            layout: points.layout(),
            len: points.len(),
        })
    }

    /// Which planes each block has.
    pub fn layout(&self) -> PointLayout {
        self.layout
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no points.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The bindings of slots 0, 1 and 2 of a shader with the part [`crate::wgsl::POINTS`].
    pub fn bindings<'a>(&'a self, estimate: &'a GpuEstimate) -> [Binding<'a>; 3] {
        [&self.buffer, &self.info, &estimate.buffer].map(Binding::Buffer)
    }

    /// The bindings of slots 0 and 1 alone, for shaders that write no estimate.
    pub fn inputs(&self) -> [Binding<'_>; 2] {
        [&self.buffer, &self.info].map(Binding::Buffer)
    }

    /// Workgroups of [`LANES`] lanes that cover all points; `point_index` of the part
    /// [`crate::wgsl::POINTS`] numbers them.
    pub fn workgroups(&self) -> [u32; 3] {
        workgroup_grid(self.len.div_ceil(LANES))
    }
}

/// Rows of as many workgroups as a dispatch may have along one axis; the last row may have some to
/// spare.
pub fn workgroup_grid(blocks: usize) -> [u32; 3] {
    let rows = blocks.div_ceil(MAX_WORKGROUPS);
    let columns = blocks.div_ceil(rows.max(1));
    [columns as u32, rows as u32, 1]
}

impl GpuEstimate {
    /// Zeros for `len` points.
    ///
    /// # Errors
    /// [`GpuError::BufferTooLarge`], or another [`GpuError`] if the device has no room.
    pub fn new(context: &GpuContext, len: usize) -> Result<Self, GpuError> {
        let block = Estimate::PLANES * LANES * size_of::<f32>();
        let bytes = len.div_ceil(LANES) * block;
        Ok(Self {
            buffer: context.storage_zeroed("estimate", bytes as u64)?,
            len,
        })
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no points.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Records that it is zero.
    pub(crate) fn clear(&self, cx: &mut GpuCx) {
        cx.encoder().clear_buffer(&self.buffer, 0, None);
    }

    /// Reads the estimate back.
    ///
    /// # Errors
    /// [`GpuError`] if the device fails.
    pub fn download(&self, context: &GpuContext) -> Result<Estimate, GpuError> {
        if self.is_empty() {
            return Ok(Estimate::new(0));
        }
        let blocks = context.read_buffer(&self.buffer)?;
        Estimate::from_blocks(self.len, blocks).ok_or_else(|| GpuError::Driver {
            what: "reading an estimate back".into(),
            reason: "the buffer has another length than it was made with".into(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workgroups_cover_all_blocks_within_the_limit() {
        assert_eq!(workgroup_grid(0), [0, 0, 1]);
        assert_eq!(workgroup_grid(65_535), [65_535, 1, 1]);
        for blocks in [1, 2, 65_536, 131_070, 131_071, 1_000_003] {
            let [columns, rows, layers] = workgroup_grid(blocks).map(|n| n as usize);
            assert!(columns <= MAX_WORKGROUPS && rows <= MAX_WORKGROUPS && layers == 1);
            let spare = columns * rows - blocks;
            assert!(spare < rows, "{spare} of {blocks} to spare");
        }
    }
}
