//! What moves in a scene, and how: the scene as it was loaded is the scene at rest, and
//! [`Scene::at`] gives it at a time.

mod check;
mod deformation;
mod scene_motion;
#[cfg(test)]
mod tests;
mod track;

pub(crate) use check::{camera_fault, mesh_fault, scene_fault};
pub use deformation::{Deformation, DeformationKind};
pub use scene_motion::{CameraMotion, LightMotion, SceneMotion};
pub use track::Track;

use crate::{Mesh, Scene};
use glam::{Mat3, Quat, Vec3};

/// Where a mesh is, relative to where it rests: scaled, then turned, both about the centre of its
/// bounding box at rest, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Translation in metres.
    pub translate: Vec3,
    /// Rotation, a unit quaternion.
    pub rotate: Quat,
    /// Factor on lengths, from [`Pose::SCALES`].
    pub scale: f32,
}

impl Pose {
    /// At rest.
    pub const REST: Self = Self {
        translate: Vec3::ZERO,
        rotate: Quat::IDENTITY,
        scale: 1.0,
    };
    /// Smallest and largest factor on lengths.
    pub const SCALES: [f32; 2] = [1e-3, 1e3];

    /// Between two poses: translations and factors linearly, rotations as quaternions, the short
    /// way; `t` in [0, 1].
    pub fn between(a: Self, b: Self, t: f32) -> Self {
        Self {
            translate: a.translate.lerp(b.translate, t),
            rotate: a.rotate.slerp(b.rotate, t).normalize(),
            scale: a.scale + (b.scale - a.scale) * t,
        }
    }
}

impl Default for Pose {
    fn default() -> Self {
        Self::REST
    }
}

/// How a mesh moves: it is deformed first, then posed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Poses at their times; without any the mesh stays where it is.
    pub poses: Track<Pose>,
    /// A periodic deformation.
    pub deformation: Option<Deformation>,
    /// The pose that [`Scene::at`] gave the mesh; at rest in a scene as it was loaded.
    pub posed: Pose,
}

impl Motion {
    /// Whether the mesh differs between any two times.
    pub fn moves(&self) -> bool {
        self.poses.varies() || self.deforms()
    }

    /// Whether the mesh keeps its shape and size at all times, wherever it goes.
    pub fn is_rigid(&self) -> bool {
        let mut scales = self.poses.keys.windows(2);
        !self.deforms() && scales.all(|pair| pair[0].1.scale == pair[1].1.scale)
    }

    fn deforms(&self) -> bool {
        self.deformation.is_some_and(|d| d.amount != 0.0)
    }

    fn pose(&self, time_s: f32) -> Pose {
        self.poses.at(time_s, Pose::between).unwrap_or(Pose::REST)
    }

    /// The mesh at a time in seconds: the same triangles, its vertices moved and its normals, if it
    /// has any, those of the moved surface, of unit length. The very same mesh where the motion
    /// leaves it at rest.
    pub fn of(&self, mesh: &Mesh, time_s: f32) -> Mesh {
        let mut moved = mesh.clone();
        let Some((lo, hi)) = mesh.bounds() else {
            return moved;
        };
        let (centre, half) = (0.5 * lo + 0.5 * hi, (0.5 * hi - 0.5 * lo).max_element());
        if let Some(deformation) = &self.deformation
            && half > 0.0
            && deformation.swing(time_s) != 0.0
        {
            let swing = deformation.swing(time_s);
            for v in 0..moved.positions.len() {
                let q = (moved.positions[v] - centre) / half;
                let (to, jacobian) = deformation.kind.displaced(q, swing);
                moved.positions[v] = centre + to * half;
                if let Some(normal) = moved.normals.get_mut(v) {
                    *normal = carried(jacobian, *normal);
                }
            }
        }
        let pose = self.pose(time_s);
        if pose != Pose::REST {
            for p in &mut moved.positions {
                *p = centre + pose.translate + pose.rotate * ((*p - centre) * pose.scale);
            }
            for n in &mut moved.normals {
                *n = (pose.rotate * *n).normalize();
            }
        }
        moved
    }
}

/// The unit normal of a surface that a map with this Jacobian has moved: the inverse transpose
/// times the normal, by cofactors, so that nothing is divided by the determinant, which is positive.
fn carried(jacobian: Mat3, normal: Vec3) -> Vec3 {
    let Mat3 {
        x_axis: x,
        y_axis: y,
        z_axis: z,
    } = jacobian;
    let cofactors = Mat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    (cofactors * normal).try_normalize().unwrap_or(normal)
}

/// What can change in a scene from one time to another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Moves {
    /// Meshes.
    pub geometry: bool,
    /// The camera.
    pub camera: bool,
    /// Point, spot, directional and area lights.
    pub lights: bool,
    /// The light from infinitely far away.
    pub environment: bool,
}

impl Scene {
    /// The scene at a time in seconds: the same triangles, materials and names; the reference point
    /// and the place of kept captures stay as they are. A time that is no finite number is taken
    /// as 0.
    ///
    /// Times count from the scene at rest: ask the scene as it was loaded, not one that this gave.
    pub fn at(&self, time_s: f32) -> Self {
        let time_s = if time_s.is_finite() { time_s } else { 0.0 };
        let mut scene = self.clone();
        for object in &mut scene.objects {
            if let Some(motion) = &mut object.motion {
                object.mesh = motion.of(&object.mesh, time_s);
                motion.posed = motion.pose(time_s);
            }
        }
        for (light, motion) in scene.lights.iter_mut().zip(&self.motion.lights) {
            *light = motion.of(light, time_s);
        }
        if let Some(motion) = &self.motion.camera {
            scene.camera = motion.of(&self.camera, time_s);
        }
        if let Some(environment) = &mut scene.environment {
            let turn = scene_motion::turned_deg(self.motion.environment_deg_per_s, time_s);
            environment.rotate_deg += turn;
        }
        scene
    }

    /// The rotation that its only object has here, from rest, where the motion of that object is
    /// rigid: whatever moves from one time to another, its surfaces keep their places relative to
    /// each other. `None` where there are several objects, or one without a motion or that changes its
    /// shape or size.
    pub fn rigid_rotation(&self) -> Option<Quat> {
        let [only] = &self.objects[..] else {
            return None;
        };
        let motion = only.motion.as_ref().filter(|motion| motion.is_rigid())?;
        Some(motion.posed.rotate)
    }

    /// What can change from one time to another.
    pub fn moves(&self) -> Moves {
        let moving = |o: &crate::Object| o.motion.as_ref().is_some_and(Motion::moves);
        Moves {
            geometry: self.objects.iter().any(moving),
            camera: self.motion.camera.as_ref().is_some_and(CameraMotion::moves),
            lights: self.motion.lights.iter().any(LightMotion::moves),
            environment: self.environment.is_some() && self.motion.environment_deg_per_s != 0.0,
        }
    }
}
