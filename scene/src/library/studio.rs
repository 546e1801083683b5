//! A receiver alone under an environment.

use super::receiver::{self, Look};
use super::{Recipe, sky};
use crate::load::build::Parts;
use crate::load::{Setting, assemble};
use crate::params::{Field, Params};
use crate::{Camera, Environment, Scene, SceneError};
use glam::Vec3;

pub(super) struct Studio;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    size: f32,
    look: Look,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            size: 1.0,
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
                "longest side of the receiver",
                0.01..=100.0,
                |s: &Self| s.size,
                |s, v| s.size = v,
            )
            .unit("m"),
        ];
        fields.extend(receiver::look_fields());
        fields
    }
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
