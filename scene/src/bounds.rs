//! The box and the sphere around what captures see.

use crate::{Role, Scene};
use glam::Vec3;

/// The smallest axis-aligned box around all surfaces that captures see; the sphere is the one around
/// this box. A scene without surfaces has both at the origin, without an extent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Corner of the smallest coordinates in metres.
    pub low: Vec3,
    /// Corner of the largest coordinates in metres.
    pub high: Vec3,
}

impl Bounds {
    /// Around the triangles of the scene's objects with [`Role::Environment`].
    pub fn of_captured(scene: &Scene) -> Self {
        let meshes = || scene.objects_of(Role::Environment).map(|o| &o.mesh);
        let corners = || {
            meshes().flat_map(|mesh| {
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
