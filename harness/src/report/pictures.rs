//! Rows of images, one exposure and one error scale in each.

use super::{ImageRow, LabelledImage, ReportError};
use crate::{
    format,
    output::{ErrorMap, Exposure, encode_png, error_range},
};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use image::RgbaImage;
use serde::Serialize;
use std::path::Path;

/// A row of images, encoded.
#[derive(Clone, Serialize)]
pub(super) struct Row {
    #[serde(skip)]
    scene: String,
    #[serde(skip)]
    quantity: String,
    reference: Picture,
    estimates: Vec<Pair>,
    exposure: String,
    range: String,
}

/// An estimate and its error.
#[derive(Clone, Serialize)]
struct Pair {
    estimate: Picture,
    error_uri: String,
}

/// An image as a data URI, with its words.
#[derive(Clone, Serialize)]
struct Picture {
    label: String,
    note: String,
    uri: String,
}

impl Row {
    /// Scene and quantity.
    pub(super) fn key(&self) -> (&str, &str) {
        (&self.scene, &self.quantity)
    }
}

/// Encodes a row: exposure from the reference, error range from all estimates together.
pub(super) fn row(row: &ImageRow) -> Result<Row, ReportError> {
    let exposure = Exposure::of(&row.reference.image);
    let maps: Result<Vec<ErrorMap>, ReportError> =
        row.estimates.iter().map(|e| error_map(row, e)).collect();
    let maps = maps?;
    let range = error_range(&maps);
    let pair = |(estimate, map): (&LabelledImage, &ErrorMap)| -> Result<Pair, ReportError> {
        Ok(Pair {
            estimate: picture(estimate, exposure)?,
            error_uri: data_uri(&map.coloured(range), &estimate.label)?,
        })
    };
    Ok(Row {
        scene: row.scene.clone(),
        quantity: row.quantity.clone(),
        reference: picture(&row.reference, exposure)?,
        estimates: row
            .estimates
            .iter()
            .zip(&maps)
            .map(pair)
            .collect::<Result<_, _>>()?,
        exposure: format::number(f64::from(exposure.0)),
        range: range.to_string(),
    })
}

fn error_map(row: &ImageRow, estimate: &LabelledImage) -> Result<ErrorMap, ReportError> {
    let surface = |i: usize| {
        row.surfaces
            .as_ref()
            .is_none_or(|s| s.get(i) == Some(&true))
    };
    let map = ErrorMap::new(&estimate.image, &row.reference.image, surface);
    map.ok_or_else(|| ReportError::Size {
        scene: row.scene.clone(),
        label: estimate.label.clone(),
        width: estimate.image.width,
        height: estimate.image.height,
    })
}

fn picture(image: &LabelledImage, exposure: Exposure) -> Result<Picture, ReportError> {
    Ok(Picture {
        label: image.label.clone(),
        note: image.note.clone(),
        uri: data_uri(&image.image.tone_mapped(exposure), &image.label)?,
    })
}

fn data_uri(image: &RgbaImage, label: &str) -> Result<String, ReportError> {
    let png = encode_png(image, Path::new(label))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}
