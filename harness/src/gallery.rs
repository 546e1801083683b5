//! The images of a bench: references and estimates side by side.

use crate::output::{ErrorMap, Exposure, Header, OutputError, error_range};
use crate::output::{write_error_map, write_exr, write_png, write_rgba};
use crate::record::{ParamMap, Run};
use crate::report::{ImageRow, LabelledImage};
use crate::view::View;
use image::{Rgba, RgbaImage, imageops};
use interreflect_conformance::own_model::ModelValues;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;
use std::path::{Path, PathBuf};

/// Name of the file that holds a row's truth.
pub(crate) const TRUTH: &str = "truth.exr";

/// Rows of images, one per scene and quantity. Linear images are written as they come, so that a
/// bench that was stopped leaves what it had; what has to know the whole row follows at the end.
#[derive(Default)]
pub(crate) struct Gallery {
    /// The folder of the results; without one, no images are kept.
    folder: Option<PathBuf>,
    /// What all images have in common.
    header: Header,
    rows: Vec<ImageRow>,
    /// Names of the last row's files, each with the parameters that it stands for.
    stems: Vec<(String, ParamMap)>,
}

impl Gallery {
    /// A gallery without rows, in the folder of the results.
    pub(crate) fn new(folder: &Path, header: Header) -> Self {
        Self {
            folder: Some(folder.into()),
            header,
            ..Self::default()
        }
    }

    /// Begins the row of a scene and quantity with the truth.
    ///
    /// # Errors
    /// [`OutputError`] if its file can't be written.
    pub(crate) fn begin(
        &mut self,
        scene: &str,
        quantity: Quantity,
        view: &View,
        truth: &ModelValues,
    ) -> Result<(), OutputError> {
        let Some(folder) = &self.folder else {
            return Ok(());
        };
        self.stems.clear();
        let row = ImageRow {
            scene: scene.into(),
            quantity: quantity.name().into(),
            reference: LabelledImage {
                label: "truth".into(),
                note: truth.description.clone(),
                run: None,
                image: view.image(&truth.values),
            },
            estimates: Vec::new(),
            surfaces: Some(view.surfaces()),
        };
        let header = self.header.clone();
        write_exr(
            &folder.join(folder_of(scene, quantity.name())).join(TRUTH),
            &row.reference.image,
            row.surfaces.as_deref(),
            &header
                .of_quantity(scene, quantity.name())
                .with("reference", &truth.description),
        )?;
        self.rows.push(row);
        Ok(())
    }

    /// Adds the estimate of run number `index` to the row that was begun last, and tells the run
    /// where its image is.
    ///
    /// # Errors
    /// [`OutputError`] if the image can't be written.
    pub(crate) fn add(
        &mut self,
        index: usize,
        run: &mut Run,
        view: &View,
        estimate: &Estimate,
    ) -> Result<(), OutputError> {
        let (Some(folder), Some(row)) = (&self.folder, self.rows.last_mut()) else {
            return Ok(());
        };
        let stem = new_stem(&mut self.stems, run);
        let file = format!("{}/{stem}.exr", folder_of(&row.scene, &row.quantity));
        let image = view.image(estimate);
        let header = self.header.clone().of_run(run);
        write_exr(
            &folder.join(&file),
            &image,
            row.surfaces.as_deref(),
            &header,
        )?;
        run.image = Some(file);
        row.estimates.push(LabelledImage {
            label: run.label(),
            note: run.backend.to_string(),
            run: Some(index),
            image,
        });
        Ok(())
    }

    /// Writes every image and every map of signed errors as PNG beside the linear images, and for
    /// each scene and quantity an overview of them all.
    ///
    /// # Errors
    /// [`OutputError`] if a file can't be written.
    pub(crate) fn finish(self, runs: &[Run]) -> Result<Vec<ImageRow>, OutputError> {
        let Some(folder) = &self.folder else {
            return Ok(self.rows);
        };
        for row in &self.rows {
            let exposure = Exposure::of(&row.reference.image);
            let surface = |i: usize| row.surfaces.as_ref().is_none_or(|s| s[i]);
            let maps: Vec<_> = row
                .estimates
                .iter()
                .filter_map(|e| ErrorMap::new(&e.image, &row.reference.image, surface))
                .collect();
            let range = error_range(&maps);
            let files = folder.join(folder_of(&row.scene, &row.quantity));
            let truth = files.join(TRUTH).with_extension("png");
            write_png(&truth, &row.reference.image, exposure)?;
            for (picture, map) in row.estimates.iter().zip(&maps) {
                let run = picture.run.and_then(|index| runs.get(index));
                if let Some(file) = run.and_then(|run| run.image.as_ref()) {
                    let file = folder.join(file);
                    write_png(&file.with_extension("png"), &picture.image, exposure)?;
                    write_error_map(&file.with_extension("error.png"), map, range)?;
                }
            }
            write_rgba(
                &files.join("overview.png"),
                &overview(row, &maps, exposure, range),
            )?;
        }
        Ok(self.rows)
    }
}

