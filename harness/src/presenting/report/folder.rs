//! A report from the files that a bench left.

use super::{ImageRow, LabelledImage, Report};
use crate::domain::record::Run;
use crate::presenting::error::PresentError;
use crate::presenting::gallery::{TRUTH, folder_of};
use crate::presenting::output::{read_labelled_exr, read_results};
use std::path::Path;

impl Report {
    /// The report of a folder that `bench` wrote: its results and the linear images beside them.
    ///
    /// # Errors
    /// [`PresentError`] if the results, or an image that they name, can't be read.
    pub fn of_folder(folder: &Path) -> Result<Self, PresentError> {
        let results = read_results(folder)?;
        let mut rows: Vec<ImageRow> = Vec::new();
        for (index, run) in results.runs.iter().enumerate() {
            let Some(file) = &run.image else { continue };
            let of_run = |row: &ImageRow| row.scene == run.scene && row.quantity == run.quantity;
            let at = match rows.iter().position(of_run) {
                Some(at) => at,
                None => {
                    rows.push(begun(folder, run)?);
                    rows.len() - 1
                }
            };
            rows[at].estimates.push(LabelledImage {
                label: run.label(),
                note: run.backend.to_string(),
                run: Some(index),
                image: read_labelled_exr(&folder.join(file))?.image,
            });
        }
        Ok(Self::new(&results, rows))
    }
}

/// The row of a run's scene and quantity with the truth alone.
fn begun(folder: &Path, run: &Run) -> Result<ImageRow, PresentError> {
    let path = folder
        .join(folder_of(&run.scene, &run.quantity))
        .join(TRUTH);
    let truth = read_labelled_exr(&path)?;
    Ok(ImageRow {
        scene: run.scene.clone(),
        quantity: run.quantity.clone(),
        reference: LabelledImage {
            label: "truth".into(),
            note: truth.header.get("reference").unwrap_or_default().into(),
            run: None,
            image: truth.image,
        },
        estimates: Vec::new(),
        surfaces: Some(truth.surfaces),
    })
}
