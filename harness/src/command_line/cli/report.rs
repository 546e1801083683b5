//! `interreflect report`, and where images can be shown.

use crate::presenting::output::{Tev, TevError};
use clap::Args;
use std::path::PathBuf;

/// `interreflect report`.
#[derive(Clone, Debug, PartialEq, Args)]
#[command(after_help = "Examples:\n  interreflect report results\n  \
interreflect report results --tev=localhost:14158")]
pub struct ReportCommand {
    /// Folder that `bench --out` wrote
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
    /// Where images are shown as well.
    #[command(flatten)]
    pub tev: TevOption,
}

/// An image viewer to show images in.
#[derive(Clone, Debug, Default, PartialEq, Args)]
pub struct TevOption {
    /// Send the ground truth and all estimates to a running tev (default: localhost:14158)
    #[arg(long, value_name = "HOST:PORT", num_args = 0..=1, require_equals = true)]
    #[arg(default_missing_value = Tev::ADDRESS)]
    pub tev: Option<String>,
}

impl TevOption {
    /// The connection, if one is asked for.
    ///
    /// # Errors
    /// [`TevError::Connect`] if no tev listens there.
    pub fn connect(&self) -> Result<Option<Tev>, TevError> {
        self.tev.as_deref().map(Tev::connect).transpose()
    }
}
