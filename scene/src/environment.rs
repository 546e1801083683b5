//! Radiance arriving from infinitely far away.

use glam::Vec3;
use std::f32::consts::{PI, TAU};

/// A latitude–longitude image: row r at θ = (r+½)π/H from +y, column c at φ = (c+½)2π/W, direction
/// (sin θ sin φ, cos θ, −sin θ cos φ).
#[derive(Clone, Debug, PartialEq)]
pub struct LatLongImage {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Radiance, row by row from +y.
    pub texels: Vec<Vec3>,
}

/// A latitude–longitude image, turned about +y and scaled. A constant environment is a 1×1 image.
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    /// The image.
    pub image: LatLongImage,
    /// Factor on the image's radiance.
    pub scale: f32,
    /// Rotation about +y in degrees: the image's direction d is seen in direction R_y(angle)·d.
    pub rotate_deg: f32,
}

impl LatLongImage {
    /// Unit direction of (column, row) in texels; the centre of a texel is at +½.
    pub fn direction(&self, column: f32, row: f32) -> Vec3 {
        let (theta, phi) = (
            row * PI / self.height as f32,
            column * TAU / self.width as f32,
        );
        Vec3::new(
            theta.sin() * phi.sin(),
            theta.cos(),
            -theta.sin() * phi.cos(),
        )
    }

    /// Position (column, row) in texels at which a unit direction meets the image.
    pub fn coordinates(&self, direction: Vec3) -> (f32, f32) {
        let theta = direction.y.clamp(-1.0, 1.0).acos();
        let phi = direction.x.atan2(-direction.z).rem_euclid(TAU);
        (
            phi * self.width as f32 / TAU,
            theta * self.height as f32 / PI,
        )
    }

    /// Bilinear radiance in a unit direction: columns wrap around, rows clamp at the poles.
    pub fn sample(&self, direction: Vec3) -> Vec3 {
        let (u, v) = self.coordinates(direction);
        let (u, v) = (u - 0.5, v - 0.5);
        let (fu, fv) = (u - u.floor(), v - v.floor());
        let column = |c: i64| c.rem_euclid(i64::from(self.width)) as usize;
        let row = |r: i64| r.clamp(0, i64::from(self.height) - 1) as usize;
        let at = |c: i64, r: i64| self.texels[row(r) * self.width as usize + column(c)];
        let (c, r) = (u.floor() as i64, v.floor() as i64);
        at(c, r)
            .lerp(at(c + 1, r), fu)
            .lerp(at(c, r + 1).lerp(at(c + 1, r + 1), fu), fv)
    }
}

impl Environment {
    /// The same radiance from every direction.
    pub fn constant(radiance: Vec3) -> Self {
        Self {
            image: LatLongImage {
                width: 1,
                height: 1,
                texels: vec![radiance],
            },
            scale: 1.0,
            rotate_deg: 0.0,
        }
    }

    /// Radiance arriving from a unit direction (the direction points to the environment).
    pub fn radiance(&self, direction: Vec3) -> Vec3 {
        let unturn = glam::Quat::from_rotation_y(-self.rotate_deg.to_radians());
        self.image.sample(unturn * direction) * self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_texel_is_seen_in_its_direction_turned_about_y() {
        let (width, height) = (8, 4);
        let texel = |i: u32| Vec3::splat(i as f32);
        let mut environment = Environment {
            image: LatLongImage {
                width,
                height,
                texels: (0..width * height).map(texel).collect(),
            },
            scale: 2.0,
            rotate_deg: 0.0,
        };
        // The middle of column 1 and row 1: θ = 3π/8 from +y, φ = 3π/8 from −z towards +x.
        let (sin, cos) = (0.375 * PI).sin_cos();
        let middle = Vec3::new(sin * sin, cos, -sin * cos);
        for (rotate_deg, seen) in [
            (0.0, middle),
            // From +x to −z, from −z to −x.
            (90.0, Vec3::new(middle.z, middle.y, -middle.x)),
            (-90.0, Vec3::new(-middle.z, middle.y, middle.x)),
        ] {
            environment.rotate_deg = rotate_deg;
            let radiance = environment.radiance(seen);
            // Roundings of angles in texels.
            assert!(
                (radiance.x / 2.0 - 9.0).abs() < 1e-4,
                "{rotate_deg}°: {radiance}"
            );
        }
    }
}
