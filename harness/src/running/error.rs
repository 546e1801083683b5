//! What can go wrong while methods run.

use crate::domain::files::FileError;
use crate::domain::metrics::MetricsError;
use interreflect_cpu::scene::CpuError;
use interreflect_cpu::tiles::CpuCxError;
use interreflect_estimators::{EstimatorError, UnknownEstimator, Unsupported};
use interreflect_gpu::GpuError;
use interreflect_scene::SceneError;
use interreflect_scene::params::ParamError;
use std::path::PathBuf;

/// Why methods could not be run.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The scene, its settings, its files or a point list can't be used.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A parameter was refused.
    #[error("{estimator}: {error}")]
    Param {
        /// The estimator that it was meant for.
        estimator: String,
        /// Why.
        error: ParamError,
    },
    /// No method has this id.
    #[error(transparent)]
    UnknownEstimator(#[from] UnknownEstimator),
    /// The request contradicts itself, or asks for what can't be done.
    #[error("{0}")]
    Usage(String),
    /// The method can't do what was asked.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// The CPU backend can't be set up.
    #[error(transparent)]
    CpuCx(#[from] CpuCxError),
    /// The CPU backend refuses the scene.
    #[error(transparent)]
    Cpu(#[from] CpuError),
    /// The GPU backend refuses.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// An estimator failed.
    #[error(transparent)]
    Estimator(#[from] EstimatorError),
    /// An estimate can't be compared.
    #[error(transparent)]
    Metrics(#[from] MetricsError),
    /// A file can't be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The journal of a sweep can't be used.
    #[error(transparent)]
    Journal(#[from] JournalError),
}

/// Why a journal can't be used.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    /// Another process writes to it.
    #[error("{}: another sweep is writing here; wait for it, or give another --out", path.display())]
    InUse {
        /// The file.
        path: PathBuf,
    },
    /// It can't be read.
    #[error("{}: {source}; name the --out folder of a sweep", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A line is not what a sweep writes.
    #[error("{}, line {number}: {source}; delete the line; its task then runs again", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// Number of the line, from 1.
        number: usize,
        /// Why.
        source: serde_json::Error,
    },
    /// It can't be written.
    #[error(transparent)]
    Write(#[from] FileError),
}
