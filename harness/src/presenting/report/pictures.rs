//! The images: small ones in a table of scenes and methods, and the pixels of all for the viewer.

use super::mark::Numbered;
use super::pixels::{packed, packed_mask};
use super::{ImageRow, LabelledImage, Report, names};
use crate::domain::format;
use crate::domain::image::Exposure;
use crate::domain::metrics::EPSILON_FRACTION;
use crate::domain::record::Run;
use crate::presenting::error::PresentError;
use crate::presenting::output::{ErrorMap, NOTHING, STOPS, encode_png, error_range, unit};
use base64::{Engine as _, engine::general_purpose::STANDARD};
use image::{RgbaImage, imageops};
use serde::Serialize;
use std::path::Path;

/// Largest width of a small image, in pixels.
const SMALL: u32 = 112;

/// What the viewer knows; the names of its fields are `viewer.js`'s too.
#[derive(Serialize)]
pub(super) struct Viewer {
    stops: [[u8; 3]; 5],
    nothing: [u8; 4],
    epsilon_fraction: f64,
    rows: Vec<Row>,
}

/// A row of images of one size.
#[derive(Serialize)]
struct Row {
    title: String,
    unit: &'static str,
    width: usize,
    height: usize,
    exposure: f32,
    range: f32,
    /// Block that says which pixels show a surface.
    mask: Option<String>,
    pictures: Vec<Picture>,
}

/// An image; `id` is the page's fragment that opens it, `pixels` the block of its pixels.
#[derive(Serialize)]
struct Picture {
    id: String,
    number: Option<usize>,
    hue: Option<usize>,
    method: String,
    variant: String,
    note: String,
    /// Its error and the time of a frame, in words.
    figures: String,
    pixels: String,
}

/// Packed bytes in the page.
#[derive(Serialize)]
pub(super) struct Block {
    id: String,
    data: String,
}

/// The table of scenes and methods.
#[derive(Serialize)]
pub(super) struct Matrix {
    methods: Vec<String>,
    rows: Vec<MatrixRow>,
}

#[derive(Serialize)]
struct MatrixRow {
    scene: String,
    quantity: String,
    exposure: String,
    cells: Vec<Option<Small>>,
}

/// A small image that leads to the large one.
#[derive(Serialize)]
struct Small {
    id: String,
    label: String,
    uri: String,
    /// Its relMSE against the truth; empty where there is none.
    relmse: String,
    /// How many other images of the method there are.
    more: usize,
}

/// Everything that a report shows of its images.
#[derive(Default)]
pub(super) struct Images {
    pub(super) viewer: Viewer,
    pub(super) blocks: Vec<Block>,
    pub(super) matrix: Matrix,
}

impl Default for Viewer {
    fn default() -> Self {
        Self {
            stops: STOPS,
            nothing: NOTHING.0,
            epsilon_fraction: EPSILON_FRACTION,
            rows: Vec::new(),
        }
    }
}

impl Default for Matrix {
    fn default() -> Self {
        Self {
            methods: vec!["truth".into()],
            rows: Vec::new(),
        }
    }
}

