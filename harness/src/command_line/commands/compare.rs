//! `compare`: two images in linear HDR.

use super::{print_json, print_line};
use crate::command_line::cli::Compare;
use crate::command_line::error::CommandError;
use crate::domain::image::HdrImage;
use crate::domain::metrics::{FLIP_REACH, Flip, Reference, compare, flip};
use crate::presenting::output::{ErrorMap, error_range, read_exr, write_error_map};
use interreflect_scene::load::open_image;
use std::path::Path;

pub(super) fn run(command: &Compare) -> Result<(), CommandError> {
    let estimate = read(&command.estimate)?;
    let reference = read(&command.reference)?;
    let same_size = |path: &Path, image: &HdrImage| match (image.width, image.height)
        == (estimate.width, estimate.height)
    {
        true => Ok(()),
        false => Err(CommandError::Usage(format!(
            "{}: {} × {} pixels, {} has {} × {}; compare images of one size",
            path.display(),
            image.width,
            image.height,
            command.estimate.display(),
            estimate.width,
            estimate.height
        ))),
    };
    same_size(&command.reference, &reference)?;
    let error = command.standard_error.as_ref().map(|path| {
        let image = read(path)?;
        same_size(path, &image)?;
        Ok::<_, CommandError>(image.to_estimate())
    });
    let error = error.transpose()?;
    let mut comparison = compare(
        &estimate.to_estimate(),
        Reference {
            values: &reference.to_estimate(),
            standard_error: error.as_ref(),
            description: &command.reference.to_string_lossy(),
        },
        None,
    )
    .map_err(|e| CommandError::Usage(e.to_string()))?;
    let noticed = noticed(&estimate, &reference);
    comparison.flip = noticed.map(|f| f.mean);
    let map = ErrorMap::new(&estimate, &reference, |_| true);
    if let (Some(folder), Some(map)) = (&command.out, map) {
        write_error_map(&folder.join("error.png"), &map, error_range([&map]))?;
    }
    if command.json {
        return print_json(&comparison);
    }
    let number = |v: Option<f64>| v.map_or("undefined".into(), |v| format!("{v:.6e}"));
    print_line(&format!(
        "relMSE {}  RMSE {:.6e}  energy ratio {}  99.9 % {:.6e}  max {:.6e}  noise floor {}  {}  FLIP {}",
        number(comparison.relmse),
        comparison.rmse,
        number(comparison.energy_ratio),
        comparison.p999,
        comparison.max,
        number(comparison.noise_floor),
        comparison.verdict,
        noticed.map_or(
            "undefined: the image is smaller than its filters".into(),
            |f| { format!("{:.4} (95 % {:.4})", f.mean, f.p95) }
        )
    ))
}

/// FLIP over all pixels; `None` for an image that is smaller than FLIP's filters reach.
fn noticed(estimate: &HdrImage, reference: &HdrImage) -> Option<Flip> {
    let large_enough = reference.width.min(reference.height) > FLIP_REACH;
    large_enough.then(|| flip(estimate, reference, |_| true))?
}

/// An EXR as it is, an HDR through the scene's loader.
fn read(path: &Path) -> Result<HdrImage, CommandError> {
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    match ending.to_ascii_lowercase().as_str() {
        "exr" => Ok(read_exr(path)?),
        "hdr" => {
            let image = open_image(path)?;
            Ok(HdrImage {
                width: image.width as usize,
                height: image.height as usize,
                pixels: image.texels,
            })
        }
        _ => Err(CommandError::Usage(format!(
            "{}: no .exr or .hdr image by its name; compare linear images",
            path.display()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_smaller_than_the_filters_has_no_flip() {
        let square = |size| HdrImage::new(size, size);
        let nothing = square(FLIP_REACH);
        assert_eq!(noticed(&nothing, &nothing), None);
        let enough = square(FLIP_REACH + 1);
        assert_eq!(noticed(&enough, &enough).map(|f| f.mean), Some(0.0));
    }
}
