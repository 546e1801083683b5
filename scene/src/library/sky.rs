//! A procedural sky.

use crate::LatLongImage;
use glam::Vec3;

const WIDTH: u32 = 512;
const HEIGHT: u32 = 256;

/// Half-width of the sun's lobe (standard deviation) in radians: 5°, seven rows of the image.
const SUN_SIGMA: f32 = 0.087;
const SUN_RADIANCE: Vec3 = Vec3::new(42.0, 36.0, 27.0);

/// Unit direction to the sun: 35° high, to the right of and behind a camera that looks along −z.
pub(super) fn sun_direction() -> Vec3 {
    Vec3::new(0.62, 0.57, 0.54).normalize()
}

/// A clear sky over plain ground: blue above, warm towards the horizon, with a soft sun whose
/// irradiance is about that of the rest of the sky.
pub(super) fn sky() -> LatLongImage {
    let mut image = LatLongImage {
        width: WIDTH,
        height: HEIGHT,
        texels: Vec::with_capacity((WIDTH * HEIGHT) as usize),
    };
    for row in 0..HEIGHT {
        for column in 0..WIDTH {
            let direction = image.direction(column as f32 + 0.5, row as f32 + 0.5);
            image.texels.push(radiance(direction));
        }
    }
    image
}

/// Radiance of the sky from a unit direction.
fn radiance(direction: Vec3) -> Vec3 {
    let zenith = Vec3::new(0.22, 0.38, 0.75);
    let horizon = Vec3::new(1.05, 0.88, 0.7);
    let ground = Vec3::new(0.24, 0.21, 0.17);
    let height = direction.y;
    let sky = zenith.lerp(horizon, (1.0 - height.max(0.0)).powi(4));
    // The horizon is blurred over some ten rows, so that a coarse cube map can follow it.
    let above = ((height + 0.06) / 0.12).clamp(0.0, 1.0);
    let base = ground.lerp(sky, above * above * (3.0 - 2.0 * above));
    // Von Mises-Fisher: a Gaussian on the sphere.
    let sun = ((direction.dot(sun_direction()) - 1.0) / SUN_SIGMA.powi(2)).exp();
    base + SUN_RADIANCE * sun
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::{PI, TAU};

    /// Irradiance on a surface that faces `normal`, by the image's own texels.
    fn irradiance(image: &LatLongImage, normal: Vec3) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for row in 0..HEIGHT {
            let omega_sr = (TAU / WIDTH as f32)
                * ((row as f32 * PI / HEIGHT as f32).cos()
                    - ((row + 1) as f32 * PI / HEIGHT as f32).cos());
            for column in 0..WIDTH {
                let cos_theta = image
                    .direction(column as f32 + 0.5, row as f32 + 0.5)
                    .dot(normal);
                sum +=
                    image.texels[(row * WIDTH + column) as usize] * cos_theta.max(0.0) * omega_sr;
            }
        }
        sum
    }

    #[test]
    fn the_sky_is_plausibly_bright_and_its_sun_is_where_it_should_be() {
        let image = sky();
        let up = irradiance(&image, Vec3::Y);
        assert!(up.min_element() > 1.0 && up.max_element() < 6.0, "{up}");
        let brightest = (0..image.texels.len())
            .max_by(|a, b| image.texels[*a].x.total_cmp(&image.texels[*b].x))
            .map(|i| i as u32)
            .unwrap_or_default();
        let at = image.direction(
            (brightest % WIDTH) as f32 + 0.5,
            (brightest / WIDTH) as f32 + 0.5,
        );
        // A texel is 0.7°: its centre is within 0.5° of any direction in it.
        assert!(at.dot(sun_direction()) > 0.5f32.to_radians().cos());
    }

    #[test]
    fn the_sun_is_resolved_by_the_image() {
        // The lobe's integral over the sphere is 2πσ²(1 − exp(−2/σ²)); the image's texels must give
        // the same. 1 %: the midpoint rule at seven rows per σ errs far less.
        let image = sky();
        let without_sun = |d: Vec3| {
            radiance(d).x
                - SUN_RADIANCE.x * ((d.dot(sun_direction()) - 1.0) / SUN_SIGMA.powi(2)).exp()
        };
        let mut sum = 0.0;
        for row in 0..HEIGHT {
            let omega_sr = (TAU / WIDTH as f32)
                * ((row as f32 * PI / HEIGHT as f32).cos()
                    - ((row + 1) as f32 * PI / HEIGHT as f32).cos());
            for column in 0..WIDTH {
                let d = image.direction(column as f32 + 0.5, row as f32 + 0.5);
                sum +=
                    (image.texels[(row * WIDTH + column) as usize].x - without_sun(d)) * omega_sr;
            }
        }
        let exact = SUN_RADIANCE.x * TAU * SUN_SIGMA.powi(2);
        assert!((sum / exact - 1.0).abs() < 0.01, "{sum} for {exact}");
    }
}
