//! What can go wrong while an estimator runs.

use interreflect_gpu::GpuError;
use interreflect_scene::{CubeSpec, PointError, RsmSpec};

/// Why a method can't run as asked: a result to report, not a failure.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Unsupported(pub String);

/// An error while estimating.
#[derive(Debug, thiserror::Error)]
pub enum EstimatorError {
    /// A capture was read that `needs` had not declared.
    #[error("the method reads {0}, which its needs don't declare")]
    Undeclared(String),
    /// The harness did not provide a declared capture.
    #[error("{0} was declared, but not captured")]
    Missing(String),
    /// A point can't be shaded.
    #[error(transparent)]
    Point(#[from] PointError),
    /// The method can't run as asked.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// The GPU refused.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

impl EstimatorError {
    pub(crate) fn cube(spec: &CubeSpec) -> String {
        let c = spec.channels;
        let channels = [
            (c.radiance, "radiance"),
            (c.distance, "distance"),
            (c.normal, "normal"),
        ];
        let asked: Vec<_> = channels.iter().filter(|c| c.0).map(|c| c.1).collect();
        let bounces = match spec.bounces {
            0 => String::new(),
            k => format!(" with {k} bounces"),
        };
        format!("a cube of {0}x{0} {1}{bounces}", spec.size, asked.join("+"))
    }

    pub(crate) fn rsm(spec: &RsmSpec) -> String {
        let c = spec.channels;
        let channels = [
            (true, "position"),
            (c.radiance, "radiance"),
            (c.normal, "normal"),
            (c.true_colors, "true colours"),
        ];
        let asked: Vec<_> = channels.iter().filter(|c| c.0).map(|c| c.1).collect();
        format!("an RSM of {0}x{0} {1}", spec.size, asked.join("+"))
    }
}
