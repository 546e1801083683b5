//! The furnace: a closed room of uniform emission, where the answer is known exactly.

use super::receiver::{self, Look};
use super::{Recipe, room};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::{Material, Role, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct Furnace;

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// Radiance that every wall emits.
    #[default(1.0)]
    #[schemars(range(min = 0.0, max = 1000.0), extend("unit" = "W/m²/sr"))]
    emission: f32,
    /// Diffuse albedo of every wall.
    #[default(0.0)]
    #[schemars(range(min = 0.0, max = 0.95), extend("symbol" = "ρ"))]
    albedo: f32,
    /// Longest side of the receiver.
    #[serde(rename = "receiver.size")]
    #[default(0.6)]
    #[schemars(range(min = 0.01, max = 1.8), extend("unit" = "m"))]
    size: f32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

impl Recipe for Furnace {
    type Settings = Settings;
    const NAME: &'static str = "furnace";
    const SUMMARY: &'static str =
        "closed room of uniform emission around a receiver: irradiance is π at unoccluded points";

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
