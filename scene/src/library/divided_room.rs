//! A cubic room with a partition wall: what is seen from the reference point differs from what is
//! seen from the shaded points.

use super::receiver::{self, Look};
use super::{Recipe, room};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::{Camera, Light, Material, Role, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct DividedRoom;

/// Where the reference point is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Reference {
    /// The receiver's centre.
    #[default]
    Receiver,
    /// The passage between both halves of the room.
    Passage,
}

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// How far the divider reaches into the room from the -z wall.
    #[serde(rename = "divider.depth")]
    #[default(1.1)]
    #[schemars(range(min = 0.1, max = 1.9), extend("unit" = "m"))]
    depth: f32,
    /// Reference point: the receiver's centre, or the passage that sees both halves.
    reference: Reference,
    /// Longest side of the receiver.
    #[serde(rename = "receiver.size")]
    #[default(0.6)]
    #[schemars(range(min = 0.01, max = 0.8), extend("unit" = "m"))]
    size: f32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

impl Recipe for DividedRoom {
    type Settings = Settings;
    const NAME: &'static str = "divided-room";
    const SUMMARY: &'static str =
        "cubic room with a divider that hides half of it, and a glossy receiver beside the passage";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        let walls = [
            room::glowing([0.2, 0.45, 0.8], 1.2),
            room::glowing([0.75, 0.2, 0.12], 0.15),
            room::glowing([0.75, 0.75, 0.72], 0.15),
            room::glowing([0.5, 0.45, 0.4], 0.15),
            room::glowing([0.7, 0.65, 0.3], 0.15),
            room::glowing([0.3, 0.6, 0.3], 0.15),
        ];
        parts.add("walls", Role::Environment, room::walls(walls));
        let size = Vec3::new(room::DIVIDER, 2.0 * room::HALF, s.depth);
        let centre = Vec3::new(0.0, 0.0, 0.5 * s.depth - room::HALF);
        let white = Material::diffuse(Vec3::splat(0.75));
        parts.add(
            "divider",
            Role::Environment,
            room::block(centre, size, white),
        );
        let name = receivers.first().map_or("sphere", String::as_str);
        // Level with the divider's default end: its points see between nothing and all of the
        // other half.
        let position = Vec3::new(-0.47, -0.15, 0.1);
        let model = receiver::model(name, s.size, &s.look)?.moved(position);
        receiver::add(&mut parts, name, model, &s.look);
        let setting = Setting {
            lights: vec![Light::Point {
                position: Vec3::new(0.5, 0.45, 0.1),
                intensity: Vec3::new(1.6, 1.5, 1.3),
                picture: Some(room::PICTURE),
            }],
            camera: Some(Camera {
                eye: Vec3::new(0.8, 0.3, 0.97),
                ..room::camera(Vec3::new(-0.3, -0.15, 0.0))
            }),
            reference_point: Some(match s.reference {
                Reference::Receiver => position,
                Reference::Passage => Vec3::new(0.0, 0.0, 0.5 * s.depth),
            }),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}