/// The folder of the images of a scene and quantity, relative to that of the results.
pub(crate) fn folder_of(scene: &str, quantity: &str) -> String {
    format!("images/{scene}/{quantity}")
}

/// A file name for a run that none of its row has: method and backend, and what differs from the first
/// such run's parameters.
fn new_stem(stems: &mut Vec<(String, ParamMap)>, run: &Run) -> String {
    let plain = format!("{}-{}", run.label().replace(", ", "-"), run.backend);
    let mut stem = plain.clone();
    if let Some((_, first)) = stems.iter().find(|(stem, _)| *stem == plain) {
        for (name, value) in run
            .params
            .0
            .iter()
            .filter(|p| first.get(&p.0) != Some(&p.1))
        {
            stem += &format!("-{name}={value}");
        }
    }
    let taken = |stem: &str| stems.iter().any(|(other, _)| other == stem);
    let numbered = (2..).map(|n| format!("{stem}-{n}"));
    let mut candidates = std::iter::once(stem.clone()).chain(numbered);
    let free = candidates.find(|c| !taken(c)).unwrap_or(stem);
    stems.push((free.clone(), run.params.clone()));
    free
}

/// All images of a row, truth first, each estimate above its map of signed errors, in as many lines as
/// are needed.
fn overview(row: &ImageRow, maps: &[ErrorMap], exposure: Exposure, range: f32) -> RgbaImage {
    const GAP: u32 = 4;
    const COLUMNS: usize = 12;
    let (w, h) = (
        row.reference.image.width as u32,
        row.reference.image.height as u32,
    );
    let count = 1 + row.estimates.len();
    let (columns, lines) = (count.min(COLUMNS) as u32, count.div_ceil(COLUMNS) as u32);
    let white = Rgba([255; 4]);
    let size = (columns * (w + GAP) - GAP, lines * 2 * (h + GAP) - GAP);
    let mut sheet = RgbaImage::from_pixel(size.0, size.1, white);
    let place = |sheet: &mut RgbaImage, picture: &RgbaImage, index: usize, below: u32| {
        let (column, line) = ((index % COLUMNS) as u32, (index / COLUMNS) as u32);
        let (x, y) = (column * (w + GAP), (2 * line + below) * (h + GAP));
        imageops::replace(sheet, picture, i64::from(x), i64::from(y));
    };
    let pictures = std::iter::once(&row.reference).chain(&row.estimates);
    for (i, picture) in pictures.enumerate() {
        place(&mut sheet, &picture.image.tone_mapped(exposure), i, 0);
    }
    for (i, map) in maps.iter().enumerate() {
        place(&mut sheet, &map.coloured(range), i + 1, 1);
    }
    sheet
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Backend;
    use interreflect_scene::params::Value;

    #[test]
    fn runs_that_differ_in_a_parameter_have_files_of_their_own() {
        let run = |resolution: u32| Run {
            fidelity: Some("corrected".into()),
            params: [
                ("resolution", Value::U32(resolution)),
                ("rays", Value::U32(9)),
            ]
            .into_iter()
            .collect(),
            ..Run::new("box", "texels", Backend::Gpu, "irradiance")
        };
        let mut stems = Vec::new();
        let names: Vec<_> = [4, 8, 16, 8]
            .map(|r| new_stem(&mut stems, &run(r)))
            .into_iter()
            .collect();
        assert_eq!(
            names,
            [
                "texels-corrected-gpu",
                "texels-corrected-gpu-resolution=8",
                "texels-corrected-gpu-resolution=16",
                "texels-corrected-gpu-resolution=8-2",
            ]
        );
    }
}
