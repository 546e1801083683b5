//! The images of a bench: references and estimates side by side.

use crate::error::HarnessError;
use crate::output::{ErrorMap, Exposure, error_range};
use crate::output::{write_error_map, write_exr, write_png};
use crate::record::Run;
use crate::report::{ImageRow, LabelledImage};
use crate::view::View;
use interreflect_conformance::own_model::ModelValues;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;
use std::path::Path;

/// Rows of images, one per scene and quantity.
#[derive(Default)]
pub(crate) struct Gallery {
    rows: Vec<ImageRow>,
}

impl Gallery {
    /// Begins the row of a scene and quantity with the truth.
    pub(crate) fn begin(
        &mut self,
        scene: &str,
        quantity: Quantity,
        view: &View,
        truth: &ModelValues,
    ) {
        self.rows.push(ImageRow {
            scene: scene.into(),
            quantity: quantity.name().into(),
            reference: LabelledImage {
                label: "truth".into(),
                note: truth.description.clone(),
                image: view.image(&truth.values),
            },
            estimates: Vec::new(),
            surfaces: Some(view.surfaces()),
        });
    }

    /// Adds an estimate to the row that was begun last.
    pub(crate) fn add(&mut self, run: &Run, view: &View, estimate: &Estimate) {
        if let Some(row) = self.rows.last_mut() {
            row.estimates.push(LabelledImage {
                label: run.label(),
                note: run.backend.to_string(),
                image: view.image(estimate),
            });
        }
    }

    /// Writes every image as EXR and PNG, and every map of signed errors, into a folder for each
    /// scene and quantity.
    ///
    /// # Errors
    /// [`HarnessError`] if a file can't be written.
    pub(crate) fn write(&self, folder: &Path) -> Result<(), HarnessError> {
        for row in &self.rows {
            let folder = folder.join(&row.scene).join(&row.quantity);
            let exposure = Exposure::of(&row.reference.image);
            let surface = |i: usize| row.surfaces.as_ref().is_none_or(|s| s[i]);
            let maps: Vec<_> = row
                .estimates
                .iter()
                .filter_map(|e| ErrorMap::new(&e.image, &row.reference.image, surface))
                .collect();
            let range = error_range(&maps);
            for picture in std::iter::once(&row.reference).chain(&row.estimates) {
                let stem = file_stem(row, picture);
                write_exr(&folder.join(format!("{stem}.exr")), &picture.image)?;
                write_png(
                    &folder.join(format!("{stem}.png")),
                    &picture.image,
                    exposure,
                )?;
            }
            for (picture, map) in row.estimates.iter().zip(&maps) {
                let stem = file_stem(row, picture);
                write_error_map(&folder.join(format!("{stem}.error.png")), map, range)?;
            }
        }
        Ok(())
    }

    /// The rows, for a report.
    pub(crate) fn into_rows(self) -> Vec<ImageRow> {
        self.rows
    }
}

fn file_stem(row: &ImageRow, picture: &LabelledImage) -> String {
    let label = picture.label.replace(", ", "-").replace(' ', "_");
    match std::ptr::eq(picture, &row.reference) {
        true => label,
        false => format!("{label}-{}", picture.note),
    }
}
