//! A whole scene.

use crate::motion::{Motion, SceneMotion};
use crate::{Bounds, Camera, Environment, Light, Material, Mesh, SceneFacts};
use glam::Vec3;

/// What a mesh is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Sends indirect light: every capture sees it.
    Environment,
    /// Receives indirect light: it carries the points, and cube captures around it leave it out, as a
    /// caster of shadows too. Reflective shadow maps and depth maps along directions see it.
    Receiver,
}

/// A mesh with its role.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Name for messages.
    pub name: String,
    /// What the mesh is for.
    pub role: Role,
    /// The mesh, in world space, at rest.
    pub mesh: Mesh,
    /// How it moves; `None` if it stands still.
    pub motion: Option<Motion>,
}

/// A scene in world space, checked when it was loaded: every index in range, every number finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Name in reports.
    pub name: String,
    /// The meshes.
    pub objects: Vec<Object>,
    /// Materials that the meshes' triangles refer to.
    pub materials: Vec<Material>,
    /// Point, spot, directional and area lights.
    pub lights: Vec<Light>,
    /// Radiance arriving from infinitely far away.
    pub environment: Option<Environment>,
    /// The camera.
    pub camera: Camera,
    /// Reference point `o` where cube captures are wanted.
    pub reference_point: Vec3,
    /// Where captures were made before and are still there: a reference point that the receivers have
    /// moved away from. `None` if there are none.
    pub captured_at: Option<Vec3>,
    /// How camera, lights and environment move; meshes have motions of their own.
    pub motion: SceneMotion,
}

impl Scene {
    /// Whether captures that were made before are kept: the reference point is at most
    /// `keep_within_m` metres away from theirs. With 0 none are.
    pub fn keeps_captures(&self, keep_within_m: f32) -> bool {
        let near = |at: Vec3| at.distance(self.reference_point) <= keep_within_m;
        keep_within_m > 0.0 && self.captured_at.is_some_and(near)
    }

    /// Reference point of the captures that are used: that of kept ones, else the scene's.
    pub fn capture_origin(&self, keep_within_m: f32) -> Vec3 {
        let kept = self
            .captured_at
            .filter(|_| self.keeps_captures(keep_within_m));
        kept.unwrap_or(self.reference_point)
    }

    /// The objects of one role.
    pub fn objects_of(&self, role: Role) -> impl Iterator<Item = &Object> + Clone {
        self.objects.iter().filter(move |o| o.role == role)
    }

    /// What a method may know of the scene when it says what it needs.
    pub fn facts(&self) -> SceneFacts {
        let used = || {
            self.objects_of(Role::Environment)
                .flat_map(|o| &o.mesh.materials)
                .map(|&m| &self.materials[m as usize])
        };
        SceneFacts {
            captured_surfaces: self
                .objects_of(Role::Environment)
                .any(|o| !o.mesh.triangles.is_empty()),
            any_surface: self.objects.iter().any(|o| !o.mesh.triangles.is_empty()),
            environment: self.environment.is_some(),
            lights: self.lights.len() as u32,
            emitters: used().any(|m| m.emission != Vec3::ZERO),
            mirrors: used().any(|m| m.mirror),
            bounds: Bounds::of_captured(self),
        }
    }
}
