//! What a caller should hear of though nothing failed.

use interreflect_gpu::GpuError;

/// A remark on what runs.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Warning {
    /// Every estimate will be black.
    #[error("{scene}: no light source; add a light, an emission or --environment FILE")]
    NoLight {
        /// The scene.
        scene: String,
    },
    /// A method's two implementations do not agree.
    #[error(
        "{scene}: {label} estimates {quantity} on the GPU {percent:.1} % away from the CPU, more than \
         captures explain; `verify --estimator {estimator}` says where they part"
    )]
    BackendsApart {
        /// The scene.
        scene: String,
        /// Estimator and fidelity.
        label: String,
        /// The estimator.
        estimator: String,
        /// What is estimated.
        quantity: String,
        /// Mean difference over the mean estimate.
        percent: f64,
    },
    /// The CPU runs alone though both backends were asked for.
    #[error("the GPU backend is skipped: {0}")]
    NoGpu(GpuError),
}
