//! What ends a command, and with which exit code.

use crate::domain::files::FileError;
use crate::presenting::error::PresentError;
use crate::presenting::output::TevError;
use crate::running::error::{JournalError, RunError};
use interreflect_cpu::tiles::CpuCxError;
use interreflect_estimators::{EstimatorError, UnknownEstimator, Unsupported};
use interreflect_gpu::GpuError;
use interreflect_scene::SceneError;

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
pub enum CommandError {
    /// The command asks for what can't be done.
    #[error("{0}")]
    Usage(String),
    /// Methods could not be run.
    #[error(transparent)]
    Run(#[from] RunError),
    /// Results could not be shown.
    #[error(transparent)]
    Present(#[from] PresentError),
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
}

impl From<FileError> for CommandError {
    fn from(error: FileError) -> Self {
        RunError::from(error).into()
    }
}

impl From<JournalError> for CommandError {
    fn from(error: JournalError) -> Self {
        RunError::from(error).into()
    }
}

impl From<SceneError> for CommandError {
    fn from(error: SceneError) -> Self {
        RunError::from(error).into()
    }
}

impl From<GpuError> for CommandError {
    fn from(error: GpuError) -> Self {
        RunError::from(error).into()
    }
}

impl From<UnknownEstimator> for CommandError {
    fn from(error: UnknownEstimator) -> Self {
        RunError::from(error).into()
    }
}

impl From<EstimatorError> for CommandError {
    fn from(error: EstimatorError) -> Self {
        RunError::from(error).into()
    }
}

impl From<Unsupported> for CommandError {
    fn from(error: Unsupported) -> Self {
        RunError::from(error).into()
    }
}

impl From<TevError> for CommandError {
    fn from(error: TevError) -> Self {
        PresentError::from(error).into()
    }
}

impl CommandError {
    /// 2 for bad usage or input, 1 for anything else.
    pub fn exit_code(&self) -> u8 {
        let bad_input = match self {
            Self::Usage(_) => true,
            Self::Run(error) => refuses_input(error),
            Self::Present(PresentError::Tev(TevError::Connect { .. })) => true,
            Self::Present(PresentError::File(error)) => is_unreadable(error),
            _ => false,
        };
        if bad_input { 2 } else { 1 }
    }
}

fn refuses_input(error: &RunError) -> bool {
    match error {
        RunError::Scene(_)
        | RunError::Param { .. }
        | RunError::UnknownEstimator(_)
        | RunError::Usage(_)
        | RunError::Journal(_)
        | RunError::Unsupported(_)
        | RunError::CpuCx(CpuCxError::Lacking(_))
        | RunError::Cpu(_)
        | RunError::Gpu(GpuError::UnknownAdapter { .. } | GpuError::TooManyLights { .. })
        | RunError::Estimator(EstimatorError::Unsupported(_) | EstimatorError::Point(_)) => true,
        RunError::File(error) => is_unreadable(error),
        _ => false,
    }
}

/// A file that was named can't be read, as opposed to one that can't be written.
fn is_unreadable(error: &FileError) -> bool {
    matches!(error, FileError::Read { .. } | FileError::NoResults { .. })
}
