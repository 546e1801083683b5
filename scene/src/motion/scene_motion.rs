//! Motion of what is no mesh: camera, lights, environment.

use super::Track;
use crate::{Camera, Light};
use glam::{Quat, Vec3};

/// What moves beside meshes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneMotion {
    /// The camera's motion.
    pub camera: Option<CameraMotion>,
    /// Motions of the lights, in their order; lights beyond the last one stand still.
    pub lights: Vec<LightMotion>,
    /// Speed at which the environment turns about +y in degrees per second.
    pub environment_deg_per_s: f32,
}

/// How the camera moves.
#[derive(Clone, Debug, PartialEq)]
pub enum CameraMotion {
    /// Eye and target in metres, interpolated linearly.
    Keyframes(Track<[Vec3; 2]>),
    /// The eye turns about the target, around the camera's upward direction.
    Orbit {
        /// Angular speed in degrees per second, counter-clockwise seen from above.
        deg_per_s: f32,
    },
}

impl CameraMotion {
    /// Whether the camera differs between any two times.
    pub fn moves(&self) -> bool {
        match self {
            Self::Keyframes(track) => track.varies(),
            Self::Orbit { deg_per_s } => *deg_per_s != 0.0,
        }
    }

    /// The camera at a time in seconds.
    pub fn of(&self, camera: &Camera, time_s: f32) -> Camera {
        let mut moved = *camera;
        match self {
            Self::Keyframes(track) => {
                let between =
                    |a: [Vec3; 2], b: [Vec3; 2], t| [a[0].lerp(b[0], t), a[1].lerp(b[1], t)];
                if let Some([eye, target]) = track.at(time_s, between) {
                    (moved.eye, moved.target) = (eye, target);
                }
            }
            Self::Orbit { deg_per_s } => {
                let turn_deg = turned_deg(*deg_per_s, time_s);
                if turn_deg != 0.0 {
                    let axis = camera.up.normalize();
                    let turn = Quat::from_axis_angle(axis, turn_deg.to_radians());
                    moved.eye = camera.target + turn * (camera.eye - camera.target);
                }
            }
        }
        moved
    }
}

/// How a light moves. A track is empty for what stays, and for what the light does not have.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LightMotion {
    /// Positions in metres.
    pub position: Track<Vec3>,
    /// Unit directions: of the axis, of parallel light, or of an area light's normal. They go along
    /// great circles. A square spot light, and an area light's picture, are
    /// turned without rolling from the direction at rest; a point light's picture keeps its own.
    pub direction: Track<Vec3>,
}

impl LightMotion {
    /// Whether the light differs between any two times.
    pub fn moves(&self) -> bool {
        self.position.varies() || self.direction.varies()
    }

    /// The light at a time in seconds.
    pub fn of(&self, light: &Light, time_s: f32) -> Light {
        let mut moved = *light;
        let at = self.position.at(time_s, Vec3::lerp);
        let towards = self.direction.at(time_s, along_great_circle);
        match &mut moved {
            Light::Point { position, .. } => *position = at.unwrap_or(*position),
            Light::Spot {
                position,
                direction,
                up,
                ..
            } => {
                *position = at.unwrap_or(*position);
                if let Some(to) = towards.filter(|to| to != direction) {
                    let turned = Quat::from_rotation_arc(*direction, to) * *up;
                    *up = (turned - to * to.dot(turned)).normalize();
                    *direction = to;
                }
            }
            Light::Directional { direction, .. } => *direction = towards.unwrap_or(*direction),
            Light::Area {
                position,
                normal,
                picture,
                ..
            } => {
                *position = at.unwrap_or(*position);
                if let Some(to) = towards.filter(|to| to != normal) {
                    // Its picture is fixed to it.
                    let turn = Quat::from_rotation_arc(*normal, to);
                    if let Some(picture) = picture {
                        picture.direction = (turn * picture.direction).normalize();
                        let up = turn * picture.up;
                        let ahead = picture.direction;
                        picture.up = (up - ahead * ahead.dot(up)).normalize();
                    }
                    *normal = to;
                }
            }
        }
        moved
    }
}

/// The unit vector between two, at the fraction `t` of the angle between them.
fn along_great_circle(a: Vec3, b: Vec3, t: f32) -> Vec3 {
    let all = Quat::from_rotation_arc(a, b);
    (Quat::IDENTITY.slerp(all, t) * a).normalize()
}

/// Angle in degrees, within ±360, after a time at a speed.
pub(super) fn turned_deg(deg_per_s: f32, time_s: f32) -> f32 {
    (f64::from(deg_per_s) * f64::from(time_s) % 360.0) as f32
}
