//! What stands in a scene and is shaded.

use crate::load::build::{Model, Parts};
use crate::load::obj::{self, MissingNormals};
use crate::motion::{Deformation, DeformationKind, Motion};
use crate::{Material, Mesh, Role, SceneError, shapes};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::path::Path;

/// The built-in receivers.
pub const RECEIVERS: [&str; 3] = ["sphere", "torus", "blob"];

/// How a receiver reflects, unless its own file says, and how it moves.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Look {
    /// Diffuse albedo of the receiver.
    #[serde(rename = "receiver.diffuse")]
    #[default(0.6)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "k_d"))]
    diffuse: f32,
    /// Specular albedo of the receiver.
    #[serde(rename = "receiver.specular")]
    #[default(0.3)]
    #[schemars(range(min = 0.0, max = 1.0), extend("symbol" = "k_s"))]
    specular: f32,
    /// Blinn-Phong exponent of the receiver.
    #[serde(rename = "receiver.shininess")]
    #[default(5.0)]
    #[schemars(range(min = 0.0, max = 1000.0), extend("symbol" = "n"))]
    shininess: f32,
    /// Deformation of the receiver, with a period of 2 s.
    #[serde(rename = "receiver.deformation")]
    deformation: Shape,
}

/// Whether a receiver's shape moves, and how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Shape {
    /// It is rigid.
    #[default]
    None,
    /// It moves by this deformation.
    #[serde(untagged)]
    Moving(DeformationKind),
}

/// Adds a receiver that stands in its place.
pub(crate) fn add(parts: &mut Parts, receiver: &str, model: Model, look: &Look) {
    let motion = match look.deformation {
        Shape::None => None,
        Shape::Moving(kind) => Some(Motion {
            deformation: Some(Deformation::new(kind)),
            ..Motion::default()
        }),
    };
    parts.add_moving(name_of(receiver), Role::Receiver, model, motion);
}

/// A receiver's name in messages and reports.
fn name_of(receiver: &str) -> String {
    Path::new(receiver)
        .file_stem()
        .map_or(receiver.into(), |s| s.to_string_lossy().into())
}

/// A receiver at the origin whose longest side is `size` metres, with vertex normals: smoothed by
/// angle where an OBJ file brings none. An OBJ file's materials hold; triangles without one, and
/// the built-in receivers, get the look.
pub(crate) fn model(receiver: &str, size: f32, look: &Look) -> Result<Model, SceneError> {
    let material = Material {
        specular: Vec3::splat(look.specular),
        shininess: look.shininess,
        ..Material::diffuse(Vec3::splat(look.diffuse))
    };
    let model = match built_in(receiver) {
        Some(mesh) => Model::uniform(mesh, material),
        None if receiver.to_ascii_lowercase().ends_with(".obj") => {
            obj::load(Path::new(receiver), material, MissingNormals::Smooth)?
        }
        None => {
            return Err(SceneError::UnknownReceiver {
                name: receiver.into(),
                known: RECEIVERS.join(", "),
            });
        }
    };
    model.fitted(size).ok_or_else(|| SceneError::Inconsistent {
        scene: receiver.into(),
        what: "the receiver's size is out of the range of numbers".into(),
        remedy: "scale the mesh to an ordinary size".into(),
    })
}

fn built_in(receiver: &str) -> Option<Mesh> {
    match receiver {
        "sphere" => Some(shapes::sphere(1.0, 32)),
        "torus" => Some(shapes::torus(0.7, 0.3, 160)),
        "blob" => Some(shapes::blob()),
        _ => None,
    }
}
