//! What stands in a scene and is shaded.

use crate::load::build::{Model, Parts};
use crate::load::obj::{self, MissingNormals};
use crate::motion::{Deformation, DeformationKind, Motion};
use crate::params::{Choice, Field};
use crate::{Material, Mesh, Role, SceneError, shapes};
use glam::Vec3;
use std::path::Path;

/// The built-in receivers.
pub const RECEIVERS: [&str; 3] = ["sphere", "torus", "blob"];

/// How a receiver reflects, unless its own file says, and how it moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Look {
    diffuse: f32,
    specular: f32,
    shininess: f32,
    deformation: Option<DeformationKind>,
}

impl Choice for Option<DeformationKind> {
    const ALL: &'static [(&'static str, Self)] = &[
        ("none", None),
        ("twist", Some(DeformationKind::Twist)),
        ("wave", Some(DeformationKind::Wave)),
        ("breathe", Some(DeformationKind::Breathe)),
    ];
}

impl Default for Look {
    fn default() -> Self {
        Self {
            diffuse: 0.6,
            specular: 0.3,
            shininess: 5.0,
            deformation: None,
        }
    }
}

/// Settings that hold a [`Look`].
pub(crate) trait HasLook {
    fn look(&self) -> &Look;
    fn look_mut(&mut self) -> &mut Look;
}

/// Implements [`HasLook`] for settings with a field `look`.
macro_rules! has_look {
    ($settings:ty) => {
        impl crate::library::receiver::HasLook for $settings {
            fn look(&self) -> &Look {
                &self.look
            }

            fn look_mut(&mut self) -> &mut Look {
                &mut self.look
            }
        }
    };
}
pub(crate) use has_look;

/// The settings of a [`Look`].
pub(crate) fn look_fields<P: HasLook + 'static>() -> Vec<Field<P>> {
    vec![
        Field::f32(
            "receiver.diffuse",
            "diffuse albedo of the receiver",
            0.0..=1.0,
            |p: &P| p.look().diffuse,
            |p, v| p.look_mut().diffuse = v,
        )
        .symbol("k_d"),
        Field::f32(
            "receiver.specular",
            "specular albedo of the receiver",
            0.0..=1.0,
            |p: &P| p.look().specular,
            |p, v| p.look_mut().specular = v,
        )
        .symbol("k_s"),
        Field::f32(
            "receiver.shininess",
            "Blinn-Phong exponent of the receiver",
            0.0..=1000.0,
            |p: &P| p.look().shininess,
            |p, v| p.look_mut().shininess = v,
        )
        .symbol("n"),
        Field::choice(
            "receiver.deformation",
            "how the receiver's shape moves, with a period of 2 s",
            |p: &P| p.look().deformation,
            |p, v| p.look_mut().deformation = v,
        ),
    ]
}

/// Adds a receiver that stands in its place.
pub(crate) fn add(parts: &mut Parts, receiver: &str, model: Model, look: &Look) {
    let motion = look.deformation.map(|kind| Motion {
        deformation: Some(Deformation::new(kind)),
        ..Motion::default()
    });
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
