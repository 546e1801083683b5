//! The images of a bench: references and estimates side by side.

use crate::error::HarnessError;
use crate::output::{ErrorMap, Exposure, error_range};
use crate::output::{write_error_map, write_exr, write_png, write_rgba};
use crate::record::Run;
use crate::report::{ImageRow, LabelledImage};
use crate::view::View;
use image::{Rgba, RgbaImage, imageops};
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
    /// scene and quantity, with an overview of them all.
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
            write_rgba(
                &folder.join("overview.png"),
                &overview(row, &maps, exposure, range),
            )?;
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

/// All images of a row side by side, truth first, each estimate above its map of signed errors.
fn overview(row: &ImageRow, maps: &[ErrorMap], exposure: Exposure, range: f32) -> RgbaImage {
    const GAP: u32 = 4;
    let (w, h) = (
        row.reference.image.width as u32,
        row.reference.image.height as u32,
    );
    let count = 1 + row.estimates.len() as u32;
    let white = Rgba([255; 4]);
    let mut sheet = RgbaImage::from_pixel(count * (w + GAP) - GAP, 2 * h + GAP, white);
    let place = |sheet: &mut RgbaImage, picture: &RgbaImage, column: usize, line: u32| {
        let (x, y) = (column as u32 * (w + GAP), line * (h + GAP));
        imageops::replace(sheet, picture, i64::from(x), i64::from(y));
    };
    let pictures = std::iter::once(&row.reference).chain(&row.estimates);
    for (column, picture) in pictures.enumerate() {
        place(&mut sheet, &picture.image.tone_mapped(exposure), column, 0);
    }
    for (i, map) in maps.iter().enumerate() {
        place(&mut sheet, &map.coloured(range), i + 1, 1);
    }
    sheet
}
