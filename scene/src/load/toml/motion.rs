//! `motion` of meshes, lights and the camera.

use super::Vector;
use super::mesh::turned;
use super::source::{Key, Source};
use crate::SceneError;
use crate::motion::{CameraMotion, Deformation, DeformationKind, LightMotion, Motion, Pose, Track};
use glam::Vec3;
use serde::Deserialize;
use toml::Spanned;

/// `motion` of a `[[mesh]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshMotionTable {
    keyframes: Option<Spanned<Vec<PoseTable>>>,
    deformation: Option<DeformationKind>,
    period_s: Option<Spanned<f32>>,
    amount: Option<Spanned<f32>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PoseTable {
    time: Spanned<f32>,
    translate: Option<Vector>,
    rotate_deg: Option<Vector>,
    scale: Option<Spanned<f32>>,
}

/// `[camera.motion]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraMotionTable {
    keyframes: Option<Spanned<Vec<ViewTable>>>,
    orbit_deg_per_s: Option<Spanned<f32>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ViewTable {
    time: Spanned<f32>,
    eye: Option<Vector>,
    target: Option<Vector>,
}

/// `motion` of a `[[light]]`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightMotionTable {
    keyframes: Spanned<Vec<AimTable>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct AimTable {
    time: Spanned<f32>,
    position: Option<Vector>,
    direction: Option<Vector>,
    normal: Option<Vector>,
}

impl MeshMotionTable {
    pub(super) fn load(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
    ) -> Result<Motion, SceneError> {
        if self.keyframes.is_none() && self.deformation.is_none() {
            let what = "a mesh's motion needs `keyframes` or `deformation`";
            return Err(source.at(whole).error(what, "give one of them, or both"));
        }
        let poses = match &self.keyframes {
            Some(keyframes) => track(source, keyframes, |k| &k.time, |k| k.pose(source))?,
            None => Track::default(),
        };
        Ok(Motion {
            poses,
            deformation: self.deformation(source)?,
            ..Motion::default()
        })
    }

    fn deformation(&self, source: &Source<'_>) -> Result<Option<Deformation>, SceneError> {
        let Some(kind) = self.deformation else {
            let given = [
                Key::of("period_s", &self.period_s),
                Key::of("amount", &self.amount),
            ];
            source.only(given, &[], "a motion without `deformation`")?;
            return Ok(None);
        };
        let mut deformation = Deformation::new(kind);
        if let Some(period) = &self.period_s {
            deformation.period_s = source.positive("period_s", period)?;
        }
        if let Some(amount) = &self.amount {
            let largest = kind.largest_amount();
            deformation.amount = source.within("amount", amount, 0.0, largest)?;
        }
        Ok(Some(deformation))
    }
}

impl PoseTable {
    fn pose(&self, source: &Source<'_>) -> Result<Pose, SceneError> {
        let vector =
            |key, v: &Option<Vector>| v.as_ref().map_or(Ok(Vec3::ZERO), |v| source.vector(key, v));
        let [least, most] = Pose::SCALES;
        Ok(Pose {
            translate: vector("translate", &self.translate)?,
            rotate: turned(vector("rotate_deg", &self.rotate_deg)?.map(f32::to_radians)),
            scale: match &self.scale {
                Some(scale) => source.within("scale", scale, least, most)?,
                None => 1.0,
            },
        })
    }
}

impl CameraMotionTable {
    /// The motion of a camera that rests with this eye and target.
    pub(super) fn load(
        &self,
        source: &Source<'_>,
        whole: &Spanned<Self>,
        rest: [Vec3; 2],
    ) -> Result<CameraMotion, SceneError> {
        let view = |k: &ViewTable| {
            let vector = |key, v: &Option<Vector>, rest| {
                v.as_ref().map_or(Ok(rest), |v| source.vector(key, v))
            };
            let [eye, target] = rest;
            Ok([
                vector("eye", &k.eye, eye)?,
                vector("target", &k.target, target)?,
            ])
        };
        match (&self.keyframes, &self.orbit_deg_per_s) {
            (Some(keyframes), None) => {
                let track = track(source, keyframes, |k| &k.time, view)?;
                Ok(CameraMotion::Keyframes(track))
            }
            (None, Some(speed)) => Ok(CameraMotion::Orbit {
                deg_per_s: source.number("orbit_deg_per_s", speed)?,
            }),
            _ => {
                let what = "the camera's motion needs either `keyframes` or `orbit_deg_per_s`";
                Err(source.at(whole).error(what, "give one of them"))
            }
        }
    }
}

impl LightMotionTable {
    /// The motion of a light that takes only these keys of keyframes.
    pub(super) fn load(
        &self,
        source: &Source<'_>,
        called: &str,
        allowed: &[&str],
    ) -> Result<LightMotion, SceneError> {
        let keyframes = &self.keyframes;
        for key in keyframes.get_ref() {
            let given = [
                Key::of("position", &key.position),
                Key::of("direction", &key.direction),
                Key::of("normal", &key.normal),
            ];
            let remaining: Vec<_> = ["position", "direction", "normal"]
                .into_iter()
                .filter(|key| allowed.contains(key))
                .collect();
            source.only(given, &remaining, &format!("the motion of {called}"))?;
        }
        // A keyframe that leaves something out leaves it to its neighbours.
        let times = track(source, keyframes, |k| &k.time, |_| Ok(()))?;
        let mut motion = LightMotion::default();
        for ((time, ()), key) in times.keys.iter().zip(keyframes.get_ref()) {
            if let Some(position) = &key.position {
                let position = source.vector("position", position)?;
                motion.position.keys.push((*time, position));
            }
            for (name, direction) in [("direction", &key.direction), ("normal", &key.normal)] {
                if let Some(direction) = direction {
                    let direction = source.direction(name, direction)?;
                    motion.direction.keys.push((*time, direction));
                }
            }
        }
        Ok(motion)
    }
}

/// Values at the times of keyframes, which have to increase.
fn track<K, V>(
    source: &Source<'_>,
    keyframes: &Spanned<Vec<K>>,
    time_of: impl Fn(&K) -> &Spanned<f32>,
    value: impl Fn(&K) -> Result<V, SceneError>,
) -> Result<Track<V>, SceneError> {
    let mut keys: Vec<(f32, V)> = Vec::new();
    for keyframe in keyframes.get_ref() {
        let time = time_of(keyframe);
        let time_s = source.number("time", time)?;
        if let Some((last, _)) = keys.last().filter(|(last, _)| *last >= time_s) {
            return Err(source.at(time).error(
                format!("`time` is {time_s:?} after {last:?}"),
                "let the times of keyframes increase",
            ));
        }
        keys.push((time_s, value(keyframe)?));
    }
    match keys.is_empty() {
        false => Ok(Track { keys }),
        true => Err(source.at(keyframes).error(
            "`keyframes` is empty",
            "add a keyframe, such as `{ time = 0 }`",
        )),
    }
}
