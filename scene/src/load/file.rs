//! Scenes from files: `.toml`, and `.obj` as it is.

use super::build::{Parts, bounds_of};
use super::obj::{self, MissingNormals};
use super::{SceneRequest, Setting, assemble, toml};
use crate::library::receiver::{self, Look};
use crate::{Material, Place, Role, Scene, SceneError};
use glam::Vec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::path::Path;

/// Most characters of a scene's name: names of results add to it, and file systems stop at 255.
const MAX_NAME: usize = 100;

/// Settings of scenes that come from a file: the receiver that is added on request.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub struct FileSettings {
    /// Longest side of an added receiver, relative to the scene's shortest.
    #[serde(rename = "receiver.fraction")]
    #[default(0.3)]
    #[schemars(range(min = 0.001, max = 1.0))]
    fraction: f32,
    /// How the receiver reflects and moves.
    #[serde(flatten)]
    look: Look,
}

/// Opens a scene file.
pub(super) fn open_toml(path: &Path, request: &SceneRequest) -> Result<Scene, SceneError> {
    let mut file = toml::read(path)?;
    add_receiver(&mut file.parts, request)?;
    if file.parts.objects.is_empty() {
        let what = "there is no mesh in the scene";
        return Err(Place::file(path).error(what, "add a `[[mesh]]` table"));
    }
    let name = match file.name {
        Some(name) => name,
        None => name_from(path)?,
    };
    Ok(assemble(name, file.parts, file.setting))
}

/// Opens an OBJ file as a scene: one object, its faces flat unless it brings normals.
pub(super) fn open_obj(path: &Path, request: &SceneRequest) -> Result<Scene, SceneError> {
    let name = name_from(path)?;
    let grey = Material::diffuse(Vec3::splat(0.7));
    let mut parts = Parts::default();
    parts.add(
        name.clone(),
        Role::Environment,
        obj::load(path, grey, MissingNormals::Flat)?,
    );
    add_receiver(&mut parts, request)?;
    Ok(assemble(name, parts, Setting::default()))
}

/// A scene that is not named is called like its file.
fn name_from(path: &Path) -> Result<String, SceneError> {
    let name = path.file_stem().unwrap_or(path.as_os_str());
    let name = name.to_string_lossy();
    match name_fault(&name) {
        None => Ok(name.into()),
        Some(fault) => {
            let what = format!("the file's name as the scene's {fault}");
            Err(Place::file(path).error(what, "rename the file"))
        }
    }
}

/// What keeps a scene's name from being a part of file names.
pub(super) fn name_fault(name: &str) -> Option<&'static str> {
    let breaks = |c: char| matches!(c, '/' | '\\') || c.is_control();
    match name {
        "" => Some("is empty"),
        _ if name.chars().count() > MAX_NAME => Some("is longer than 100 characters"),
        _ if name.starts_with('.') => Some("starts with a dot"),
        _ if name.contains(breaks) => Some("has a slash, a backslash or a control character"),
        _ => None,
    }
}

/// Replaces the receivers by the one asked for, in the middle of the other objects' bounding box.
fn add_receiver(parts: &mut Parts, request: &SceneRequest) -> Result<(), SceneError> {
    let settings: FileSettings = request.settings()?;
    request.at_most(1, &request.source)?;
    let Some(name) = request.receivers.first() else {
        return Ok(());
    };
    parts.objects.retain(|o| o.role != Role::Receiver);
    let (lo, hi) = bounds_of(&parts.objects).unwrap_or((Vec3::splat(-0.5), Vec3::splat(0.5)));
    let sides = (hi - lo).to_array();
    // A flat scene's shortest side is the shortest that is there at all.
    let shortest = sides
        .into_iter()
        .filter(|s| *s > 0.0)
        .fold(f32::INFINITY, f32::min);
    let model = receiver::model(name, settings.fraction * shortest, &settings.look)?;
    let model = model.moved(0.5 * lo + 0.5 * hi);
    receiver::add(parts, name, model, &settings.look);
    Ok(())
}
