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

    /// The bits of halves as IEEE 754 has them: sign, five bits of exponent, ten of fraction.
    #[test]
    fn pixels_are_the_halves_of_the_standard() {
        let values = [0.5, 2.0, -1.0, 0.0, 1e9, -1e9, -0.25, 65504.0];
        let bits = [
            0x3800, 0x4000, 0xbc00, 0x0000, 0x7bff, 0xfbff, 0xb400, 0x7bff,
        ];
        let odd = [f32::INFINITY, f32::NEG_INFINITY, 6e-8, 1.0 / 3.0];
        let odd_bits = [0x7c00, 0xfc00, 0x0001, 0x3555];
        let expected: Vec<(f32, u16)> = (values.into_iter().zip(bits))
            .chain(odd.into_iter().zip(odd_bits))
            .collect();
        // A channel of its own for each shift of the list.
        let count = expected.len();
        let mut image = HdrImage::new(count, 1);
        for x in 0..count {
            let at = |shift: usize| expected[(x + shift) % count].0;
            image.set(x, 0, Vec3::new(at(0), at(5), at(7)));
        }
        let bytes = inflated(&packed(&image));
        assert_eq!(bytes.len(), 6 * count);
        for (channel, shift) in [0, 5, 7].into_iter().enumerate() {
            let plane = &bytes[2 * count * channel..];
            let mut sum = 0_u16;
            for x in 0..count {
                let difference = u16::from_be_bytes([plane[x], plane[count + x]]);
                sum = sum.wrapping_add(difference);
                let (value, bits) = expected[(x + shift) % count];
                assert_eq!(sum, bits, "channel {channel}, pixel {x}: {value}");
            }
        }
        assert!(half(f32::NAN).is_nan());
        let mask = [true, false, false, true];
        assert_eq!(inflated(&packed_mask(&mask)), [1, 0, 0, 1]);
    }
}
