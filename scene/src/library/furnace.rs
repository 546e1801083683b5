//! The furnace: a closed room of uniform emission, where the answer is known exactly.

use super::receiver::{self, Look};
use super::{Recipe, room};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::params::{Field, Params};
use crate::{Material, Role, Scene, SceneError};
use glam::Vec3;

pub(super) struct Furnace;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    emission: f32,
    albedo: f32,
    size: f32,
    look: Look,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            emission: 1.0,
            albedo: 0.0,
            size: 0.6,
            look: Look::default(),
        }
    }
}

receiver::has_look!(Settings);

impl Params for Settings {
    fn fields() -> Vec<Field<Self>> {
        let mut fields = vec![
            Field::f32(
                "emission",
                "radiance that every wall emits",
                0.0..=1000.0,
                |s: &Self| s.emission,
                |s, v| s.emission = v,
            )
            .unit("W/m²/sr"),
            Field::f32(
                "albedo",
                "diffuse albedo of every wall",
                0.0..=0.95,
                |s: &Self| s.albedo,
                |s, v| s.albedo = v,
            )
            .symbol("ρ"),
            Field::f32(
                "receiver.size",
                "longest side of the receiver",
                0.01..=1.8,
                |s: &Self| s.size,
                |s, v| s.size = v,
            )
            .unit("m"),
        ];
        fields.extend(receiver::look_fields());
        fields
    }
}

impl Recipe for Furnace {
    type Settings = Settings;
    const NAME: &'static str = "furnace";
    const SUMMARY: &'static str =
        "closed room of uniform emission around a receiver: irradiance is π wherever it is open";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let wall = Material {
            emission: Vec3::splat(s.emission),
            ..Material::diffuse(Vec3::splat(s.albedo))
        };
        let mut parts = Parts::default();
        parts.add("walls", Role::Environment, room::walls([wall; 6]));
        let name = receivers.first().map_or("sphere", String::as_str);
        let model = receiver::model(name, s.size, &s.look)?;
        receiver::add(&mut parts, name, model, &s.look);
        let setting = Setting {
            camera: Some(room::camera(Vec3::ZERO)),
            reference_point: Some(Vec3::ZERO),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}
