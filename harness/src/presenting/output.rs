//! Files that a run leaves: results, and images as they are and as they are shown.

mod csv;
mod error_map;
mod exr;
mod tev;

pub use self::csv::write_csv;
pub use self::error_map::{ErrorMap, NOTHING, STOPS, colour_stops, error_range};
pub(crate) use self::exr::unit;
pub use self::exr::{Header, Labelled, read_exr, read_labelled_exr, write_exr};
pub use self::tev::{Tev, TevError};

use crate::domain::files::{FileError, write_atomically, write_json};
use crate::domain::image::{Exposure, HdrImage};
use crate::domain::record::Results;
use std::{fs, io, path::Path};

/// Writes `results.json`, and `results.csv` with one line for each run, into a folder.
///
/// # Errors
/// [`FileError`] if a file can't be written.
pub fn write_results(folder: &Path, results: &Results) -> Result<(), FileError> {
    write_json(&folder.join(RESULTS), results)?;
    write_csv(&folder.join("results.csv"), &results.runs)
}

/// Name of the file that holds all results of a folder.
pub const RESULTS: &str = "results.json";

/// Reads the results that a folder holds.
///
/// # Errors
/// [`FileError::NoResults`] with the file if there are none.
pub fn read_results(folder: &Path) -> Result<Results, FileError> {
    let path = folder.join(RESULTS);
    let read = || -> io::Result<Results> { Ok(serde_json::from_slice(&fs::read(&path)?)?) };
    read().map_err(|source| FileError::NoResults {
        path: path.clone(),
        source,
    })
}

/// Writes a tone-mapped image as PNG.
///
/// # Errors
/// [`FileError`] if the image can't be encoded or the file can't be written.
pub fn write_png(path: &Path, image: &HdrImage, exposure: Exposure) -> Result<(), FileError> {
    write_rgba(path, &image.tone_mapped(exposure))
}

/// Writes an 8-bit image as PNG.
///
/// # Errors
/// [`FileError`] if the image can't be encoded or the file can't be written.
pub fn write_rgba(path: &Path, image: &::image::RgbaImage) -> Result<(), FileError> {
    write_atomically(path, &encode_png(image, path)?)
}

/// Writes a map of signed errors as PNG, with a colour bar under it that states the range.
///
/// # Errors
/// [`FileError`] if the image can't be encoded or the file can't be written.
pub fn write_error_map(path: &Path, map: &ErrorMap, range: f32) -> Result<(), FileError> {
    write_rgba(path, &map.with_colour_bar(range))
}

/// Encodes an 8-bit image as PNG; `path` is the file or picture that an error names.
pub(crate) fn encode_png(image: &::image::RgbaImage, path: &Path) -> Result<Vec<u8>, FileError> {
    let mut bytes = io::Cursor::new(Vec::new());
    match image.write_to(&mut bytes, ::image::ImageFormat::Png) {
        Ok(()) => Ok(bytes.into_inner()),
        Err(e) => Err(FileError::Encode {
            path: path.into(),
            reason: e.to_string(),
        }),
    }
}

#[cfg(test)]
mod tests;
