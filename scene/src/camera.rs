//! The pinhole camera.

use glam::Vec3;

/// A pinhole camera looking from `eye` to `target`; pixel (0, 0) is the upper left one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye in metres.
    pub eye: Vec3,
    /// Point at the centre of the image.
    pub target: Vec3,
    /// Upward direction, not parallel to the view direction.
    pub up: Vec3,
    /// Full vertical field of view in degrees, in (0, 180).
    pub vfov_deg: f32,
    /// Width and height in pixels.
    pub resolution: [u32; 2],
}

impl Camera {
    /// Unit direction of the ray through (x, y) in pixels; the centre of a pixel is at +½.
    pub fn ray(&self, x: f32, y: f32) -> Vec3 {
        let forward = (self.target - self.eye).normalize();
        let right = forward.cross(self.up).normalize();
        let up = right.cross(forward);
        let [w, h] = self.resolution.map(|v| v as f32);
        let half = (self.vfov_deg.to_radians() * 0.5).tan();
        let across = (2.0 * x / w - 1.0) * half * w / h;
        let above = (1.0 - 2.0 * y / h) * half;
        (forward + right * across + up * above).normalize()
    }
}
