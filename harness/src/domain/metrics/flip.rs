//! What a viewer notices: FLIP (Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström & Fairchild:
//! FLIP, A Difference Evaluator for Alternating Images).
//!
//! FLIP knows what screens show, so both images are tone-mapped first, alike: times the exposure of
//! the *reference* ([`Exposure::of`]: the 99th percentile of its largest channels becomes 0.9 of white),
//! clipped to [0, 1], in the sRGB curve, rounded to 8 bits ([`HdrImage::tone_mapped`]). What is brighter
//! than white, or differs by less than a step of 8 bits, is no difference. Pixels are as large as the
//! method's authors assume, [`PIXELS_PER_DEGREE`].

use crate::domain::image::{Exposure, HdrImage};
use crate::domain::statistics::nearest_rank;
use nv_flip::FlipImageRgb8;
use serde::{Deserialize, Serialize};

/// Pixels that a viewer sees in one degree: a display of 3840 pixels, 0.7 m wide, from 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = nv_flip::DEFAULT_PIXELS_PER_DEGREE;

/// How many pixels FLIP's filters reach to either side, ⌈3·67·√(0.04/2π²)⌉. An image that is smaller is
/// all edge.
pub const FLIP_REACH: usize = 10;

/// What a viewer would notice when flipping between an estimate and its reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flip {
    /// Mean over the pixels that show a surface, in [0, 1].
    pub mean: f64,
    /// 95th percentile over them by nearest rank, in [0, 1].
    pub p95: f64,
}

/// FLIP of an image against its reference, over the pixels for which `surface` holds (by index, row by
/// row). The others have no weight, but filters see them beside the edge of a surface.
///
/// `None` if the sizes differ, no pixel shows a surface, or the image has more than 2³² channels.
pub fn flip(
    estimate: &HdrImage,
    reference: &HdrImage,
    surface: impl Fn(usize) -> bool,
) -> Option<Flip> {
    if (estimate.width, estimate.height) != (reference.width, reference.height) {
        return None;
    }
    u32::try_from(3 * reference.pixels.len()).ok()?;
    let shown: Vec<usize> = (0..reference.pixels.len())
        .filter(|&i| surface(i))
        .collect();
    if shown.is_empty() {
        return None;
    }
    let exposure = Exposure::of(reference);
    let map = nv_flip::flip(
        as_shown(reference, exposure),
        as_shown(estimate, exposure),
        PIXELS_PER_DEGREE,
    )
    .to_vec();
    let mut values: Vec<f64> = shown.iter().map(|&i| f64::from(map[i])).collect();
    values.sort_by(f64::total_cmp);
    Some(Flip {
        mean: values.iter().sum::<f64>() / values.len() as f64,
        p95: nearest_rank(&values, 0.95),
    })
}

fn as_shown(image: &HdrImage, exposure: Exposure) -> FlipImageRgb8 {
    let rgba = image.tone_mapped(exposure);
    let rgb: Vec<u8> = rgba.pixels().flat_map(|p| [p[0], p[1], p[2]]).collect();
    FlipImageRgb8::with_data(rgba.width(), rgba.height(), &rgb)
}

#[cfg(test)]
mod tests;
