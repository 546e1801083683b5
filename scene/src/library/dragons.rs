//! A model between two others on open ground: each takes light from its neighbours.

use super::receiver::{self, Look};
use super::{Recipe, sky};
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::{Camera, Environment, Material, Role, Scene, SceneError, shapes};
use glam::{Quat, Vec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct Dragons;

/// Where the front of a model is in its file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
enum Front {
    /// +x.
    #[serde(rename = "+x")]
    PositiveX,
    /// -x.
    #[default]
    #[serde(rename = "-x")]
    NegativeX,
    /// +z.
    #[serde(rename = "+z")]
    PositiveZ,
    /// -z.
    #[serde(rename = "-z")]
    NegativeZ,
}

impl Front {
    /// Turn about +y in degrees that brings the front to +x.
    fn turn_to_x_deg(self) -> f32 {
        match self {
            Self::PositiveX => 0.0,
            Self::NegativeX => 180.0,
            Self::PositiveZ => 90.0,
            Self::NegativeZ => -90.0,
        }
    }
}

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// Longest side of the model in the middle, the first receiver.
    #[serde(rename = "receiver.size")]
    #[default(0.8)]
    #[schemars(range(min = 0.1, max = 2.0), extend("unit" = "m"))]
    size: f32,
    /// Longest side of the models beside it, the second receiver.
    #[serde(rename = "neighbours.size")]
    #[default(1.0)]
    #[schemars(range(min = 0.1, max = 2.0), extend("unit" = "m"))]
    neighbour_size: f32,
    /// Gap between the model in the middle and its neighbours.
    #[serde(rename = "neighbours.gap")]
    #[default(0.04)]
    #[schemars(range(min = 0.0, max = 1.0), extend("unit" = "m"))]
    gap: f32,
    /// Axis that the front of the neighbours' model faces; it is turned to the middle.
    #[serde(rename = "neighbours.front")]
    front: Front,
    /// Cells along each side of the ground.
    #[serde(rename = "ground.cells")]
    #[default(96)]
    #[schemars(range(min = 1, max = 512), extend("scale" = "log"))]
    cells: u32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

/// Side of the square ground in metres.
const GROUND_M: f32 = 6.0;

impl Recipe for Dragons {
    type Settings = Settings;
    const NAME: &'static str = "dragons";
    const SUMMARY: &'static str =
        "a model (first receiver) between two others (second receiver) on ground under a sky";
    const RECEIVERS: usize = 2;
    const BENCHED: bool = false;

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let name = |i: usize, other: &'static str| receivers.get(i).map_or(other, String::as_str);
        let (middle, neighbour) = (name(0, "blob"), name(1, "torus"));
        let model = standing(receiver::model(middle, s.size, &s.look)?, 0.0);
        let (lo, hi) = model.mesh.bounds().unwrap_or_default();
        let mut parts = Parts::default();
        receiver::add(&mut parts, middle, model, &s.look);
        let other = receiver::model(neighbour, s.neighbour_size, &s.look)?;
        let to_right_deg = s.front.turn_to_x_deg();
        for (left, turn_deg) in [(true, to_right_deg), (false, to_right_deg + 180.0)] {
            let turned = standing(other.clone(), turn_deg);
            let (low, high) = turned.mesh.bounds().unwrap_or_default();
            let x = match left {
                true => lo.x - s.gap - high.x,
                false => hi.x + s.gap - low.x,
            };
            receiver::add(&mut parts, neighbour, turned.moved(Vec3::X * x), &s.look);
        }
        let corner = Vec3::new(-0.5, 0.0, 0.5) * GROUND_M;
        let (right, up) = (Vec3::X * GROUND_M, Vec3::NEG_Z * GROUND_M);
        let ground = shapes::grid(corner, right, up, [s.cells; 2]);
        let stone = Material::diffuse(Vec3::splat(0.5));
        parts.add("ground", Role::Receiver, Model::uniform(ground, stone));
        let setting = Setting {
            environment: Some(Environment {
                image: sky::sky(),
                scale: 1.0,
                rotate_deg: 0.0,
            }),
            camera: Some(Camera {
                eye: Vec3::new(0.0, 1.1, 3.3),
                target: Vec3::new(0.0, 0.26, 0.0),
                up: Vec3::Y,
                vfov_deg: 31.0,
                resolution: [768, 432],
            }),
            reference_point: Some(0.5 * lo + 0.5 * hi),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}

/// A model turned about +y that stands on the ground.
fn standing(model: Model, turn_deg: f32) -> Model {
    let turn = Quat::from_rotation_y(turn_deg.to_radians());
    let model = model.placed(Vec3::ZERO, turn, 1.0);
    let (lo, _) = model.mesh.bounds().unwrap_or_default();
    model.moved(Vec3::Y * -lo.y)
}
