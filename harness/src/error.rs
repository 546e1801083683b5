//! What can go wrong, and with which exit code the program ends.

use crate::campaign::JournalError;
use crate::output::{OutputError, TevError};
use crate::report::ReportError;
use interreflect_cpu::scene::CpuError;
use interreflect_cpu::tiles::CpuCxError;
use interreflect_estimators::{EstimatorError, UnknownEstimator, Unsupported};
use interreflect_gpu::GpuError;
use interreflect_scene::SceneError;
use interreflect_scene::params::ParamError;

/// An error of the harness.
#[derive(Debug, thiserror::Error)]
pub enum HarnessError {
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
    /// The command asks for what can't be done.
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
    Metrics(#[from] crate::metrics::MetricsError),
    /// A file can't be read or written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Standard output can't be written.
    #[error("standard output can't be written: {0}")]
    Print(#[from] std::io::Error),
    /// Some runs failed; the rest is reported.
    #[error("{failed} of {runs} runs failed: {first}")]
    Failed {
        /// Runs that failed.
        failed: usize,
        /// All runs.
        runs: usize,
        /// Why the first one did.
        first: String,
    },
    /// Some checks failed; all of them are reported.
    #[error("{failed} of {checks} checks failed")]
    Falsified {
        /// Checks that failed.
        failed: usize,
        /// All that were carried out.
        checks: usize,
    },
    /// Images can't be shown in tev.
    #[error(transparent)]
    Tev(#[from] TevError),
    /// The journal of a sweep can't be used.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// The report can't be made.
    #[error(transparent)]
    Report(#[from] ReportError),
}

impl HarnessError {
    /// 2 for bad usage or input, 1 for anything else.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Scene(_)
            | Self::Param { .. }
            | Self::UnknownEstimator(_)
            | Self::Usage(_)
            | Self::Journal(_)
            | Self::Unsupported(_)
            | Self::CpuCx(CpuCxError::Lacking(_))
            | Self::Cpu(_)
            | Self::Tev(TevError::Connect { .. })
            | Self::Report(ReportError::Output(
                OutputError::Read { .. } | OutputError::NoResults { .. },
            ))
            | Self::Output(OutputError::Read { .. } | OutputError::NoResults { .. })
            | Self::Gpu(GpuError::UnknownAdapter { .. } | GpuError::TooManyLights { .. })
            | Self::Estimator(EstimatorError::Unsupported(_) | EstimatorError::Point(_)) => 2,
            _ => 1,
        }
    }
}