/// Encodes all images of a report.
pub(super) fn images(report: &Report) -> Result<Images, PresentError> {
    let mut images = Images::default();
    let named = names::named(&report.runs);
    for estimate in report.rows.iter().flat_map(|row| &row.estimates) {
        if !images.matrix.methods.contains(&estimate.label) {
            images.matrix.methods.push(estimate.label.clone());
        }
    }
    for (index, row) in report.rows.iter().enumerate() {
        let exposure = Exposure::of(&row.reference.image);
        let maps: Result<Vec<_>, _> = row.estimates.iter().map(|e| error_map(row, e)).collect();
        let mask = row.surfaces.as_ref().map(|surfaces| {
            let id = format!("mask-{index}");
            images.blocks.push(Block {
                id: id.clone(),
                data: packed_mask(surfaces),
            });
            id
        });
        let all = std::iter::once(&row.reference).chain(&row.estimates);
        let pictures = all.clone().enumerate().map(|(i, picture)| {
            let pixels = format!("pixels-{index}-{i}");
            images.blocks.push(Block {
                id: pixels.clone(),
                data: packed(&picture.image),
            });
            described(&named, picture, pixels, (index, i))
        });
        let pictures: Vec<Picture> = pictures.collect();
        let cells = images
            .matrix
            .methods
            .iter()
            .enumerate()
            .map(|(column, method)| {
                let of_method = |(i, p): &(usize, &LabelledImage)| match column {
                    0 => *i == 0,
                    _ => *i > 0 && p.label == *method,
                };
                let mut same = all.clone().enumerate().filter(of_method);
                let Some((i, picture)) = same.next() else {
                    return Ok(None);
                };
                small(report, picture, &pictures[i], exposure, same.count()).map(Some)
            });
        let cells: Result<Vec<_>, PresentError> = cells.collect();
        images.matrix.rows.push(MatrixRow {
            scene: row.scene.clone(),
            quantity: row.quantity.replace('_', " "),
            exposure: format::number(f64::from(exposure.0)),
            cells: cells?,
        });
        images.viewer.rows.push(Row {
            title: format!("{}, {}", row.scene, row.quantity.replace('_', " ")),
            unit: unit(&row.quantity),
            width: row.reference.image.width,
            height: row.reference.image.height,
            exposure: exposure.0,
            range: error_range(&maps?),
            mask,
            pictures,
        });
    }
    Ok(images)
}

fn described(
    named: &[Numbered<'_>],
    picture: &LabelledImage,
    pixels: String,
    (row, index): (usize, usize),
) -> Picture {
    let run = picture.run.and_then(|i| named.get(i));
    Picture {
        id: match run {
            Some(of) => format!("run-{}", of.number),
            None => format!("image-{row}-{index}"),
        },
        number: run.map(|of| of.number),
        hue: run.map(|of| of.hue),
        method: picture.label.clone(),
        variant: match run {
            Some(of) => of.variant.clone(),
            None => picture.note.clone(),
        },
        note: if run.is_some() {
            String::new()
        } else {
            picture.note.clone()
        },
        figures: run.map(|of| figures(of.run)).unwrap_or_default(),
        pixels,
    }
}

/// The error and the time of a frame of a run in words.
fn figures(run: &Run) -> String {
    let error = run
        .truth
        .as_ref()
        .map(|c| format!("relMSE {} against the truth", format::relmse(c)));
    let software = if run.software {
        " (software adapter)"
    } else {
        ""
    };
    let frame = run.phases_ms.frame_ms();
    let time = frame.map(|ms| format!("{} ms a frame{software}", format::number(ms)));
    error
        .into_iter()
        .chain(time)
        .collect::<Vec<_>>()
        .join(" · ")
}

fn small(
    report: &Report,
    picture: &LabelledImage,
    described: &Picture,
    exposure: Exposure,
    more: usize,
) -> Result<Small, PresentError> {
    let shown = picture.image.tone_mapped(exposure);
    let truth = picture.run.and_then(|i| report.runs.get(i)?.truth.as_ref());
    Ok(Small {
        id: described.id.clone(),
        label: picture.label.clone(),
        uri: data_uri(&shrunk(shown), &picture.label)?,
        relmse: truth.map(format::relmse).unwrap_or_default(),
        more,
    })
}

fn shrunk(image: RgbaImage) -> RgbaImage {
    if image.width() <= SMALL {
        return image;
    }
    let height = (image.height() * SMALL).div_ceil(image.width());
    imageops::thumbnail(&image, SMALL, height)
}

fn error_map(row: &ImageRow, estimate: &LabelledImage) -> Result<ErrorMap, PresentError> {
    let surface = |i: usize| {
        row.surfaces
            .as_ref()
            .is_none_or(|s| s.get(i) == Some(&true))
    };
    let map = ErrorMap::new(&estimate.image, &row.reference.image, surface);
    map.ok_or_else(|| PresentError::Size {
        scene: row.scene.clone(),
        label: estimate.label.clone(),
        width: estimate.image.width,
        height: estimate.image.height,
    })
}

fn data_uri(image: &RgbaImage, label: &str) -> Result<String, PresentError> {
    let png = encode_png(image, Path::new(label))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}
