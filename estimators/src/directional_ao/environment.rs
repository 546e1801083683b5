//! The environment, blurred by a Gaussian (P5, image-based colour).

use glam::Vec3;
use interreflect_scene::{Environment, LatLongImage};
use rayon::prelude::*;

/// Columns of the blurred image, at most: 2.8° wide at the equator.
const COLUMNS: u32 = 128;

/// A blurred image and what it was made of.
pub(super) struct Blurred {
    source: LatLongImage,
    blur_deg: f32,
    image: LatLongImage,
}

impl Blurred {
    /// The image of an environment under a Gaussian of the angle between directions, of the given
    /// standard deviation in degrees, normalised over the sphere. Its resolution is at most
    /// 128 × 64: what is finer is averaged first.
    pub(super) fn new(environment: &Environment, blur_deg: f32) -> Self {
        let source = &environment.image;
        Self {
            source: source.clone(),
            blur_deg,
            image: blurred(&reduced(source), blur_deg),
        }
    }

    /// Whether it was made of this image by this blur: a rotation and a scale don't matter.
    pub(super) fn is_of(&self, environment: &Environment, blur_deg: f32) -> bool {
        self.blur_deg == blur_deg && self.source == environment.image
    }

    /// Blurred radiance from a unit direction, turned and scaled as `environment` is.
    pub(super) fn radiance(&self, environment: &Environment, towards: Vec3) -> Vec3 {
        let unturn = glam::Quat::from_rotation_y(-environment.rotate_deg.to_radians());
        self.image.sample(unturn * towards) * environment.scale
    }
}

/// Sine-weighted means of blocks of texels.
fn reduced(image: &LatLongImage) -> LatLongImage {
    let width = image.width.min(COLUMNS);
    let height = image.height.min(COLUMNS / 2);
    let texel = |i: u32| {
        let (column, row) = (i % width, i / width);
        let range = |k: u32, from: u32, to: u32| k * from / to..((k + 1) * from).div_ceil(to);
        let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
        for r in range(row, image.height, height) {
            let weight = sine(image, r);
            for c in range(column, image.width, width) {
                sum += image.texels[(r * image.width + c) as usize] * weight;
                weights += weight;
            }
        }
        sum / weights
    };
    LatLongImage {
        width,
        height,
        texels: (0..width * height).into_par_iter().map(texel).collect(),
    }
}

/// Sine of the polar angle at a row's middle.
fn sine(image: &LatLongImage, row: u32) -> f32 {
    ((row as f32 + 0.5) * std::f32::consts::PI / image.height as f32).sin()
}

fn blurred(image: &LatLongImage, blur_deg: f32) -> LatLongImage {
    let sigma = blur_deg.to_radians();
    if sigma == 0.0 || image.texels.len() == 1 {
        return image.clone();
    }
    let direction = |i: u32| {
        let (column, row) = (i % image.width, i / image.width);
        image.direction(column as f32 + 0.5, row as f32 + 0.5)
    };
    let count = image.width * image.height;
    let directions: Vec<Vec3> = (0..count).map(direction).collect();
    let weights: Vec<f32> = (0..count).map(|i| sine(image, i / image.width)).collect();
    let texel = |i: u32| {
        let (mut sum, mut total) = (Vec3::ZERO, 0.0);
        for (k, radiance) in image.texels.iter().enumerate() {
            // The chord keeps small angles, which the cosine loses.
            let chord = directions[i as usize].distance(directions[k]);
            let angle = 2.0 * (0.5 * chord).min(1.0).asin();
            let weight = weights[k] * (-0.5 * (angle / sigma).powi(2)).exp();
            sum += *radiance * weight;
            total += weight;
        }
        // A Gaussian far narrower than a texel may miss all but this one.
        if total > 0.0 {
            sum / total
        } else {
            image.texels[i as usize]
        }
    };
    LatLongImage {
        texels: (0..count).into_par_iter().map(texel).collect(),
        ..*image
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_stays_and_a_gradient_is_damped_by_the_band() {
        let mut image = LatLongImage {
            width: 256,
            height: 128,
            texels: vec![Vec3::ONE; 256 * 128],
        };
        let environment = |image: &LatLongImage, rotate_deg| Environment {
            image: image.clone(),
            scale: 2.0,
            rotate_deg,
        };
        let constant = environment(&image, 0.0);
        let seen = Blurred::new(&constant, 20.0).radiance(&constant, Vec3::X);
        assert!((seen - Vec3::splat(2.0)).length() < 1e-5, "{seen}");
        for i in 0..image.texels.len() {
            let (c, r) = (i % 256, i / 256);
            let d = image.direction(c as f32 + 0.5, r as f32 + 0.5);
            image.texels[i] = Vec3::splat(1.0 + d.x);
        }
        // First band: the mean of cos θ under the Gaussian, about 1 − σ² for small σ.
        let turned = environment(&image, 90.0);
        let blurred = Blurred::new(&turned, 10.0);
        // The image's +x is seen in direction R_y(90°)·x = −z.
        let seen = blurred.radiance(&turned, -Vec3::Z).x / 2.0 - 1.0;
        let expected = 1.0 - 10f32.to_radians().powi(2);
        assert!((seen - expected).abs() < 2e-3, "{seen}, {expected}");
        assert!(blurred.is_of(&environment(&image, 5.0), 10.0));
        assert!(!blurred.is_of(&turned, 11.0) && !blurred.is_of(&constant, 10.0));
    }
}
