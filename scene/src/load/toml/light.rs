//! `[[light]]` tables.

mod environment;

use super::motion::LightMotionTable;
use super::source::{Key, Source};
use super::{Lamp, Vector};
use crate::light::upright;
use crate::motion::LightMotion;
use crate::validate::{LARGEST_POWER, is_power};
use crate::{Light, LightPicture, SceneError, SpotShape};
use glam::Vec3;
use serde::Deserialize;
use std::f32::consts::{PI, TAU};
use std::path::PathBuf;
use toml::Spanned;

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Point,
    Spot,
    Directional,
    Area,
    Environment,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Shape {
    Cone,
    Square,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightTable {
    kind: Kind,
    position: Option<Vector>,
    direction: Option<Vector>,
    up: Option<Vector>,
    shape: Option<Spanned<Shape>>,
    angle_deg: Option<Spanned<f32>>,
    intensity: Option<Vector>,
    flux: Option<Vector>,
    irradiance: Option<Vector>,
    normal: Option<Vector>,
    area: Option<Spanned<f32>>,
    picture_direction: Option<Vector>,
    picture_up: Option<Vector>,
    picture_angle_deg: Option<Spanned<f32>>,
    file: Option<Spanned<PathBuf>>,
    constant: Option<Vector>,
    scale: Option<Spanned<f32>>,
    rotate_deg: Option<Spanned<f32>>,
    rotate_deg_per_s: Option<Spanned<f32>>,
    motion: Option<Spanned<LightMotionTable>>,
}

impl Kind {
    /// How messages call it, and the keys that it takes.
    fn keys(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Point => (
                "a point light",
                &[
                    "position",
                    "intensity",
                    "flux",
                    "picture_direction",
                    "picture_up",
                    "picture_angle_deg",
                    "motion",
                ],
            ),
            Self::Spot => (
                "a spot light",
                &[
                    "position",
                    "direction",
                    "up",
                    "shape",
                    "angle_deg",
                    "intensity",
                    "flux",
                    "motion",
                ],
            ),
            Self::Directional => (
                "a directional light",
                &["direction", "irradiance", "motion"],
            ),
            Self::Area => (
                "an area light",
                &[
                    "position",
                    "normal",
                    "area",
                    "flux",
                    "picture_direction",
                    "picture_up",
                    "picture_angle_deg",
                    "motion",
                ],
            ),
            Self::Environment => (
                "an environment light",
                &[
                    "file",
                    "constant",
                    "scale",
                    "rotate_deg",
                    "rotate_deg_per_s",
                ],
            ),
        }
    }
}

impl LightTable {
    /// The light that the table describes; `whole` is the table with its place.
    pub(super) fn load(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
    ) -> Result<Lamp, SceneError> {
        let (called, allowed) = self.kind.keys();
        source.only(self.given(), allowed, called)?;
        let vector = |key: &str, value| source.required(whole, key, value, called);
        let position = || source.vector("position", vector("position", &self.position)?);
        let direction = || source.direction("direction", vector("direction", &self.direction)?);
        let light = match self.kind {
            Kind::Point => Light::Point {
                position: position()?,
                intensity: self.intensity(source, whole, 2.0 * TAU)?,
                picture: self.picture(source)?,
            },
            Kind::Spot => {
                let angle = source.required(whole, "angle_deg", &self.angle_deg, called)?;
                let angle_deg = source.angle("angle_deg", angle)?;
                let shape = self.shape();
                let direction = direction()?;
                Light::Spot {
                    position: position()?,
                    direction,
                    up: up(source, ("up", &self.up), ("direction", direction))?,
                    shape,
                    angle_deg,
                    intensity: self.intensity(source, whole, frustum_sr(shape, angle_deg))?,
                }
            }
            Kind::Directional => Light::Directional {
                direction: direction()?,
                irradiance: source.power("irradiance", vector("irradiance", &self.irradiance)?)?,
            },
            Kind::Area => {
                let area = source.required(whole, "area", &self.area, called)?;
                Light::Area {
                    position: position()?,
                    normal: source.direction("normal", vector("normal", &self.normal)?)?,
                    area_m2: source.positive("area", area)?,
                    flux: source.power("flux", vector("flux", &self.flux)?)?,
                    picture: self.picture(source)?,
                }
            }
            Kind::Environment => {
                let speed = self.rotate_deg_per_s.as_ref();
                let speed = speed.map_or(Ok(0.0), |v| source.number("rotate_deg_per_s", v))?;
                return Ok(Lamp::Environment(self.environment(source, whole)?, speed));
            }
        };
        let motion = match &self.motion {
            Some(table) => table.get_ref().load(source, called, allowed)?,
            None => LightMotion::default(),
        };
        Ok(Lamp::Light(light, motion))
    }

