//! What a caller should hear of though nothing failed.

use interreflect_gpu::GpuError;

/// A remark on what runs.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Warning {
    /// Every estimate will be black.
    #[error("{scene}: nothing in it sends light; add a light, an emission or --environment FILE")]
    NoLight {
        /// The scene.
        scene: String,
    },
    /// The CPU runs alone though both backends were asked for.
    #[error("no GPU runs: {0}")]
    NoGpu(GpuError),
}
