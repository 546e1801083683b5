//! A cubic room with walls of six colours, as in P1's figures.

use super::receiver::{self, Look};
use super::{Recipe, room};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::params::{Choice, Field, Params};
use crate::{Light, Material, Role, Scene, SceneError};
use glam::Vec3;

pub(super) struct ColoredRoom;

/// Where the receiver is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Place {
    #[default]
    Middle,
    Halfway,
    Wall,
    Floor,
}

impl Choice for Place {
    const ALL: &'static [(&'static str, Self)] = &[
        ("middle", Self::Middle),
        ("halfway", Self::Halfway),
        ("wall", Self::Wall),
        ("floor", Self::Floor),
    ];
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    place: Place,
    gap: f32,
    moved: f32,
    receivers: u32,
    size: f32,
    look: Look,
    glow: f32,
    light: f32,
    block: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            place: Place::Middle,
            gap: 0.05,
            moved: 0.0,
            receivers: 1,
            size: 0.6,
            look: Look::default(),
            glow: 0.25,
            light: 2.0,
            block: true,
        }
    }
}

receiver::has_look!(Settings);

impl Params for Settings {
    fn fields() -> Vec<Field<Self>> {
        let mut fields = vec![
            Field::choice(
                "receiver.place",
                "in the middle, half-way to the -x wall, or at a gap from that wall or the floor",
                |s: &Self| s.place,
                |s, v| s.place = v,
            ),
            Field::f32(
                "receiver.gap",
                "gap to the -x wall or the floor, where the receiver stands by one",
                0.0..=1.0,
                |s: &Self| s.gap,
                |s, v| s.gap = v,
            )
            .unit("m"),
            Field::f32(
                "receiver.size",
                "longest side of the receiver",
                0.01..=1.0,
                |s: &Self| s.size,
                |s, v| s.size = v,
            )
            .unit("m"),
            Field::f32(
                "glow",
                "radiance that walls emit, relative to their colour",
                0.0..=10.0,
                |s: &Self| s.glow,
                |s, v| s.glow = v,
            )
            .unit("W/m²/sr"),
            Field::f32(
                "light",
                "intensity of the point light under the ceiling",
                0.0..=100.0,
                |s: &Self| s.light,
                |s, v| s.light = v,
            )
            .unit("W/sr"),
            Field::bool(
                "block",
                "a block stands in the corner and casts a shadow",
                |s: &Self| s.block,
                |s, v| s.block = v,
            ),
        ];
        fields.extend(sharing_fields());
        fields.extend(receiver::look_fields());
        fields
    }
}

impl Recipe for ColoredRoom {
    type Settings = Settings;
    const NAME: &'static str = "colored-room";
    const SUMMARY: &'static str =
        "cubic room with glowing walls of six colours, a point light and a receiver";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        let colours = [
            [0.15, 0.3, 0.75],
            [0.75, 0.14, 0.1],
            [0.75, 0.75, 0.7],
            [0.5, 0.42, 0.35],
            [0.55, 0.2, 0.6],
            [0.2, 0.6, 0.22],
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
        let name = receivers.first().map_or("sphere", String::as_str);
        let model = receiver::model(name, s.size, &s.look)?;
        let (lo, _) = model.mesh.bounds().unwrap_or_default();
        let home = match s.place {
            Place::Middle => Vec3::ZERO,
            Place::Halfway => Vec3::new(-0.5 * room::HALF, 0.0, 0.0),
            Place::Wall => Vec3::new(s.gap - lo.x - room::HALF, 0.0, 0.0),
            Place::Floor => Vec3::new(0.0, s.gap - lo.y - room::HALF, 0.0),
        };
        let position = home + Vec3::X * s.moved;
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
            }],
            camera: Some(room::camera(0.6 * home)),
            reference_point: Some(position),
            captured_at: Some(home),
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

/// The settings of receivers that move, or share the captures.
fn sharing_fields() -> [Field<Settings>; 2] {
    [
        Field::f32(
            "receiver.moved",
            "how far the receivers have moved along +x since captures were made",
            0.0..=1.0,
            |s: &Settings| s.moved,
            |s, v| s.moved = v,
        )
        .unit("m"),
        Field::u32(
            "receivers",
            "equal receivers in a row along x around that place, sharing the captures",
            1..=3,
            |s: &Settings| s.receivers,
            |s, v| s.receivers = v,
        ),
    ]
}