    fn given(&self) -> [Option<Key>; 19] {
        [
            Key::of("position", &self.position),
            Key::of("direction", &self.direction),
            Key::of("up", &self.up),
            Key::of("shape", &self.shape),
            Key::of("angle_deg", &self.angle_deg),
            Key::of("intensity", &self.intensity),
            Key::of("flux", &self.flux),
            Key::of("irradiance", &self.irradiance),
            Key::of("normal", &self.normal),
            Key::of("area", &self.area),
            Key::of("picture_direction", &self.picture_direction),
            Key::of("picture_up", &self.picture_up),
            Key::of("picture_angle_deg", &self.picture_angle_deg),
            Key::of("file", &self.file),
            Key::of("constant", &self.constant),
            Key::of("scale", &self.scale),
            Key::of("rotate_deg", &self.rotate_deg),
            Key::of("rotate_deg_per_s", &self.rotate_deg_per_s),
            Key::of("motion", &self.motion),
        ]
    }

    fn shape(&self) -> SpotShape {
        match self.shape.as_ref().map(Spanned::get_ref) {
            Some(Shape::Square) => SpotShape::Square,
            Some(Shape::Cone) | None => SpotShape::Cone,
        }
    }

    /// Intensity in W/sr, as given or as the flux in W spread over the light's solid angle.
    fn intensity(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
        omega_sr: f32,
    ) -> Result<Vec3, SceneError> {
        match (&self.intensity, &self.flux) {
            (Some(intensity), None) => source.power("intensity", intensity),
            (None, Some(flux)) => {
                let intensity = source.power("flux", flux)? / omega_sr;
                match is_power(intensity) {
                    true => Ok(intensity),
                    false => Err(source.at(flux).error(
                        format!(
                            "`flux` in {omega_sr:e} sr exceeds an intensity of {LARGEST_POWER:e} W/sr"
                        ),
                        "lower it or widen the light's angle",
                    )),
                }
            }
            (Some(_), Some(flux)) => {
                let what = "both `intensity` and `flux` are given";
                Err(source.at(flux).error(what, "keep one"))
            }
            (None, None) => {
                let what = format!("{} needs `intensity` or `flux`", self.kind.keys().0);
                Err(source.at(whole).error(
                    what,
                    "add `intensity = [r, g, b]` in W/sr or `flux = [r, g, b]` in W",
                ))
            }
        }
    }

    /// Where the light takes its picture, if the table says so.
    fn picture(&self, source: &Source<'_>) -> Result<Option<LightPicture>, SceneError> {
        let Some(direction) = &self.picture_direction else {
            let alone = [
                Key::of("picture_up", &self.picture_up),
                Key::of("picture_angle_deg", &self.picture_angle_deg),
            ];
            source.only(alone, &[], "a light without `picture_direction`")?;
            return Ok(None);
        };
        let direction = source.direction("picture_direction", direction)?;
        let angle = self.picture_angle_deg.as_ref();
        Ok(Some(LightPicture {
            direction,
            up: up(
                source,
                ("picture_up", &self.picture_up),
                ("picture_direction", direction),
            )?,
            angle_deg: angle.map_or(Ok(90.0), |v| source.angle("picture_angle_deg", v))?,
        }))
    }
}

/// The upward direction of a view, made orthogonal to its axis; [`upright`] where none is given.
fn up(
    source: &Source<'_>,
    (key, given): (&str, &Option<Vector>),
    (axis_key, axis): (&str, Vec3),
) -> Result<Vec3, SceneError> {
    let Some(given) = given else {
        return Ok(upright(axis));
    };
    let up = source.direction(key, given)?;
    let across = up - axis * up.dot(axis);
    // 1e-4: below it the direction is rounding.
    if across.length() > 1e-4 {
        return Ok(across.normalize());
    }
    let what = format!("`{key}` is parallel to `{axis_key}`");
    Err(source.at(given).error(what, "turn it away"))
}

/// Solid angle of a frustum in sr: 2π(1 − cos h) of a cone, 4·asin(sin² h) of a square pyramid, h
/// half the full angle.
fn frustum_sr(shape: SpotShape, angle_deg: f32) -> f32 {
    let half = 0.5 * angle_deg.to_radians();
    match shape {
        SpotShape::Cone => 2.0 * PI * (1.0 - half.cos()),
        SpotShape::Square => 4.0 * half.sin().powi(2).asin(),
    }
}
