//! What can go wrong while results are shown.

use super::output::TevError;
use crate::domain::files::FileError;

/// Why results could not be shown.
#[derive(Debug, thiserror::Error)]
pub enum PresentError {
    /// An image of a row has another size than the row's reference.
    #[error(
        "{scene}: `{label}` is {width} × {height} pixels, but its reference has another size; render both \
         at the same size"
    )]
    Size {
        /// The scene.
        scene: String,
        /// The image.
        label: String,
        /// Its width.
        width: usize,
        /// Its height.
        height: usize,
    },
    /// The file or one of the pictures can't be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A plot can't be drawn.
    #[error("can't draw a plot: {0}")]
    Plot(String),
    /// Images can't be shown in tev.
    #[error(transparent)]
    Tev(#[from] TevError),
    /// The template is at fault.
    #[error("can't lay out the report: {0}")]
    Template(#[from] minijinja::Error),
}
