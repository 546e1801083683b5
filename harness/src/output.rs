//! Files that a run leaves: written whole or not at all.

mod error_map;
mod image;

pub use self::error_map::{ErrorMap, colour_stops, error_range};
pub use self::image::{Exposure, HdrImage};

use ::exr::prelude as exr;
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

/// Writes an image as OpenEXR with channels R, G, B in 32-bit floating point, losslessly packed.
///
/// # Errors
/// [`OutputError`] if the image can't be encoded or the file can't be written.
pub fn write_exr(path: &Path, image: &HdrImage) -> Result<(), OutputError> {
    use exr::WritableImage as _;
    let pixel = |p: exr::Vec2<usize>| image.get(p.x(), p.y()).into();
    let channels = exr::SpecificChannels::rgb(|p| -> (f32, f32, f32) { pixel(p) });
    let size = (image.width, image.height);
    let encoding = exr::Encoding::SMALL_LOSSLESS;
    let layer = exr::Layer::new(size, exr::LayerAttributes::default(), encoding, channels);
    let mut bytes = io::Cursor::new(Vec::new());
    exr::Image::from_layer(layer)
        .write()
        .to_buffered(&mut bytes)
        .map_err(|e| OutputError::Encode {
            path: path.into(),
            reason: e.to_string(),
        })?;
    write_atomically(path, bytes.get_ref())
}

/// Reads the first RGB layer of an OpenEXR file.
///
/// # Errors
/// [`OutputError::Read`] if the file is missing, is not OpenEXR, has no RGB channels or uses a
/// compression that is not supported.
pub fn read_exr(path: &Path) -> Result<HdrImage, OutputError> {
    use exr::{ReadChannels as _, ReadLayers as _};
    let read = exr::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| HdrImage::new(size.width(), size.height()),
            |image: &mut HdrImage, p, (r, g, b): (f32, f32, f32)| {
                image.set(p.x(), p.y(), glam::Vec3::new(r, g, b));
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_file(path);
    match read {
        Ok(read) => Ok(read.layer_data.channel_data.pixels),
        Err(e) => Err(OutputError::Read {
            path: path.into(),
            reason: e.to_string(),
        }),
    }
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
}

#[cfg(test)]
mod tests;
