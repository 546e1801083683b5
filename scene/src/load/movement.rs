//! Settings that every scene has: what can be set in motion whatever the scene says.

use crate::motion::CameraMotion;
use crate::{Scene, SceneError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Motions that a request adds; 0 leaves what the scene says.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(crate) struct Movement {
    /// Speed of the camera around its target; 0 leaves it as the scene says.
    #[serde(rename = "camera.orbit_deg_per_s")]
    #[default(0.0)]
    #[schemars(range(min = -3600.0, max = 3600.0), extend("unit" = "°/s"))]
    orbit_deg_per_s: f32,
    /// Speed of the environment about +y, if there is one; 0 leaves it as the scene says.
    #[serde(rename = "environment.turn_deg_per_s")]
    #[default(0.0)]
    #[schemars(range(min = -3600.0, max = 3600.0), extend("unit" = "°/s"))]
    turn_deg_per_s: f32,
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
