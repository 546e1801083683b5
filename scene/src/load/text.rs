//! Lines of keyword and values, as OBJ and MTL files have them.

use crate::{Place, SceneError};
use std::path::Path;

/// Reads a text file; bytes that are no UTF-8 (in comments and names of old exporters) become �.
pub(super) fn read(path: &Path) -> Result<String, SceneError> {
    let bytes = std::fs::read(path).map_err(|source| SceneError::Read {
        path: path.into(),
        source,
    })?;
    let bytes = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&bytes);
    Ok(String::from_utf8_lossy(bytes).into_owned())
}

/// One line that is neither empty nor a comment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'a> {
    path: &'a Path,
    number: usize,
    /// The line without the spaces around it.
    pub(super) text: &'a str,
    /// Its first word.
    pub(super) keyword: &'a str,
    /// What follows the keyword.
    pub(super) rest: &'a str,
}

/// The lines that are neither empty nor comments.
pub(super) fn lines<'a>(path: &'a Path, content: &'a str) -> impl Iterator<Item = Line<'a>> {
    content.lines().enumerate().filter_map(move |(i, text)| {
        let text = text.trim();
        let end = text.find(char::is_whitespace).unwrap_or(text.len());
        let (keyword, rest) = (&text[..end], text[end..].trim_start());
        (!text.is_empty() && !text.starts_with('#')).then_some(Line {
            path,
            number: i + 1,
            text,
            keyword,
            rest,
        })
    })
}

impl Line<'_> {
    /// Where the line stands.
    pub(super) fn place(&self) -> Place {
        Place::line(self.path, self.number)
    }

    /// An error at this line.
    pub(super) fn error(
        &self,
        what: impl std::fmt::Display,
        remedy: impl std::fmt::Display,
    ) -> SceneError {
        self.place().error(what, remedy)
    }

    /// The first `N` values, which must be finite numbers.
    pub(super) fn numbers<const N: usize>(&self) -> Result<[f32; N], SceneError> {
        let mut words = self.rest.split_ascii_whitespace();
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            let Some(word) = words.next() else {
                let count = self.rest.split_ascii_whitespace().count();
                let what = format!("`{}` needs {N} value(s) and has {count}", self.keyword);
                return Err(self.error(what, "add the missing ones"));
            };
            *number = self.number(word)?;
        }
        Ok(numbers)
    }

    /// A value, which must be a finite number.
    pub(super) fn number(&self, word: &str) -> Result<f32, SceneError> {
        match word.parse::<f32>() {
            Ok(v) if v.is_finite() => Ok(v),
            Ok(_) => Err(self.error(
                format!("`{word}` is not finite"),
                "use finite numbers of at most 3e38",
            )),
            Err(_) => Err(self.error(format!("`{word}` is not a number"), "give a number")),
        }
    }
}
