//! Pixels on their way into the page, in few characters.

use crate::domain::image::HdrImage;
use base64::{Engine as _, engine::general_purpose::STANDARD};
use flate2::{Compression, write::DeflateEncoder};
use half::f16;
use std::io::Write as _;

/// An image as half floats: for each channel the difference of each pixel's sixteen bits to the pixel
/// before, first all upper bytes, then all lower ones; deflated, in base64. Values beyond the halves'
/// range become the largest half. `pixels.js` undoes it.
pub(super) fn packed(image: &HdrImage) -> String {
    let mut bytes = Vec::with_capacity(6 * image.pixels.len());
    for channel in 0..3 {
        let mut before = 0_u16;
        let differences: Vec<u16> = image
            .pixels
            .iter()
            .map(|p| {
                let bits = half(p[channel]).to_bits();
                bits.wrapping_sub(std::mem::replace(&mut before, bits))
            })
            .collect();
        bytes.extend(differences.iter().map(|d| (d >> 8) as u8));
        bytes.extend(differences.iter().map(|d| *d as u8));
    }
    deflated(&bytes)
}

/// Which pixels show a surface, a byte each, deflated, in base64.
pub(super) fn packed_mask(surfaces: &[bool]) -> String {
    let bytes: Vec<u8> = surfaces.iter().map(|s| u8::from(*s)).collect();
    deflated(&bytes)
}

fn half(value: f32) -> f16 {
    let largest = f16::MAX.to_f32();
    match value.is_finite() {
        true => f16::from_f32(value.clamp(-largest, largest)),
        false => f16::from_f32(value),
    }
}

fn deflated(bytes: &[u8]) -> String {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    // A vector takes every byte.
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    STANDARD.encode(written.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use flate2::read::DeflateDecoder;
    use glam::Vec3;
    use std::io::Read as _;

    fn inflated(text: &str) -> Vec<u8> {
        let mut bytes = Vec::new();
        let packed = STANDARD.decode(text).unwrap();
        DeflateDecoder::new(packed.as_slice())
            .read_to_end(&mut bytes)
            .unwrap();
        bytes
    }

    #[test]
    fn pixels_can_be_had_back() {
        let mut image = HdrImage::new(3, 1);
        image.set(0, 0, Vec3::new(0.5, 2.0, -1.0));
        image.set(1, 0, Vec3::new(1e9, 0.0, f32::INFINITY));
        let bytes = inflated(&packed(&image));
        assert_eq!(bytes.len(), 18);
        for channel in 0..3 {
            let plane = &bytes[6 * channel..];
            let mut bits = 0_u16;
            for x in 0..3 {
                let difference = u16::from(plane[x]) << 8 | u16::from(plane[3 + x]);
                bits = bits.wrapping_add(difference);
                let expected = half(image.pixels[x][channel]);
                assert_eq!(
                    f16::from_bits(bits),
                    expected,
                    "channel {channel}, pixel {x}"
                );
            }
        }
        assert_eq!(half(1e9).to_f32(), 65504.0);
        assert_eq!(inflated(&packed_mask(&[true, false])), [1, 0]);
    }
}
