//! A model between two others on open ground: each takes light from its neighbours.

use super::receiver::{self, Look};
use super::{Recipe, sky};
use crate::load::build::{Model, Parts};
use crate::load::{Setting, assemble};
use crate::params::{Choice, Field, Params};
use crate::{Camera, Environment, Material, Role, Scene, SceneError, shapes};
use glam::{Quat, Vec3};

pub(super) struct Dragons;

/// Where the front of a model is in its file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Front {
    PositiveX,
    #[default]
    NegativeX,
    PositiveZ,
    NegativeZ,
}

impl Choice for Front {
    const ALL: &'static [(&'static str, Self)] = &[
        ("+x", Self::PositiveX),
        ("-x", Self::NegativeX),
        ("+z", Self::PositiveZ),
        ("-z", Self::NegativeZ),
    ];
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

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    size: f32,
    neighbour_size: f32,
    gap: f32,
    front: Front,
    cells: u32,
    look: Look,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: 0.8,
            neighbour_size: 1.0,
            gap: 0.04,
            front: Front::default(),
            cells: 96,
            look: Look::default(),
        }
    }
}

receiver::has_look!(Settings);

impl Params for Settings {
    fn fields() -> Vec<Field<Self>> {
        let mut fields = vec![
            Field::f32(
                "receiver.size",
                "longest side of the model in the middle, the first receiver",
                0.1..=2.0,
                |s: &Self| s.size,
                |s, v| s.size = v,
            )
            .unit("m"),
            Field::f32(
                "neighbours.size",
                "longest side of the models beside it, the second receiver",
                0.1..=2.0,
                |s: &Self| s.neighbour_size,
                |s, v| s.neighbour_size = v,
            )
            .unit("m"),
            Field::f32(
                "neighbours.gap",
                "gap between the model in the middle and its neighbours",
                0.0..=1.0,
                |s: &Self| s.gap,
                |s, v| s.gap = v,
            )
            .unit("m"),
            Field::choice(
                "neighbours.front",
                "where the front of the neighbours' model is, which they turn to the middle",
                |s: &Self| s.front,
                |s, v| s.front = v,
            ),
            Field::u32(
                "ground.cells",
                "cells along each side of the ground",
                1..=512,
                |s: &Self| s.cells,
                |s, v| s.cells = v,
            )
            .log(),
        ];
        fields.extend(receiver::look_fields());
        fields
    }
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
