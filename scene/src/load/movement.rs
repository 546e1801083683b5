//! Settings that every scene has: what can be set in motion whatever the scene says.

use crate::motion::CameraMotion;
use crate::params::{Field, Params};
use crate::{Scene, SceneError};

/// Motions that a request adds; 0 leaves what the scene says.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Movement {
    orbit_deg_per_s: f32,
    turn_deg_per_s: f32,
}

impl Params for Movement {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::f32(
                "camera.orbit_deg_per_s",
                "speed of the camera around its target; 0 leaves it as the scene says",
                -3600.0..=3600.0,
                |m: &Self| m.orbit_deg_per_s,
                |m, v| m.orbit_deg_per_s = v,
            )
            .unit("°/s"),
            Field::f32(
                "environment.turn_deg_per_s",
                "speed of the environment about +y, if there is one; 0 leaves it as the scene says",
                -3600.0..=3600.0,
                |m: &Self| m.turn_deg_per_s,
                |m, v| m.turn_deg_per_s = v,
            )
            .unit("°/s"),
        ]
    }
}

impl Movement {
    /// Sets a scene in motion.
    pub(super) fn apply(&self, scene: &mut Scene) -> Result<(), SceneError> {
        if self.orbit_deg_per_s != 0.0 {
            scene.motion.camera = Some(CameraMotion::Orbit {
                deg_per_s: self.orbit_deg_per_s,
            });
        }
        if self.turn_deg_per_s != 0.0 {
            if scene.environment.is_none() {
                return Err(SceneError::Inconsistent {
                    scene: scene.name.clone(),
                    what: "it has no environment that could turn".into(),
                    remedy: "leave out scene.environment.turn_deg_per_s, or give it an environment"
                        .into(),
                });
            }
            scene.motion.environment_deg_per_s = self.turn_deg_per_s;
        }
        Ok(())
    }
}
