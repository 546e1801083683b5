//! Orthographic depth maps along directions: the convention that both backends render by.

use crate::Scene;
use glam::{DVec3, Vec3};

/// Depth maps of all objects, receivers too, along whatever directions their reader asks for. They
/// are made in batches while they are read: a thousand of them would not fit in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DirectionalDepthSpec {
    /// Texels along the edge of a map.
    pub size: u32,
    /// Depths are moved back by one unit in the last place and by the surface's slope over one
    /// texel: `glPolygonOffset(1, 1)`.
    pub slope_scaled: bool,
}

/// Parts of a texel that a drawn point's place is rounded to: the usual precision of rasterisers.
const SUBTEXELS: f64 = 256.0;

/// The coordinate that points beside a map are drawn at: nothing lies beside the sphere, so that the
/// border is empty.
const INSIDE: f64 = 0.9999;

/// A sphere in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundingSphere {
    /// Centre.
    pub centre: Vec3,
    /// Radius.
    pub radius: f32,
}

/// An orthographic view along a direction of what lies in a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalFrame {
    /// Unit vector towards growing columns.
    pub right: Vec3,
    /// Unit vector towards shrinking rows.
    pub up: Vec3,
    /// Unit vector to where the view looks from.
    pub towards: Vec3,
    /// What is in view; no radius is zero.
    pub sphere: BoundingSphere,
}

/// A depth map on the host.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthMap {
    /// The view.
    pub frame: DirectionalFrame,
    /// Texels along the edge.
    pub size: u32,
    /// Depths in [0, 1], row by row; 1 where there is nothing.
    pub depth: Vec<f32>,
}

impl BoundingSphere {
    /// Around all objects of a scene, with a margin of a hundredth, so that its rim lies inside
    /// the maps.
    pub fn of_objects(scene: &Scene) -> Self {
        let boxes = scene.objects.iter().filter_map(|o| o.mesh.bounds());
        let around = boxes.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        let (low, high) = around.unwrap_or_default();
        Self {
            centre: low.midpoint(high),
            radius: (0.505 * low.distance(high)).max(f32::MIN_POSITIVE),
        }
    }
}

impl DirectionalFrame {
    /// The view from a unit direction.
    pub fn new(sphere: BoundingSphere, towards: Vec3) -> Self {
        let right = towards.any_orthonormal_vector();
        Self {
            right,
            up: towards.cross(right),
            towards,
            sphere,
        }
    }

    /// Column coordinate s, row coordinate t (both in [−1, 1] inside the sphere) and depth (0
    /// nearest, 1 farthest, as far as positions outside can go) of a position in metres.
    pub fn project(&self, position: Vec3) -> DVec3 {
        let offset = (position - self.sphere.centre).as_dvec3() / f64::from(self.sphere.radius);
        let along = |axis: Vec3| offset.dot(axis.as_dvec3());
        DVec3::new(
            along(self.right),
            -along(self.up),
            (0.5 - 0.5 * along(self.towards)).clamp(0.0, 1.0),
        )
    }
}

impl DepthMap {
    /// A map in which there is nothing.
    pub fn new(frame: DirectionalFrame, size: u32) -> Self {
        Self {
            frame,
            size,
            depth: vec![1.0; (size as usize).pow(2)],
        }
    }

    /// Depth of a position, and the map's at the texel that holds it.
    pub fn depths(&self, position: Vec3) -> [f32; 2] {
        let p = self.frame.project(position);
        [
            p.z as f32,
            self.depth[self.index([p.x, p.y].map(|s| self.texels(s)))],
        ]
    }

    /// Whether a point that is drawn here passes the depth test, less or equal, as an occlusion query
    /// counts it: drawn with its place rounded to a 256th of a texel, inside the image, its depth
    /// less by `margin`.
    pub fn shows(&self, position: Vec3, margin: f32) -> bool {
        let p = self.frame.project(position);
        let snapped = |s: f64| {
            let inside = s.clamp(-INSIDE, INSIDE);
            (self.texels(inside) * SUBTEXELS).round() / SUBTEXELS
        };
        let first = self.depth[self.index([p.x, p.y].map(snapped))];
        (p.z as f32 - margin).max(0.0) <= first
    }

    /// A column or row coordinate in [−1, 1] in texels.
    fn texels(&self, s: f64) -> f64 {
        (s * 0.5 + 0.5) * f64::from(self.size)
    }

    /// Where the texel at this column and row is.
    fn index(&self, place: [f64; 2]) -> usize {
        let last = f64::from(self.size) - 0.5;
        let [column, row] = place.map(|texels| texels.clamp(0.0, last) as usize);
        row * self.size as usize + column
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_orthonormal_and_looks_at_its_sphere() {
        let sphere = BoundingSphere {
            centre: Vec3::new(1.0, 2.0, 3.0),
            radius: 2.0,
        };
        for towards in [Vec3::Y, -Vec3::Z, Vec3::new(0.6, -0.48, 0.64)] {
            let frame = DirectionalFrame::new(sphere, towards);
            let near = frame.project(sphere.centre + towards * 2.0);
            let far = frame.project(sphere.centre - towards * 2.0 + frame.right * 2.0);
            assert!((near - DVec3::new(0.0, 0.0, 0.0)).length() < 1e-6, "{near}");
            assert!((far - DVec3::new(1.0, 0.0, 1.0)).length() < 1e-6, "{far}");
            let above = frame.project(sphere.centre + frame.up);
            assert!(
                (above - DVec3::new(0.0, -0.5, 0.5)).length() < 1e-6,
                "{above}"
            );
        }
    }

    /// A point passes where its depth is that of the map or less, and before its place by the margin;
    /// it is looked up in the texel that its place, rounded to a 256th, lies in; beside the map in the
    /// border.
    #[test]
    fn a_drawn_point_is_tested_in_its_rounded_place() {
        let sphere = BoundingSphere {
            centre: Vec3::ZERO,
            radius: 1.0,
        };
        let frame = DirectionalFrame::new(sphere, Vec3::Y);
        let mut map = DepthMap::new(frame, 4);
        // Columns 0 and 1 hold a plane at a depth of ½, through the centre.
        for (i, depth) in map.depth.iter_mut().enumerate() {
            *depth = if i % 4 < 2 { 0.5 } else { 1.0 };
        }
        let at = |s: f32, height: f32| frame.right * s + Vec3::Y * height;
        assert!(map.shows(at(-0.2, 0.0), 0.0) && map.shows(at(-0.2, 0.1), 0.0));
        assert!(!map.shows(at(-0.2, -0.1), 0.0));
        assert!(map.shows(at(-0.2, -0.1), 0.06) && !map.shows(at(-0.2, -0.1), 0.04));
        assert!(map.shows(at(0.2, -0.1), 0.0));
        // A texel is ½ wide: 1/600 of one before the border is rounded to it, 1/300 is not.
        assert!(map.shows(at(-0.5 / 600.0, -0.1), 0.0));
        assert!(!map.shows(at(-0.5 / 300.0, -0.1), 0.0));
        assert!(map.shows(at(5.0, -0.5), 0.0) && !map.shows(at(-5.0, -0.5), 0.0));
    }
}
