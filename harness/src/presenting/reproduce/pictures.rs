//! Rows of pictures as a page and as files.

use crate::domain::image::Exposure;
use crate::presenting::error::PresentError;
use crate::presenting::output::{
    ErrorMap, Header, encode_png, error_range, write_exr, write_png, write_rgba,
};
use crate::running::reproduce::Row;
use base64::{Engine as _, engine::general_purpose::STANDARD};
use image::{Rgba, RgbaImage, imageops};
use serde::Serialize;
use std::path::Path;

/// A row as a page shows it.
#[derive(Clone, Serialize)]
pub(super) struct Shown {
    title: String,
    pictures: Vec<Picture>,
    /// The range of the colours of the errors; `None` where there are none.
    range: Option<String>,
}

/// A picture with its words.
#[derive(Clone, Serialize)]
struct Picture {
    caption: String,
    uri: String,
    error_uri: Option<String>,
}

/// Pixels along a picture's longer side on a page, at least: smaller ones are enlarged to whole blocks.
const SHOWN: u32 = 180;

impl Row {
    fn exposure(&self) -> Exposure {
        let first = self.pictures.first();
        first.map_or(Exposure(1.0), |(_, image)| Exposure::of(image))
    }

    /// Errors of each picture after the first against it, and their common range.
    fn errors(&self) -> Option<(Vec<ErrorMap>, f32)> {
        let surfaces = self.errors_at.as_ref()?;
        let ((_, reference), others) = self.pictures.split_first()?;
        let at = |i: usize| surfaces.get(i) == Some(&true);
        let maps = others
            .iter()
            .filter_map(|(_, image)| ErrorMap::new(image, reference, at));
        let maps: Vec<_> = maps.collect();
        let range = error_range(&maps);
        Some((maps, range)).filter(|(maps, _)| !maps.is_empty())
    }

    /// Writes every picture as EXR and PNG, and an overview of the row, into a folder.
    pub(super) fn write(&self, folder: &Path) -> Result<(), PresentError> {
        let exposure = self.exposure();
        for (caption, image) in &self.pictures {
            let stem = file_name(&format!("{} {caption}", self.title));
            let header = Header::default().with("experiment", &self.title);
            let header = header.with("picture", caption);
            let surfaces = self.errors_at.as_deref();
            write_exr(
                &folder.join(format!("{stem}.exr")),
                image,
                surfaces,
                &header,
            )?;
            write_png(&folder.join(format!("{stem}.png")), image, exposure)?;
        }
        let overview = format!("{}-overview.png", file_name(&self.title));
        Ok(write_rgba(&folder.join(overview), &self.overview())?)
    }

    /// All pictures beside each other, the errors below.
    pub(super) fn overview(&self) -> RgbaImage {
        let (exposure, errors) = (self.exposure(), self.errors());
        let upper = self
            .pictures
            .iter()
            .map(|(_, image)| enlarged(image.tone_mapped(exposure)));
        let upper: Vec<_> = upper.collect();
        let lower: Vec<_> = match &errors {
            Some((maps, range)) => maps.iter().map(|m| enlarged(m.coloured(*range))).collect(),
            None => Vec::new(),
        };
        let offset = upper.len().saturating_sub(lower.len());
        let width = upper.iter().map(RgbaImage::width).max().unwrap_or(1) + GAP;
        let height = upper.iter().map(RgbaImage::height).max().unwrap_or(1) + GAP;
        let lines = if lower.is_empty() { 1 } else { 2 };
        let size = (width * upper.len().max(1) as u32, height * lines);
        let mut sheet = RgbaImage::from_pixel(size.0, size.1, Rgba([255; 4]));
        let mut put = |picture: &RgbaImage, column: usize, line: u32| {
            let (x, y) = (column as u32 * width, line * height);
            imageops::replace(&mut sheet, picture, i64::from(x), i64::from(y));
        };
        for (column, picture) in upper.iter().enumerate() {
            put(picture, column, 0);
        }
        for (column, picture) in lower.iter().enumerate() {
            put(picture, column + offset, 1);
        }
        sheet
    }

    /// The row with its pictures as data URIs.
    pub(super) fn shown(&self) -> Result<Shown, PresentError> {
        let (exposure, errors) = (self.exposure(), self.errors());
        let mut pictures = Vec::new();
        for (i, (caption, image)) in self.pictures.iter().enumerate() {
            let map = errors.as_ref().zip(i.checked_sub(1));
            let error = map.and_then(|((maps, range), i)| Some(maps.get(i)?.coloured(*range)));
            pictures.push(Picture {
                caption: caption.clone(),
                uri: data_uri(image.tone_mapped(exposure), caption)?,
                error_uri: error.map(|e| data_uri(e, caption)).transpose()?,
            });
        }
        Ok(Shown {
            title: self.title.clone(),
            pictures,
            range: errors.map(|(_, range)| range.to_string()),
        })
    }
}

/// Pixels between pictures.
const GAP: u32 = 4;

/// A picture in whole blocks of pixels, so that it is large enough to be seen.
fn enlarged(picture: RgbaImage) -> RgbaImage {
    let longer = picture.width().max(picture.height()).max(1);
    let factor = SHOWN.div_ceil(longer);
    if factor == 1 {
        return picture;
    }
    let (width, height) = (picture.width() * factor, picture.height() * factor);
    imageops::resize(&picture, width, height, imageops::FilterType::Nearest)
}

fn data_uri(picture: RgbaImage, name: &str) -> Result<String, PresentError> {
    let png = encode_png(&picture, Path::new(name))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}

/// Words as a file's name: letters, digits and points, everything else a dash.
fn file_name(words: &str) -> String {
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || c == '.' {
            c
        } else {
            '-'
        }
    };
    let name: String = words.chars().map(plain).collect();
    let parts: Vec<&str> = name.split('-').filter(|p| !p.is_empty()).collect();
    parts.join("-").to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::image::HdrImage;

    #[test]
    fn file_names_are_plain() {
        assert_eq!(file_name("Bunny, M = 4 (cpu)"), "bunny-m-4-cpu");
        assert_eq!(file_name("f = 0.2 b = -1"), "f-0.2-b-1");
    }

    #[test]
    fn an_overview_has_room_for_all_pictures_and_their_errors() {
        let mut row = Row::against("r", "truth", HdrImage::new(200, 90), vec![true; 18_000]);
        row.add("a", HdrImage::new(200, 90));
        row.add("b", HdrImage::new(200, 90));
        let sheet = row.overview();
        assert_eq!((sheet.width(), sheet.height()), (3 * 204, 2 * 94));
    }
}
