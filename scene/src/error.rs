//! Why a scene, an image or a point list was refused.

use crate::params::ParamError;
use std::fmt;
use std::path::{Path, PathBuf};

/// A file, and a line of it where one is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file as it was asked for.
    pub file: PathBuf,
    /// Line, counted from 1.
    pub line: Option<usize>,
}

impl Place {
    /// A whole file.
    pub fn file(path: &Path) -> Self {
        Self {
            file: path.into(),
            line: None,
        }
    }

    /// A line of a file, counted from 1.
    pub fn line(path: &Path, line: usize) -> Self {
        Self {
            file: path.into(),
            line: Some(line),
        }
    }

    /// An error at this place: what is wrong with which value, and what to do. Line breaks in
    /// either text become spaces, so that every error is one line.
    pub fn error(self, what: impl fmt::Display, remedy: impl fmt::Display) -> SceneError {
        let one_line = |text: String| text.split_whitespace().collect::<Vec<_>>().join(" ");
        SceneError::Malformed {
            place: self,
            what: one_line(what.to_string()),
            remedy: one_line(remedy.to_string()),
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        match self.line {
            Some(line) => write!(f, ":{line}"),
            None => Ok(()),
        }
    }
}

/// Why a scene, an image or a point list was refused: one line that says where, what and what to
/// do.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// A file can't be read.
    #[error("{}: {source}; check the path and its permissions", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file says something that can't be used.
    #[error("{place}: {what}; {remedy}")]
    Malformed {
        /// Where.
        place: Place,
        /// What is wrong with which value.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// Neither a scene of the library nor a scene file.
    #[error("there is no scene `{name}`{hint}; use one of {known}, or a .toml or .obj file")]
    UnknownScene {
        /// The name as given.
        name: String,
        /// ", did you mean …?" or "".
        hint: String,
        /// The library's scenes.
        known: String,
    },
    /// Neither a built-in receiver nor a mesh file.
    #[error("there is no receiver `{name}`; use one of {known}, or an .obj file")]
    UnknownReceiver {
        /// The name as given.
        name: String,
        /// The built-in receivers.
        known: String,
    },
    /// A scene setting was refused.
    #[error("scene setting: {0}")]
    Setting(#[from] ParamError),
    /// A scene contradicts itself.
    #[error("scene `{scene}`: {what}; {remedy}")]
    Inconsistent {
        /// The scene.
        scene: String,
        /// What is wrong.
        what: String,
        /// What to do.
        remedy: String,
    },
}
