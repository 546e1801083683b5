//! The GPU backend: wgpu context, passes, timestamps, read-back and captures.
//!
//! Everything runs on a [`GpuContext`]. Work is recorded by [`GpuContext::record`], which says how
//! long it took; what the device refuses in it is a [`GpuError`], never a panic.

mod adapter;
mod buffers;
mod capture;
mod coarse;
mod context;
mod cube;
mod cx;
mod direct;
mod error;
mod kernel;
pub mod layout;
#[cfg(test)]
mod layout_tests;
mod lights;
mod pipeline;
mod points;
mod readback;
mod rsm;
mod scene;
mod shader;
mod timestamps;
pub mod wgsl;

pub use adapter::{AdapterInfo, adapters};
pub use capture::cube::capture_cube;
pub use capture::directional_depth::{
    DEPTH_MAPS_AT_ONCE, GpuDepthMaps, GpuDirectionalDepths, GpuOccluders, QUERIED_AT_ONCE,
};
pub use capture::rsm::{MAX_MIRRORED_TRIANGLES, capture_rsms};
pub use coarse::GpuCoarseIrradiance;
pub use context::GpuContext;
pub use cube::GpuCube;
pub use cx::GpuCx;
pub use direct::direct_light;
pub use error::GpuError;
pub use kernel::{Binding, Kernel};
pub use lights::MAX_LIGHTS;
pub use pipeline::{CacheStats, Constants};
pub use points::{GpuEstimate, GpuPoints, workgroup_grid};
pub use rsm::GpuRsm;
pub use scene::GpuScene;
pub use shader::{Shader, validate};
pub use timestamps::{GpuTime, Mistimed};

/// Every shader of this crate.
pub fn shaders() -> [Shader; 5] {
    [
        capture::cube::SHADER,
        capture::shadow::SHADER,
        capture::directional_depth::SHADER,
        capture::rsm::SHADER,
        direct::SHADER,
    ]
}
