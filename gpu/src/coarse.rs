//! A coarse solution on the GPU.

use crate::{GpuContext, GpuError, GpuScene};
use bytemuck::{Pod, Zeroable};
use glam::Vec4;
use interreflect_scene::{CoarseIrradiance, coarse_irradiance};

/// The WGSL struct `Grid`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Grid {
    pub(crate) first: u32,
    pub(crate) cells: u32,
}

/// A [`CoarseIrradiance`] as captures read it: the grid of each drawn triangle, and the irradiance
/// on front and back of every vertex.
pub struct GpuCoarseIrradiance {
    pub(crate) bounces: u32,
    pub(crate) grids: wgpu::Buffer,
    pub(crate) values: wgpu::Buffer,
}

impl GpuCoarseIrradiance {
    /// Uploads the solution of the same scene.
    ///
    /// # Errors
    /// [`GpuError::CoarseIrradiance`] if a triangle has no grid: it is another scene's; or another
    /// [`GpuError`] if the device has no room.
    pub fn upload(
        context: &GpuContext,
        scene: &GpuScene,
        coarse: &CoarseIrradiance,
    ) -> Result<Self, GpuError> {
        let grid = |&triangle: &u32| {
            let grid = coarse.grids().get(triangle as usize);
            let grid = grid.ok_or(GpuError::CoarseIrradiance {
                what: "triangles",
                found: coarse.grids().len() as u32,
                expected: triangle + 1,
            })?;
            let &coarse_irradiance::Grid { first, cells } = grid;
            Ok(Grid { first, cells })
        };
        let mut grids = scene
            .triangles
            .iter()
            .map(grid)
            .collect::<Result<Vec<_>, GpuError>>()?;
        let sides = coarse.values().as_flattened().iter();
        let mut values: Vec<Vec4> = sides.map(|e| e.extend(0.0)).collect();
        if grids.is_empty() {
            // The shader's arrays have one element at least.
            grids.push(Grid::zeroed());
            values.push(Vec4::ZERO);
        }
        Ok(Self {
            bounces: coarse.bounces(),
            grids: context.storage("grids of the coarse solution", &grids)?,
            values: context.storage("irradiance of the coarse solution", &values)?,
        })
    }
}
