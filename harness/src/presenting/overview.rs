//! The images of a campaign as pictures: references and estimates side by side.

use super::gallery::{TRUTH, folder_of};
use super::output::{ErrorMap, error_range, write_error_map, write_png, write_rgba};
use super::report::ImageRow;
use crate::domain::files::FileError;
use crate::domain::image::Exposure;
use crate::domain::record::Run;
use image::{Rgba, RgbaImage, imageops};
use std::path::{Path, PathBuf};

/// Writes every image and every map of signed errors as PNG beside the linear images, and for each scene
/// and quantity an overview of them all: what has to know the whole row.
///
/// # Errors
/// [`FileError`] if a file can't be written.
pub(crate) fn write_pictures(
    folder: &Path,
    rows: &[ImageRow],
    runs: &[Run],
) -> Result<(), FileError> {
    for row in rows {
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
                let stem = folder.join(file.trim_end_matches(".exr"));
                let with = |end: &str| PathBuf::from(format!("{}{end}", stem.display()));
                write_png(&with(".png"), &picture.image, exposure)?;
                write_error_map(&with(".error.png"), map, range)?;
            }
        }
        let sheet = overview(row, &maps, exposure, range);
        write_rgba(&files.join("overview.png"), &sheet)?;
    }
    Ok(())
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
