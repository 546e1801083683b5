//! Files: written whole or not at all.

use std::{
    fs,
    io::{self, Write as _},
    path::{Path, PathBuf},
};

/// Writes a file through a temporary one in the same folder, which is created if it is missing: at
/// no time is there half a file under the final name.
///
/// # Errors
/// [`FileError::Write`] with the path if the folder or the file can't be written.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
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
    write().map_err(|source| FileError::Write {
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
/// [`FileError::Write`] if it can't be made or written to.
pub fn ensure_writable(folder: &Path) -> Result<(), FileError> {
    let refused = |source| FileError::Write {
        path: folder.into(),
        source,
    };
    std::fs::create_dir_all(folder).map_err(refused)?;
    tempfile::tempfile_in(folder).map(drop).map_err(refused)
}

/// Writes a value as indented JSON with a final line break.
///
/// # Errors
/// [`FileError::Write`] with the path if the file can't be written.
pub fn write_json(path: &Path, value: &impl serde::Serialize) -> Result<(), FileError> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(|e| FileError::Write {
        path: path.into(),
        source: e.into(),
    })?;
    bytes.push(b'\n');
    write_atomically(path, &bytes)
}

/// Why a file could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
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
