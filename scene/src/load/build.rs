//! Parts on the way to a scene.

use crate::{Material, Mesh, Motion, Object, Role};
use glam::{Quat, Vec3};

/// A mesh with materials of its own: what a mesh file, a shape or a receiver gives.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Model {
    pub(crate) mesh: Mesh,
    pub(crate) materials: Vec<Material>,
}

impl Model {
    /// A mesh all of one material.
    pub(crate) fn uniform(mut mesh: Mesh, material: Material) -> Self {
        mesh.materials.fill(0);
        Self {
            mesh,
            materials: vec![material],
        }
    }

    /// Moves the centre of the bounding box to the origin and makes its longest side `size` metres
    /// long; `None` if the box has no extent.
    pub(crate) fn fitted(mut self, size: f32) -> Option<Self> {
        let (lo, hi) = self.mesh.bounds()?;
        let (centre, longest) = (0.5 * lo + 0.5 * hi, (hi - lo).max_element());
        let factor = size / longest;
        if !(longest > 0.0 && factor.is_finite()) {
            return None;
        }
        for p in &mut self.mesh.positions {
            *p = (*p - centre) * factor;
        }
        Some(self)
    }

    /// Scales, then turns, then moves the mesh into world space.
    pub(crate) fn placed(mut self, translate: Vec3, rotate: Quat, scale: f32) -> Self {
        for p in &mut self.mesh.positions {
            *p = translate + rotate * (*p * scale);
        }
        for n in &mut self.mesh.normals {
            *n = (rotate * *n).normalize();
        }
        self
    }

    /// Only moves the mesh.
    pub(crate) fn moved(self, translate: Vec3) -> Self {
        self.placed(translate, Quat::IDENTITY, 1.0)
    }
}

/// The objects of a scene and the one list of their materials.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) objects: Vec<Object>,
    pub(crate) materials: Vec<Material>,
}

impl Parts {
    /// Adds a model as an object that stands still.
    pub(crate) fn add(&mut self, name: impl Into<String>, role: Role, model: Model) {
        self.add_moving(name, role, model, None);
    }

    /// Adds a model as an object.
    pub(crate) fn add_moving(
        &mut self,
        name: impl Into<String>,
        role: Role,
        model: Model,
        motion: Option<Motion>,
    ) {
        let Model {
            mut mesh,
            materials,
        } = model;
        let first = self.materials.len() as u32;
        mesh.materials.iter_mut().for_each(|m| *m += first);
        self.materials.extend(materials);
        self.objects.push(Object {
            name: name.into(),
            role,
            mesh,
            motion,
        });
    }

    /// Where the reference point is when nothing says: the centre of the receivers' bounding box,
    /// without receivers that of the scene's, without objects the origin.
    pub(crate) fn default_reference_point(&self) -> Vec3 {
        let receivers = self.objects.iter().filter(|o| o.role == Role::Receiver);
        bounds_of(receivers)
            .or_else(|| bounds_of(&self.objects))
            .map_or(Vec3::ZERO, |(lo, hi)| 0.5 * lo + 0.5 * hi)
    }
}

/// The bounding box of objects, or `None` if there are none.
pub(crate) fn bounds_of<'a>(objects: impl IntoIterator<Item = &'a Object>) -> Option<(Vec3, Vec3)> {
    objects
        .into_iter()
        .filter_map(|o| o.mesh.bounds())
        .reduce(|(a, b), (lo, hi)| (a.min(lo), b.max(hi)))
}
