//! Scenes from the library, from scene files and from meshes; images and point lists.

pub(crate) mod build;
mod file;
mod framing;
mod image;
pub(crate) mod movement;
mod mtl;
pub(crate) mod obj;
mod points;
#[cfg(test)]
mod tests;
mod text;
mod toml;

pub use file::FileSettings;
pub use image::load as open_image;
pub use points::open_points;

use crate::{Camera, Environment, Light, Place, Scene, SceneError, SceneMotion, library, params};
use build::Parts;
use glam::Vec3;
use movement::Movement;
use params::{FieldInfo, ParamError, Params, Value};
use std::path::{Path, PathBuf};

/// Which scene is wanted, and what is to be different in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneRequest {
    /// Name of a scene of the library, or the path of a `.toml` or `.obj` file.
    pub source: String,
    /// Each `sphere`, `torus`, `blob`, or the path of an `.obj` file. In a scene of the library it
    /// replaces the receiver; in a scene file it replaces all receivers and stands in the middle
    /// of the scene's bounding box. More than one only for scenes that take as many.
    pub receivers: Vec<String>,
    /// An `.hdr` or `.exr` file that becomes the scene's environment.
    pub environment: Option<PathBuf>,
    /// Reference point of cube captures, in metres.
    pub reference_point: Option<Vec3>,
    /// Scene settings, name and value, without the leading `scene.`.
    pub set: Vec<(String, String)>,
}

impl SceneRequest {
    /// A scene as it comes.
    pub fn new(source: impl Into<String>) -> Self {
        Self {
            source: source.into(),
            ..Self::default()
        }
    }

    /// Every setting of the scene with its value: as asked for, or its default.
    ///
    /// # Errors
    /// [`SceneError`] if the scene does not have what is asked for, or does not take the value.
    pub fn values(&self) -> Result<Vec<(FieldInfo, Value)>, SceneError> {
        match self.ending().as_deref() {
            Some("toml" | "obj") => self.values_of::<FileSettings>(),
            _ => library::find(&self.source)?.values(self),
        }
    }

    /// The same of a scene with these settings of its own.
    pub(crate) fn values_of<P: Params>(&self) -> Result<Vec<(FieldInfo, Value)>, SceneError> {
        let mut values = params::values(&self.settings::<P>()?);
        values.extend(params::values(&self.movement()?));
        Ok(values)
    }

    /// The ending of the source's name, in lower case.
    fn ending(&self) -> Option<String> {
        let ending = Path::new(&self.source).extension()?;
        Some(ending.to_str()?.to_ascii_lowercase())
    }

    /// The scene settings as asked for, on top of their defaults; those that every scene has are
    /// left to [`Self::movement`].
    pub(crate) fn settings<P: Params>(&self) -> Result<P, SceneError> {
        let mut settings = P::default();
        let shared = names_of::<Movement>();
        for (name, value) in self.set.iter().filter(|s| !shared.contains(&&*s.0)) {
            params::set(&mut settings, name, value).map_err(|error| match error {
                ParamError::Unknown { .. } => {
                    let own = names_of::<P>();
                    ParamError::unknown(name, own.into_iter().chain(shared.iter().copied()))
                }
                other => other,
            })?;
        }
        Ok(settings)
    }

    /// The settings that every scene has.
    fn movement(&self) -> Result<Movement, SceneError> {
        let mut movement = Movement::default();
        let shared = names_of::<Movement>();
        for (name, value) in self.set.iter().filter(|s| shared.contains(&&*s.0)) {
            params::set(&mut movement, name, value)?;
        }
        Ok(movement)
    }

    /// Refuses more receivers than a scene takes.
    pub(crate) fn at_most(&self, receivers: usize, scene: &str) -> Result<(), SceneError> {
        let given = self.receivers.len();
        match given <= receivers {
            true => Ok(()),
            false => Err(SceneError::Inconsistent {
                scene: scene.into(),
                what: match receivers {
                    0 => "it takes no receiver".into(),
                    n => format!(
                        "it takes {n} receiver{}, not {given}",
                        if n > 1 { "s" } else { "" }
                    ),
                },
                remedy: "leave out `--receiver`, or name fewer".into(),
            }),
        }
    }
}

fn names_of<P: Params>() -> Vec<&'static str> {
    params::fields::<P>().iter().map(|f| f.name).collect()
}

/// Opens a scene.
///
/// # Errors
/// [`SceneError`], one line that says where, what and what to do, for anything that can't be used.
pub fn open(request: &SceneRequest) -> Result<Scene, SceneError> {
    let movement = request.movement()?;
    let path = Path::new(&request.source);
    let ending = request.ending();
    let mut scene = match ending.as_deref() {
        Some("toml") => file::open_toml(path, request)?,
        Some("obj") => file::open_obj(path, request)?,
        _ => library::find(&request.source)?.open(request)?,
    };
    if let Some(path) = &request.environment {
        scene.environment = Some(Environment {
            image: image::load(path)?,
            scale: 1.0,
            rotate_deg: 0.0,
        });
    }
    if let Some(o) = request.reference_point {
        scene.reference_point = o;
    }
    movement.apply(&mut scene)?;
    let from_file = matches!(ending.as_deref(), Some("toml" | "obj"));
    match scene.validate() {
        Ok(()) => Ok(scene),
        Err(SceneError::Inconsistent { what, remedy, .. }) if from_file => {
            Err(Place::file(path).error(what, remedy))
        }
        Err(e) => Err(e),
    }
}

/// What a scene has beside its objects; what is `None` follows from them.
#[derive(Default)]
pub(crate) struct Setting {
    pub(crate) lights: Vec<Light>,
    pub(crate) environment: Option<Environment>,
    pub(crate) camera: Option<Camera>,
    pub(crate) reference_point: Option<Vec3>,
    pub(crate) captured_at: Option<Vec3>,
    pub(crate) motion: SceneMotion,
}

/// Puts a scene together.
pub(crate) fn assemble(name: impl Into<String>, parts: Parts, setting: Setting) -> Scene {
    Scene {
        name: name.into(),
        camera: setting
            .camera
            .unwrap_or_else(|| framing::default_camera(&parts)),
        reference_point: setting
            .reference_point
            .unwrap_or_else(|| parts.default_reference_point()),
        captured_at: setting.captured_at,
        objects: parts.objects,
        materials: parts.materials,
        lights: setting.lights,
        environment: setting.environment,
        motion: setting.motion,
    }
}
