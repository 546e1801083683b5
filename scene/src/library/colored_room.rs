//! A cubic room with walls of six colours, as in P1's figures.

use super::receiver::{self, Look};
use super::{Recipe, room};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::{Light, Material, Role, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct ColoredRoom;

/// Where the receiver is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Place {
    /// The middle of the room.
    #[default]
    Middle,
    /// Half-way to the -x wall.
    Halfway,
    /// At a gap from the -x wall.
    Wall,
    /// At a gap from the floor.
    Floor,
    /// Half-way to the -x wall, at a gap from the ceiling.
    Ceiling,
}

/// Where the reference point is, before its offset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Reference {
    /// The middle of the receivers.
    #[default]
    Receiver,
    /// The middle of the room, wherever the receivers are.
    Room,
}

/// Which colour is overhead.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Ceiling {
    /// The ceiling is white, the -z wall green.
    #[default]
    White,
    /// The ceiling is green, the -z wall white (P1, Figure 3).
    Green,
}

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// In the middle, half-way to the -x wall, or at a gap from that wall, the floor or the ceiling.
    #[serde(rename = "receiver.place")]
    place: Place,
    /// Gap to the -x wall, the floor or the ceiling, where the receiver is by one.
    #[serde(rename = "receiver.gap")]
    #[default(0.05)]
    #[schemars(range(min = 0.0, max = 1.0), extend("unit" = "m"))]
    gap: f32,
    /// Longest side of the receiver.
    #[serde(rename = "receiver.size")]
    #[default(0.6)]
    #[schemars(range(min = 0.01, max = 1.0), extend("unit" = "m"))]
    size: f32,
    /// Reference point, before its offset: the middle of the receivers, or that of the room.
    #[serde(rename = "reference.place")]
    reference: Reference,
    /// Distance of the reference point from there, along +x. At 0 the sphere's surface points and
    /// their normals lie on rays from the reference point, so that localizing a cube map changes nothing.
    #[serde(rename = "reference.offset")]
    #[default(0.25)]
    #[schemars(range(min = 0.0, max = 0.3), extend("unit" = "m"))]
    reference_offset: f32,
    /// Radiance that walls emit, relative to their colour.
    #[default(0.25)]
    #[schemars(range(min = 0.0, max = 10.0), extend("unit" = "W/m²/sr"))]
    glow: f32,
    /// Intensity of the point light under the ceiling.
    #[default(2.0)]
    #[schemars(range(min = 0.0, max = 100.0), extend("unit" = "W/sr"))]
    light: f32,
    /// Colour of the ceiling, which it changes with the -z wall.
    ceiling: Ceiling,
    /// How far a divider from floor to ceiling reaches from the -z wall, half-way to the +x wall; 0: there is none.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = 1.9), extend("unit" = "m"))]
    divider: f32,
    /// A block stands in the corner and casts a shadow.
    #[default(true)]
    block: bool,
    /// Distance that the receivers have moved along +x since the captures were made.
    #[serde(rename = "receiver.moved")]
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = 1.0), extend("unit" = "m"))]
    moved: f32,
    /// Equal receivers in a row along x around that place, sharing the captures.
    #[default(1)]
    #[schemars(range(min = 1, max = 3))]
    receivers: u32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

impl Recipe for ColoredRoom {
    type Settings = Settings;
    const NAME: &'static str = "colored-room";
    const SUMMARY: &'static str =
        "cubic room with glowing walls of six colours, a point light and a receiver";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        let (white, green) = ([0.75, 0.75, 0.7], [0.2, 0.6, 0.22]);
        let [ceiling, back] = match s.ceiling {
            Ceiling::White => [white, green],
            Ceiling::Green => [green, white],
        };
        let colours = [
            [0.15, 0.3, 0.75],
            [0.75, 0.14, 0.1],
            ceiling,
            [0.5, 0.42, 0.35],
            [0.55, 0.2, 0.6],
            back,
        ];
        parts.add(
            "walls",
            Role::Environment,
            room::walls(colours.map(|c| room::glowing(c, s.glow))),
        );
        if s.block {
            let size = Vec3::new(0.4, 0.9, 0.4);
            let centre = Vec3::new(0.6, 0.5 * size.y - room::HALF, -0.55);
            let material = Material::diffuse(Vec3::new(0.75, 0.6, 0.2));
            parts.add(
                "block",
                Role::Environment,
                room::block(centre, size, material),
            );
        }
        if s.divider > 0.0 {
            let size = Vec3::new(room::DIVIDER, 2.0 * room::HALF, s.divider);
            let centre = Vec3::new(0.5 * room::HALF, 0.0, 0.5 * s.divider - room::HALF);
            let material = Material::diffuse(Vec3::splat(0.75));
            parts.add(
                "divider",
                Role::Environment,
                room::block(centre, size, material),
            );
        }
        let name = receivers.first().map_or("sphere", String::as_str);
        let model = receiver::model(name, s.size, &s.look)?;
        let (lo, hi) = model.mesh.bounds().unwrap_or_default();
        let home = match s.place {
            Place::Middle => Vec3::ZERO,
            Place::Halfway => Vec3::new(-0.5 * room::HALF, 0.0, 0.0),
            Place::Wall => Vec3::new(s.gap - lo.x - room::HALF, 0.0, 0.0),
            Place::Floor => Vec3::new(0.0, s.gap - lo.y - room::HALF, 0.0),
            Place::Ceiling => Vec3::new(-0.5 * room::HALF, room::HALF - s.gap - hi.y, 0.0),
        };
        let position = home + Vec3::X * s.moved;
        let offset = Vec3::X * s.reference_offset;
        let [captured_at, reference] = match s.reference {
            Reference::Receiver => [home, position],
            Reference::Room => [Vec3::ZERO; 2],
        };
        let offsets = row(s, position);
        let reach =
            position.x.abs() + offsets.iter().fold(0.0, |m, x| f32::max(m, *x)) + 0.5 * s.size;
        if reach > 1.0001 * room::HALF && (s.receivers > 1 || s.moved > 0.0) {
            return Err(SceneError::Inconsistent {
                scene: Self::NAME.into(),
                what: format!(
                    "{} receivers of {} m, moved {} m, reach {reach} m from the middle of a room of {} m",
                    s.receivers,
                    s.size,
                    s.moved,
                    2.0 * room::HALF
                ),
                remedy:
                    "make scene.receiver.size smaller, move them less, or place them in the middle"
                        .into(),
            });
        }
        for offset in offsets {
            let model = model.clone().moved(position + Vec3::X * offset);
            receiver::add(&mut parts, name, model, &s.look);
        }
        let setting = Setting {
            lights: vec![Light::Point {
                position: Vec3::new(0.15, 0.6, 0.1),
                intensity: Vec3::splat(s.light),
                picture: Some(room::PICTURE),
            }],
            camera: Some(room::camera(0.6 * home)),
            reference_point: Some(reference + offset),
            captured_at: Some(captured_at + offset),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}

/// Places of the receivers along x, from the middle of the row at `position`: a quarter of their size
/// apart, less where the room ends, but never into each other.
fn row(s: &Settings, position: Vec3) -> Vec<f32> {
    let last = s.receivers - 1;
    let room = (2.0 * (room::HALF - position.x.abs()) - s.size) / last.max(1) as f32;
    let step = room.min(1.25 * s.size).max(s.size);
    let place = |i| step * (i as f32 - 0.5 * last as f32);
    (0..=last).map(place).collect()
}
