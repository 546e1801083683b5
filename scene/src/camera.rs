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
        let [right, up, forward] = self.axes();
        let [w, h] = self.resolution.map(|v| v as f32);
        let half = (self.vfov_deg.to_radians() * 0.5).tan();
        let across = (2.0 * x / w - 1.0) * half * w / h;
        let above = (1.0 - 2.0 * y / h) * half;
        (forward + right * across + up * above).normalize()
    }

    /// Whether a position in world space lies inside the image, whatever is before it.
    pub fn shows(&self, position: Vec3) -> bool {
        let offset = position - self.eye;
        let [across, above, ahead] = self.axes().map(|axis| axis.dot(offset));
        let [w, h] = self.resolution.map(|v| v as f32);
        let half_height = ahead * (self.vfov_deg.to_radians() * 0.5).tan();
        let half_width = half_height * w / h;
        ahead > 0.0 && across.abs() <= half_width && above.abs() <= half_height
    }

    /// Unit vectors to the right, upwards and forward.
    fn axes(&self) -> [Vec3; 3] {
        let forward = (self.target - self.eye).normalize();
        let right = forward.cross(self.up).normalize();
        [right, right.cross(forward), forward]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What lies on the ray through a place in the image is shown, what lies on one beside it or
    /// behind the eye is not.
    #[test]
    fn what_lies_on_a_ray_of_the_image_is_shown() {
        let camera = Camera {
            eye: Vec3::new(1.0, 2.0, 3.0),
            target: Vec3::new(-2.0, 1.0, 0.5),
            up: Vec3::Y,
            vfov_deg: 40.0,
            resolution: [300, 100],
        };
        let shown = |x, y, far| camera.shows(camera.eye + camera.ray(x, y) * far);
        for (x, y) in [(1.0, 1.0), (299.0, 99.0), (150.0, 50.0), (1.0, 99.0)] {
            assert!(shown(x, y, 0.1) && shown(x, y, 50.0), "({x}, {y})");
            assert!(!shown(x, y, -1.0), "behind the eye at ({x}, {y})");
        }
        for (x, y) in [(-1.0, 50.0), (301.0, 50.0), (150.0, -1.0), (150.0, 101.0)] {
            assert!(!shown(x, y, 2.0), "({x}, {y})");
        }
    }
}
