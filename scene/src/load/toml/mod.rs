//! Scene files in TOML.
//!
//! ```toml
//! name = "my-room"                       # default: the file's name
//! reference_point = [0.0, 0.0, 0.0]      # default: centre of the receivers' box, or of the scene's
//! captured_at = [0.0, 0.0, 0.0]          # where captures were made that may be kept; default: none are
//! [camera]                               # default: see the whole scene
//! eye = [0.0, 0.0, 3.0]
//! target = [0.0, 0.0, 0.0]
//! up = [0.0, 1.0, 0.0]                   # default
//! vfov_deg = 45.0                        # default
//! resolution = [512, 512]                # default
//! [camera.motion]                        # default: it stands still; one of
//! keyframes = [{ time = 0.0, eye = [0.0, 0.0, 3.0], target = [0.0, 0.0, 0.0] }]
//! # orbit_deg_per_s = 20.0               # the eye about the target, around `up`
//! [[mesh]]
//! file = "room.obj"                      # relative to this file; or
//! # shape = "quad" (size = [w, d]) | "box" (size = [x, y, z], inward = true) | "sphere" (radius)
//! #       | "torus" (radius, tube) | "blob" (radius): each about a metre across by default
//! role = "environment"                   # default; or "receiver"
//! fit = 1.0                              # first: longest side, centred at the origin
//! scale = 1.0                            # then scaled,
//! rotate_deg = [0.0, 0.0, 0.0]           # turned about the fixed axes x, then y, then z,
//! translate = [0.0, 0.0, 0.0]            # and moved
//! material = { albedo = [0.7, 0.7, 0.7], specular = [0.0, 0.0, 0.0], shininess = 5.0, emission = [0.0, 0.0, 0.0], mirror = false }
//! [mesh.motion]                          # default: it stands still; both of
//! # linear between keyframes, turns the short way, held before the first and after the last; about
//! # the centre of the mesh's bounding box
//! keyframes = [{ time = 0.0, translate = [0.0, 0.0, 0.0], rotate_deg = [0.0, 0.0, 0.0], scale = 1.0 }]
//! deformation = "twist"                  # or "wave", "breathe": before the keyframes, at rest at time 0
//! period_s = 2.0                         # default
//! amount = 0.8                           # of half the mesh's longest side, for a twist in radians
//! [[light]]                              # kind is one of
//! kind = "point"                         # position; intensity in W/sr or flux in W
//! # "spot": also direction, up, shape = "cone" | "square", angle_deg (full angle); flux is that
//! #         inside the frustum
//! # "directional": direction, irradiance in W/m²
//! # "area": position, normal, area in m², flux in W
//! # "environment": file (.hdr, .exr) or constant = [r, g, b]; scale, rotate_deg, rotate_deg_per_s
//! position = [0.0, 0.9, 0.0]
//! intensity = [1.0, 1.0, 1.0]
//! # position, direction and normal, where the light has them:
//! motion = { keyframes = [{ time = 0.0, position = [0.0, 0.9, 0.0] }] }
//! ```

mod light;
mod mesh;
mod motion;
mod source;

use super::build::Parts;
use super::{Setting, text};
use crate::motion::{CameraMotion, LightMotion, camera_fault};
use crate::{Camera, Environment, Light, SceneError};
use glam::Vec3;
use light::LightTable;
use mesh::MeshTable;
use motion::CameraMotionTable;
use serde::Deserialize;
use source::Source;
use std::path::Path;
use toml::Spanned;

type Vector = Spanned<[f32; 3]>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneTable {
    name: Option<Spanned<String>>,
    reference_point: Option<Vector>,
    captured_at: Option<Vector>,
    camera: Option<Spanned<CameraTable>>,
    #[serde(default)]
    mesh: Vec<Spanned<MeshTable>>,
    #[serde(default)]
    light: Vec<Spanned<LightTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraTable {
    eye: Vector,
    target: Vector,
    up: Option<Vector>,
    vfov_deg: Option<Spanned<f32>>,
    resolution: Option<Spanned<[u32; 2]>>,
    motion: Option<Spanned<CameraMotionTable>>,
}

/// What one `[[light]]` is.
enum Lamp {
    Light(Light, LightMotion),
    /// With its speed of turning in degrees per second.
    Environment(Environment, f32),
}

/// What a scene file says.
pub(super) struct SceneFile {
    pub(super) name: Option<String>,
    pub(super) parts: Parts,
    pub(super) setting: Setting,
}

/// Reads a scene file and all that it names.
pub(super) fn read(path: &Path) -> Result<SceneFile, SceneError> {
    let text = text::read(path)?;
    let source = Source { path, text: &text };
    let table: SceneTable = toml::from_str(&text).map_err(|e| source.refused(&e))?;
    let mut parts = Parts::default();
    for mesh in &table.mesh {
        let (name, role, model, motion) = mesh.get_ref().load(&source, mesh)?;
        parts.add_moving(name, role, model, motion);
    }
    let mut setting = Setting {
        reference_point: table
            .reference_point
            .map(|o| source.vector("reference_point", &o))
            .transpose()?,
        captured_at: table
            .captured_at
            .map(|o| source.vector("captured_at", &o))
            .transpose()?,
        ..Setting::default()
    };
    if let Some(table) = &table.camera {
        let (camera, motion) = camera(&source, table)?;
        setting.camera = Some(camera);
        setting.motion.camera = motion;
    }
    for light in &table.light {
        match light.get_ref().load(&source, light)? {
            Lamp::Light(light, motion) => {
                setting.lights.push(light);
                setting.motion.lights.push(motion);
            }
            Lamp::Environment(..) if setting.environment.is_some() => {
                let what = "a second environment light";
                return Err(source.at(light).error(what, "keep one"));
            }
            Lamp::Environment(environment, deg_per_s) => {
                setting.environment = Some(environment);
                setting.motion.environment_deg_per_s = deg_per_s;
            }
        }
    }
    Ok(SceneFile {
        name: table.name.map(|n| source.name(n)).transpose()?,
        parts,
        setting,
    })
}

/// The camera and its motion.
fn camera(
    source: &Source<'_>,
    table: &Spanned<CameraTable>,
) -> Result<(Camera, Option<CameraMotion>), SceneError> {
    let place = || source.at(table);
    let table = table.get_ref();
    let up = table.up.as_ref();
    let camera = Camera {
        eye: source.vector("eye", &table.eye)?,
        target: source.vector("target", &table.target)?,
        up: up.map_or(Ok(Vec3::Y), |v| source.direction("up", v))?,
        vfov_deg: table
            .vfov_deg
            .as_ref()
            .map_or(Ok(45.0), |v| source.angle("vfov_deg", v))?,
        resolution: match &table.resolution {
            Some(r) => source.resolution(r)?,
            None => [512, 512],
        },
    };
    let view = camera.target - camera.eye;
    if view == Vec3::ZERO {
        return Err(place().error("`eye` and `target` are the same point", "move one"));
    }
    // 1e-6: below it the image's horizontal axis is rounding.
    if view.normalize().cross(camera.up).length() < 1e-6 {
        let remedy = "turn `up` away from the view direction";
        return Err(place().error("`up` is parallel to the view direction", remedy));
    }
    let Some(table) = &table.motion else {
        return Ok((camera, None));
    };
    let rest = [camera.eye, camera.target];
    let motion = table.get_ref().load(source, table, rest)?;
    match camera_fault(&camera, &motion) {
        None => Ok((camera, Some(motion))),
        Some(fault) => {
            let remedy = "choose other keyframes, or more of them";
            Err(source.at(table).error(fault, remedy))
        }
    }
}
