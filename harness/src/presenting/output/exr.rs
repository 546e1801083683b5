//! Images in linear HDR that say what they are.
//!
//! They are packed and unpacked on the thread that asks: the format library's own threads end some time
//! after a file, and would take time and free memory while the next thing is measured.

use crate::domain::files::{FileError, write_atomically};
use crate::domain::image::HdrImage;
use crate::domain::machine::Machine;
use crate::domain::record::Run;
use exr::prelude as exr;
use std::{io, path::Path};

/// What an image's header says, as text attributes whose names begin with `interreflect.`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header(Vec<(String, String)>);

/// Before the name of every attribute, so that it meets no other program's.
const PREFIX: &str = "interreflect.";

impl Header {
    /// What is the same for all images that a program leaves: its command line, commit and seed.
    pub fn of_program(command: &str, machine: &Machine, seed: u64) -> Self {
        Self::default()
            .with("command", command)
            .with("commit", machine.commit_label())
            .with("seed", seed.to_string())
    }

    /// With one more attribute; an empty value is left out.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Into<String>) -> Self {
        let value = value.into();
        if !value.is_empty() {
            self.0.push((name.into(), value));
        }
        self
    }

    /// With the scene, the quantity and its unit.
    #[must_use]
    pub fn of_quantity(self, scene: &str, quantity: &str) -> Self {
        self.with("scene", scene)
            .with("quantity", quantity)
            .with("unit", unit(quantity))
    }

    /// With all that tells a run from others.
    #[must_use]
    pub fn of_run(self, run: &Run) -> Self {
        self.of_quantity(&run.scene, &run.quantity)
            .with("estimator", &run.estimator)
            .with("fidelity", run.fidelity.clone().unwrap_or_default())
            .with("params", run.params.to_string())
            .with("backend", run.backend.to_string())
    }

    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.0.iter().find(|(n, _)| n == name);
        found.map(|(_, value)| value.as_str())
    }
}

/// The unit of a quantity's values; empty for an unknown quantity.
pub(crate) fn unit(quantity: &str) -> &'static str {
    match quantity {
        "irradiance" => "W/m2",
        "glossy_radiance" => "W/(m2 sr)",
        "ambient_occlusion" => "1",
        _ => "",
    }
}

/// An image with what its file says of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Labelled {
    /// The pixels.
    pub image: HdrImage,
    /// Which pixels show a surface: where channel A is not 0, everywhere without such a channel.
    pub surfaces: Vec<bool>,
    /// Its attributes.
    pub header: Header,
}

/// Writes an image as OpenEXR with channels R, G, B in 32-bit floating point, losslessly packed, and
/// A, which is 1 where there is a surface and 0 elsewhere, if `surfaces` is given.
///
/// # Errors
/// [`FileError`] if the image can't be encoded or the file can't be written.
pub fn write_exr(
    path: &Path,
    image: &HdrImage,
    surfaces: Option<&[bool]>,
    header: &Header,
) -> Result<(), FileError> {
    let bytes = encode(image, surfaces, header).map_err(|e| FileError::Encode {
        path: path.into(),
        reason: e.to_string(),
    })?;
    write_atomically(path, &bytes)
}

fn encode(image: &HdrImage, surfaces: Option<&[bool]>, header: &Header) -> exr::Result<Vec<u8>> {
    use exr::WritableImage as _;
    let channel =
        |name: &str, values: Vec<f32>| exr::AnyChannel::new(name, exr::FlatSamples::F32(values));
    let colour = |c: usize| image.pixels.iter().map(|p| p[c]).collect();
    let covered = |s: &[bool]| s.iter().map(|s| f32::from(u8::from(*s))).collect();
    let colours = [("R", 0), ("G", 1), ("B", 2)].map(|(name, c)| channel(name, colour(c)));
    let surfaces = surfaces.map(|s| channel("A", covered(s)));
    let channels = exr::AnyChannels::sort(colours.into_iter().chain(surfaces).collect());
    let mut attributes = exr::LayerAttributes {
        software_name: exr::Text::new_or_none("interreflect"),
        ..exr::LayerAttributes::default()
    };
    // The format's texts have one byte a character.
    let latin = |text: &str| -> String {
        let known = |c: char| if u32::from(c) < 256 { c } else { '?' };
        text.chars().map(known).collect()
    };
    for (name, value) in &header.0 {
        let texts = (
            exr::Text::new_or_none(format!("{PREFIX}{name}")),
            exr::Text::new_or_none(latin(value)),
        );
        if let (Some(name), Some(value)) = texts {
            attributes
                .other
                .insert(name, exr::AttributeValue::Text(value));
        }
    }
    let size = (image.width, image.height);
    let layer = exr::Layer::new(size, attributes, exr::Encoding::SMALL_LOSSLESS, channels);
    let mut bytes = io::Cursor::new(Vec::new());
    exr::Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}

/// Reads the first RGB layer of an OpenEXR file.
///
/// # Errors
/// [`FileError::Read`] if the file is missing, is not OpenEXR, has no RGB channels or uses a
/// compression that is not supported.
pub fn read_exr(path: &Path) -> Result<HdrImage, FileError> {
    Ok(read_labelled_exr(path)?.image)
}

/// Reads the first RGB layer of an OpenEXR file, where it has surfaces, and what it says of itself.
///
/// # Errors
/// As [`read_exr`].
pub fn read_labelled_exr(path: &Path) -> Result<Labelled, FileError> {
    use exr::{ReadChannels as _, ReadLayers as _};
    let read = exr::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| {
                let image = HdrImage::new(size.width(), size.height());
                let surfaces = vec![true; image.pixels.len()];
                (image, surfaces)
            },
            |(image, surfaces): &mut (HdrImage, Vec<bool>), p, pixel: (f32, f32, f32, f32)| {
                let (r, g, b, a) = pixel;
                image.set(p.x(), p.y(), glam::Vec3::new(r, g, b));
                surfaces[p.y() * image.width + p.x()] = a != 0.0;
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_file(path);
    let read = read.map_err(|e| FileError::Read {
        path: path.into(),
        reason: e.to_string(),
    })?;
    let (image, surfaces) = read.layer_data.channel_data.pixels;
    let mut header = Header::default();
    for (name, value) in &read.layer_data.attributes.other {
        if let (exr::AttributeValue::Text(value), name) = (value, name.to_string())
            && let Some(name) = name.strip_prefix(PREFIX)
        {
            header = header.with(name, value.to_string());
        }
    }
    header.0.sort();
    Ok(Labelled {
        image,
        surfaces,
        header,
    })
}
