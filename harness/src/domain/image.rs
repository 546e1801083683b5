//! Linear images and their way to the screen.

use crate::domain::statistics::nearest_rank;
use glam::Vec3;
use image::{Rgba, RgbaImage};
use interreflect_scene::Estimate;

/// A linear RGB image, row by row from the upper left pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct HdrImage {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Pixels, `width` · `height` of them.
    pub pixels: Vec<Vec3>,
}

impl HdrImage {
    /// A black image.
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            pixels: vec![Vec3::ZERO; width * height],
        }
    }

    /// An image of one value per pixel; `None` unless there are `width` · `height` values.
    pub fn from_estimate(width: usize, height: usize, estimate: &Estimate) -> Option<Self> {
        let pixels: Vec<Vec3> = estimate.iter().collect();
        (pixels.len() == width * height).then_some(Self {
            width,
            height,
            pixels,
        })
    }

    /// The pixels as an estimate, so that images can be compared by the metrics.
    pub fn to_estimate(&self) -> Estimate {
        let mut estimate = Estimate::new(self.pixels.len());
        for (i, pixel) in self.pixels.iter().enumerate() {
            estimate.set(i, *pixel);
        }
        estimate
    }

    /// The pixel in column `x` of row `y`.
    pub fn get(&self, x: usize, y: usize) -> Vec3 {
        self.pixels[y * self.width + x]
    }

    /// Sets the pixel in column `x` of row `y`.
    pub fn set(&mut self, x: usize, y: usize, value: Vec3) {
        self.pixels[y * self.width + x] = value;
    }

    /// The image in sRGB: times the exposure, clipped to [0, 1], encoded.
    pub fn tone_mapped(&self, exposure: Exposure) -> RgbaImage {
        RgbaImage::from_fn(self.width as u32, self.height as u32, |x, y| {
            let v = self.get(x as usize, y as usize) * exposure.0;
            let [r, g, b] = v.to_array().map(srgb_byte);
            Rgba([r, g, b, 255])
        })
    }
}

/// Factor on linear values before they are clipped for the screen. Images that are compared share
/// one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure(pub f32);

impl Exposure {
    /// The exposure that shows the 99th percentile of an image's largest channels as 0.9 of white;
    /// 1 for an image that is black or has no finite pixel.
    pub fn of(image: &HdrImage) -> Self {
        let channel = |p: &Vec3| f64::from(p.max_element());
        let mut values: Vec<f64> = image
            .pixels
            .iter()
            .map(channel)
            .filter(|v| v.is_finite())
            .collect();
        values.sort_by(f64::total_cmp);
        let bright = nearest_rank(&values, 0.99);
        Self(if bright > 0.0 {
            (0.9 / bright) as f32
        } else {
            1.0
        })
    }
}

/// A linear value, clipped to [0, 1], in the encoding of IEC 61966-2-1, rounded to 8 bits. What is
/// not a number becomes 0.
fn srgb_byte(linear: f32) -> u8 {
    let v = linear.clamp(0.0, 1.0);
    let encoded = if v <= 0.003_130_8 {
        12.92 * v
    } else {
        1.055 * v.powf(1.0 / 2.4) - 0.055
    };
    (255.0 * encoded).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_meets_the_standard_s_values() {
        // Linear .18, the grey card, is sRGB .461; .0031308 is the joint of the two pieces.
        for (linear, byte) in [(0.0, 0), (0.003_130_8, 10), (0.18, 118), (1.0, 255)] {
            assert_eq!(srgb_byte(linear), byte, "linear {linear}");
        }
        for (outside, byte) in [(-1.0, 0), (2.0, 255), (f32::INFINITY, 255), (f32::NAN, 0)] {
            assert_eq!(srgb_byte(outside), byte, "linear {outside}");
        }
    }

    #[test]
    fn tone_mapping_exposes_and_encodes_once() {
        let mut image = HdrImage::new(1, 1);
        image.set(0, 0, Vec3::new(0.09, 0.18, 1.0));
        let shown = image.tone_mapped(Exposure(2.0));
        // Linear .18 and .36 are sRGB .461 and .636.
        assert_eq!(shown.get_pixel(0, 0).0, [118, 162, 255, 255]);
    }

    #[test]
    fn exposure_follows_the_bright_parts_not_one_firefly() {
        let mut image = HdrImage::new(100, 10);
        image.pixels.fill(Vec3::new(0.1, 0.45, 0.2));
        image.set(3, 4, Vec3::splat(1e6));
        assert_eq!(Exposure::of(&image), Exposure(2.0));
        assert_eq!(Exposure::of(&HdrImage::new(4, 4)), Exposure(1.0));
        assert_eq!(Exposure::of(&HdrImage::new(0, 0)), Exposure(1.0));
    }

    #[test]
    fn estimates_and_images_are_the_same_values() {
        let mut image = HdrImage::new(3, 2);
        image.set(2, 1, Vec3::new(1.0, 2.0, 3.0));
        let estimate = image.to_estimate();
        assert_eq!(estimate.get(5), Vec3::new(1.0, 2.0, 3.0));
        assert_eq!(HdrImage::from_estimate(3, 2, &estimate), Some(image));
        assert_eq!(HdrImage::from_estimate(2, 2, &estimate), None);
    }
}
