//! A receiver alone under an environment.

use super::receiver::{self, Look};
use super::{Recipe, sky};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::{Camera, Environment, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

pub(super) struct Studio;

#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(super) struct Settings {
    /// Longest side of the receiver.
    #[serde(rename = "receiver.size")]
    #[default(1.0)]
    #[schemars(range(min = 0.01, max = 100.0), extend("unit" = "m"))]
    size: f32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

impl Recipe for Studio {
    type Settings = Settings;
    const NAME: &'static str = "studio";
    const SUMMARY: &'static str =
        "a receiver alone under an environment light: a procedural sky, or any HDR or EXR file";

    fn build(s: &Settings, receivers: &[String]) -> Result<Scene, SceneError> {
        let mut parts = Parts::default();
        let name = receivers.first().map_or("blob", String::as_str);
        receiver::add(
            &mut parts,
            name,
            receiver::model(name, s.size, &s.look)?,
            &s.look,
        );
        let setting = Setting {
            environment: Some(Environment {
                image: sky::sky(),
                scale: 1.0,
                rotate_deg: 0.0,
            }),
            camera: Some(Camera {
                eye: Vec3::new(0.6, 0.22, 1.8) * s.size,
                target: Vec3::ZERO,
                up: Vec3::Y,
                vfov_deg: 35.0,
                resolution: [512, 512],
            }),
            reference_point: Some(Vec3::ZERO),
            ..Setting::default()
        };
        Ok(assemble(Self::NAME, parts, setting))
    }
}
