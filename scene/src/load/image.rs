//! Environment maps: Radiance HDR by the image crate, OpenEXR by the exr crate.

use crate::validate::LARGEST_POWER;
use crate::{LatLongImage, Place, SceneError};
use exr::prelude::{ReadChannels, ReadLayers};
use glam::Vec3;
use std::path::Path;

/// Most texels an image may have: 16384 × 8192 of 12 bytes are 1.6 GB.
const MAX_TEXELS: usize = 1 << 27;

/// Loads a latitude–longitude image, `.hdr` or `.exr`, by its file name's ending. Any size is
/// taken: the columns span 360°, the rows 180°, whatever their numbers.
///
/// Negative values become 0: sharpening filters leave them behind in many public maps, small, and
/// they mean no light. NaN, infinity and radiances whose sums may overflow are errors.
///
/// # Errors
/// [`SceneError`] if the file can't be read or holds a value that is not finite or above 1e30.
pub fn load(path: &Path) -> Result<LatLongImage, SceneError> {
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    let image = match ending.as_deref() {
        Some("hdr") => load_hdr(path)?,
        Some("exr") => load_exr(path)?,
        _ => {
            let what = "not an environment map by its name";
            return Err(Place::file(path).error(what, "use a file that ends in .hdr or .exr"));
        }
    };
    let unusable = |t: &Vec3| !t.is_finite() || t.max_element() > LARGEST_POWER;
    if let Some(i) = image.texels.iter().position(unusable) {
        let (column, row) = (i % image.width as usize, i / image.width as usize);
        let texel = image.texels[i].to_array();
        let what = format!("pixel (column {column}, row {row}) is {texel:?}");
        let remedy = format!(
            "replace NaN, infinity and radiances above {LARGEST_POWER:e} in an image editor"
        );
        return Err(Place::file(path).error(what, remedy));
    }
    let texels = image.texels.iter().map(|t| t.max(Vec3::ZERO)).collect();
    Ok(LatLongImage { texels, ..image })
}

fn check_size(path: &Path, width: usize, height: usize) -> Result<(), SceneError> {
    match width.checked_mul(height) {
        Some(1..=MAX_TEXELS) => Ok(()),
        _ => Err(Place::file(path).error(
            format!("the image has {width} × {height} pixels"),
            format!("scale it to between 1 and {MAX_TEXELS} pixels"),
        )),
    }
}

fn load_hdr(path: &Path) -> Result<LatLongImage, SceneError> {
    let bytes = std::fs::read(path).map_err(|source| SceneError::Read {
        path: path.into(),
        source,
    })?;
    let broken = |e: image::ImageError| {
        Place::file(path).error(
            format!("not a readable HDR image: {e}"),
            "save it again as Radiance RGBE",
        )
    };
    let decoder = image::codecs::hdr::HdrDecoder::new(bytes.as_slice()).map_err(broken)?;
    let meta = decoder.metadata();
    check_size(path, meta.width as usize, meta.height as usize)?;
    let pixels = image::DynamicImage::from_decoder(decoder)
        .map_err(broken)?
        .into_rgb32f();
    Ok(LatLongImage {
        width: pixels.width(),
        height: pixels.height(),
        texels: pixels.pixels().map(|p| Vec3::from(p.0)).collect(),
    })
}

fn load_exr(path: &Path) -> Result<LatLongImage, SceneError> {
    let bytes = std::fs::read(path).map_err(|source| SceneError::Read {
        path: path.into(),
        source,
    })?;
    let broken = |e: exr::error::Error, compression: &str| {
        let remedy = "convert it, for example by `oiiotool in.exr --ch R,G,B -d float --compression zip -o out.exr`";
        let what = format!("the EXR image{compression} can't be read: {e}");
        Place::file(path).error(what, remedy)
    };
    let meta = exr::meta::MetaData::read_from_buffered(bytes.as_slice(), false)
        .map_err(|e| broken(e, ""))?;
    for header in &meta.headers {
        check_size(path, header.layer_size.width(), header.layer_size.height())?;
    }
    let compression = meta.headers.first().map_or(String::new(), |h| {
        format!(" ({} compression)", h.compression)
    });
    let read = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| (size.width(), vec![Vec3::ZERO; size.area()]),
            |(width, texels): &mut (usize, Vec<Vec3>), at, (r, g, b): (f32, f32, f32)| {
                texels[at.y() * *width + at.x()] = Vec3::new(r, g, b);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(std::io::Cursor::new(bytes))
        .map_err(|e| broken(e, &compression))?;
    let layer = read.layer_data;
    Ok(LatLongImage {
        width: layer.size.width() as u32,
        height: layer.size.height() as u32,
        texels: layer.channel_data.pixels.1,
    })
}
