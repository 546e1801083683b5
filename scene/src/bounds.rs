//! Boxes around surfaces, and the spheres around them.

use crate::{Object, Role, Scene};
use glam::Vec3;

/// The smallest axis-aligned box around some surfaces; the sphere is the one around this box. Without
/// surfaces both are at the origin, without an extent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Corner of the smallest coordinates in metres.
    pub low: Vec3,
    /// Corner of the largest coordinates in metres.
    pub high: Vec3,
}

impl Bounds {
    /// Around what cube captures see: the triangles of the objects with [`Role::Environment`].
    pub fn of_captured(scene: &Scene) -> Self {
        Self::around(scene.objects_of(Role::Environment))
    }

    /// Around the triangles of all objects.
    pub fn of_all(scene: &Scene) -> Self {
        Self::around(scene.objects.iter())
    }

    fn around<'a>(objects: impl Iterator<Item = &'a Object> + Clone) -> Self {
        let corners = || {
            objects.clone().flat_map(|object| {
                let mesh = &object.mesh;
                let indices = mesh.triangles.iter().flatten();
                indices.map(|&v| mesh.positions[v as usize])
            })
        };
        Self {
            low: corners().reduce(Vec3::min).unwrap_or_default(),
            high: corners().reduce(Vec3::max).unwrap_or_default(),
        }
    }

    /// Centre of the box and of the sphere.
    pub fn centre(&self) -> Vec3 {
        self.low.midpoint(self.high)
    }

    /// Length of the box's diagonal in metres.
    pub fn diagonal(&self) -> f32 {
        self.low.distance(self.high)
    }

    /// Radius of the sphere in metres.
    pub fn radius(&self) -> f32 {
        0.5 * self.diagonal()
    }
}
