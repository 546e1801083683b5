//! Files that a run leaves: written whole or not at all.

mod csv;
mod error_map;
mod exr;
mod image;
mod tev;

pub use self::csv::write_csv;
pub use self::error_map::{ErrorMap, NOTHING, STOPS, colour_stops, error_range};
pub(crate) use self::exr::unit;
pub use self::exr::{Header, Labelled, read_exr, read_labelled_exr, write_exr};
pub use self::image::{Exposure, HdrImage};
pub use self::tev::{Tev, TevError};

use crate::record::Results;
use std::{
    fs,
    io::{self, Write as _},
    path::{Path, PathBuf},
};

/// Writes a file through a temporary one in the same folder, which is created if it is missing: at
/// no time is there half a file under the final name.
///
/// # Errors
/// [`OutputError::Write`] with the path if the folder or the file can't be written.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    let write = || -> io::Result<()> {
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        let mut file = tempfile::Builder::new()
            .prefix(".partial-")
            .tempfile_in(folder)?;
        file.write_all(bytes)?;
        readable_like_any_other(file.as_file())?;
        file.persist(path)?;
        Ok(())
    };
    write().map_err(|source| OutputError::Write {
        path: path.into(),
        source,
    })
}

/// Temporary files are private to their owner; results are not.
#[cfg(unix)]
fn readable_like_any_other(file: &fs::File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt as _;
    file.set_permissions(fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable_like_any_other(_: &fs::File) -> io::Result<()> {
    Ok(())
}

/// Makes a folder and checks that files can be written there, before long work depends on it.
///
/// # Errors
/// [`OutputError::Write`] if it can't be made or written to.
pub fn ensure_writable(folder: &Path) -> Result<(), OutputError> {
    let refused = |source| OutputError::Write {
        path: folder.into(),
        source,
    };
    std::fs::create_dir_all(folder).map_err(refused)?;
    tempfile::tempfile_in(folder).map(drop).map_err(refused)
}

/// Writes a value as indented JSON with a final line break.
///
/// # Errors
/// [`OutputError::Write`] with the path if the file can't be written.
pub fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<(), OutputError> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(|e| OutputError::Write {
        path: path.into(),
        source: e.into(),
    })?;
    bytes.push(b'\n');
    write_atomically(path, &bytes)
}

/// Writes `results.json`, and `results.csv` with one line for each run, into a folder.
///
/// # Errors
/// [`OutputError`] if a file can't be written.
pub fn write_results(folder: &Path, results: &Results) -> Result<(), OutputError> {
    write_json(&folder.join(RESULTS), results)?;
    write_csv(&folder.join("results.csv"), &results.runs)
}

/// Name of the file that holds all results of a folder.
pub const RESULTS: &str = "results.json";

/// Reads the results that a folder holds.
///
/// # Errors
/// [`OutputError::NoResults`] with the file if there are none.
pub fn read_results(folder: &Path) -> Result<Results, OutputError> {
    let path = folder.join(RESULTS);
    let read = || -> io::Result<Results> { Ok(serde_json::from_slice(&fs::read(&path)?)?) };
    read().map_err(|source| OutputError::NoResults {
        path: path.clone(),
        source,
    })
}

/// Writes a tone-mapped image as PNG.
///
/// # Errors
/// [`OutputError`] if the image can't be encoded or the file can't be written.
pub fn write_png(path: &Path, image: &HdrImage, exposure: Exposure) -> Result<(), OutputError> {
    write_rgba(path, &image.tone_mapped(exposure))
}

/// Writes an 8-bit image as PNG.
///
/// # Errors
/// [`OutputError`] if the image can't be encoded or the file can't be written.
pub fn write_rgba(path: &Path, image: &::image::RgbaImage) -> Result<(), OutputError> {
    write_atomically(path, &encode_png(image, path)?)
}

/// Writes a map of signed errors as PNG, with a colour bar under it that states the range.
///
/// # Errors
/// [`OutputError`] if the image can't be encoded or the file can't be written.
pub fn write_error_map(path: &Path, map: &ErrorMap, range: f32) -> Result<(), OutputError> {
    write_rgba(path, &map.with_colour_bar(range))
}

/// Encodes an 8-bit image as PNG; `path` is the file or picture that an error names.
pub(crate) fn encode_png(image: &::image::RgbaImage, path: &Path) -> Result<Vec<u8>, OutputError> {
    let mut bytes = io::Cursor::new(Vec::new());
    match image.write_to(&mut bytes, ::image::ImageFormat::Png) {
        Ok(()) => Ok(bytes.into_inner()),
        Err(e) => Err(OutputError::Encode {
            path: path.into(),
            reason: e.to_string(),
        }),
    }
}

/// Why a file could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The file system refused.
    #[error("can't write {}: {source}; choose another folder with --out", path.display())]
    Write {
        /// The file's final name.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The image does not fit its format.
    #[error("can't encode {}: {reason}", path.display())]
    Encode {
        /// The file's final name.
        path: PathBuf,
        /// What the encoder said.
        reason: String,
    },
    /// The file is no image that can be read.
    #[error("can't read {} as an OpenEXR image with channels R, G, B: {reason}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the decoder said.
        reason: String,
    },
    /// The folder has no results that can be read.
    #[error(
        "can't read the results in {}: {source}; name a folder that `bench --out` wrote",
        path.display()
    )]
    NoResults {
        /// The file.
        path: PathBuf,
        /// What the system or the parser said.
        source: io::Error,
    },
}

#[cfg(test)]
mod tests;
