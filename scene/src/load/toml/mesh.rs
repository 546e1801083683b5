//! `[[mesh]]` tables.

use super::Vector;
use super::motion::MeshMotionTable;
use super::source::{Key, Source};
use crate::load::build::Model;
use crate::load::obj::{self, MissingNormals};
use crate::shapes::{self, Facing};
use crate::validate::is_physical;
use crate::{Material, Mesh, Motion, Role, SceneError};
use glam::{Quat, Vec3};
use serde::Deserialize;
use std::path::PathBuf;
use toml::Spanned;

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum RoleName {
    Environment,
    Receiver,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Shape {
    Quad,
    Box,
    Sphere,
    Torus,
    Blob,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshTable {
    name: Option<String>,
    file: Option<Spanned<PathBuf>>,
    shape: Option<Shape>,
    size: Option<Spanned<Vec<f32>>>,
    radius: Option<Spanned<f32>>,
    tube: Option<Spanned<f32>>,
    inward: Option<Spanned<bool>>,
    role: Option<RoleName>,
    translate: Option<Vector>,
    rotate_deg: Option<Vector>,
    scale: Option<Spanned<f32>>,
    fit: Option<Spanned<f32>>,
    material: Option<Spanned<MaterialTable>>,
    motion: Option<Spanned<MeshMotionTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MaterialTable {
    albedo: Option<Vector>,
    specular: Option<Vector>,
    shininess: Option<Spanned<f32>>,
    emission: Option<Vector>,
    mirror: Option<bool>,
}

/// Material of meshes that name none.
const GREY: f32 = 0.7;

impl MeshTable {
    /// Name, role and model of the mesh in world space, and its motion; `whole` is the table with its place.
    pub(super) fn load(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
    ) -> Result<(String, Role, Model, Option<Motion>), SceneError> {
        let role = match self.role {
            Some(RoleName::Receiver) => Role::Receiver,
            Some(RoleName::Environment) | None => Role::Environment,
        };
        let mut model = self.model(source, whole, role)?;
        if let Some(table) = &self.material {
            for material in &mut model.materials {
                table.get_ref().apply(source, table, material)?;
            }
        }
        if let Some(fit) = &self.fit {
            model = model.fitted(source.positive("fit", fit)?).ok_or_else(|| {
                source
                    .at(fit)
                    .error("the mesh has no extent to be fitted", "remove `fit`")
            })?;
        }
        let vector =
            |key, v: &Option<Vector>| v.as_ref().map_or(Ok(Vec3::ZERO), |v| source.vector(key, v));
        let turn = vector("rotate_deg", &self.rotate_deg)?.map(f32::to_radians);
        let scale = self
            .scale
            .as_ref()
            .map_or(Ok(1.0), |s| source.positive("scale", s))?;
        let model = model.placed(vector("translate", &self.translate)?, turned(turn), scale);
        let motion = self.motion.as_ref();
        let motion = motion.map(|m| m.get_ref().load(source, m)).transpose()?;
        Ok((self.name(), role, model, motion))
    }

    fn name(&self) -> String {
        let stem = || {
            Some(
                self.file
                    .as_ref()?
                    .get_ref()
                    .file_stem()?
                    .to_string_lossy()
                    .into(),
            )
        };
        self.name
            .clone()
            .or_else(stem)
            .or_else(|| self.shape.map(|s| s.keys().0.into()))
            .unwrap_or_default()
    }

    fn model(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
        role: Role,
    ) -> Result<Model, SceneError> {
        let given = [
            Key::of("size", &self.size),
            Key::of("radius", &self.radius),
            Key::of("tube", &self.tube),
            Key::of("inward", &self.inward),
        ];
        let grey = Material::diffuse(Vec3::splat(GREY));
        match (&self.file, self.shape) {
            (Some(file), None) => {
                source.only(given, &[], "a mesh from a file")?;
                let missing = match role {
                    Role::Receiver => MissingNormals::Smooth,
                    Role::Environment => MissingNormals::Flat,
                };
                obj::load(&source.path_of(file)?, grey, missing)
            }
            (None, Some(shape)) => {
                let (name, allowed) = shape.keys();
                source.only(given, allowed, &format!("the shape `{name}`"))?;
                Ok(Model::uniform(self.shape(source, shape)?, grey))
            }
            _ => {
                let what = "a mesh needs either `file` or `shape`";
                Err(source.at(whole).error(what, "give one of them"))
            }
        }
    }

    fn shape(&self, source: &Source<'_>, shape: Shape) -> Result<Mesh, SceneError> {
        let length = |key, value: &Option<Spanned<f32>>, default| {
            value
                .as_ref()
                .map_or(Ok(default), |v| source.positive(key, v))
        };
        Ok(match shape {
            Shape::Quad => {
                let [width, depth] = self.size(source)?;
                shapes::quad(width, depth)
            }
            Shape::Box => {
                let facing = match self.inward.as_ref().is_some_and(|v| *v.get_ref()) {
                    true => Facing::Inward,
                    false => Facing::Outward,
                };
                shapes::cuboid(Vec3::from(self.size::<3>(source)?), facing)
            }
            Shape::Sphere => shapes::sphere(length("radius", &self.radius, 0.5)?, 24),
            Shape::Torus => shapes::torus(
                length("radius", &self.radius, 0.35)?,
                length("tube", &self.tube, 0.15)?,
                96,
            ),
            Shape::Blob => {
                let radius = length("radius", &self.radius, 0.5)?;
                Model::uniform(shapes::blob(), Material::diffuse(Vec3::ZERO))
                    .placed(Vec3::ZERO, Quat::IDENTITY, radius)
                    .mesh
            }
        })
    }

    /// The edges of a quad or box in metres, 1 if not given.
    fn size<const N: usize>(&self, source: &Source<'_>) -> Result<[f32; N], SceneError> {
        let Some(size) = &self.size else {
            return Ok([1.0; N]);
        };
        let given = size.get_ref();
        <[f32; N]>::try_from(given.as_slice())
            .ok()
            .filter(|s| s.iter().all(|v| v.is_finite() && *v > 0.0))
            .ok_or_else(|| {
                source.at(size).error(
                    format!("`size` is {given:?}"),
                    format!("give {N} numbers above 0"),
                )
            })
    }
}

impl Shape {
    /// Its name in scene files and the keys that it takes.
    fn keys(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Quad => ("quad", &["size"]),
            Self::Box => ("box", &["size", "inward"]),
            Self::Sphere => ("sphere", &["radius"]),
            Self::Torus => ("torus", &["radius", "tube"]),
            Self::Blob => ("blob", &["radius"]),
        }
    }
}

/// Turned about the fixed axes x, then y, then z; angles in radians.
pub(super) fn turned(angles: Vec3) -> Quat {
    Quat::from_rotation_z(angles.z)
        * Quat::from_rotation_y(angles.y)
        * Quat::from_rotation_x(angles.x)
}

impl MaterialTable {
    /// Overrides what is given. A mirror whose `specular` is not given reflects everything.
    fn apply(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
        material: &mut Material,
    ) -> Result<(), SceneError> {
        if let Some(mirror) = self.mirror {
            material.mirror = mirror;
            if mirror {
                material.specular = Vec3::ONE;
            }
        }
        if let Some(v) = &self.albedo {
            material.albedo = source.reflectance("albedo", v)?;
        }
        if let Some(v) = &self.specular {
            material.specular = source.reflectance("specular", v)?;
        }
        if let Some(v) = &self.shininess {
            material.shininess = source.not_negative("shininess", v)?;
        }
        if let Some(v) = &self.emission {
            material.emission = source.power("emission", v)?;
        }
        match is_physical(material) {
            true => Ok(()),
            false => Err(source.at(whole).error(
                format!(
                    "the surface reflects more than it receives: albedo {} + specular {} exceeds 1",
                    material.albedo, material.specular
                ),
                "lower one of them",
            )),
        }
    }
}
