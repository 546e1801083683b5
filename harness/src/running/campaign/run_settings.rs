//! How a scene is run, declared as parameters are: an axis of every figure is one.

use crate::running::error::RunError;
use crate::running::view::Shade;
use interreflect_scene::params;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;

/// Settings of the run.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
pub(crate) struct RunSettings {
    /// Number of points on the surfaces that are shaded.
    #[default(4096)]
    #[schemars(range(min = 1, max = 1 << 26), extend("scale" = "log"))]
    pub(crate) points: u32,
    /// Surfaces that are shaded: receivers where there are any, or all that the camera sees.
    pub(crate) shade: Shade,
    /// Threads of the CPU backend; 0 = all.
    #[default(0)]
    #[schemars(range(max = 1024), extend("scale" = "log"))]
    pub(crate) threads: u32,
}

impl RunSettings {
    /// As the options say.
    ///
    /// # Errors
    /// [`RunError::Param`] if one is out of range.
    pub(crate) fn new(
        points: Option<usize>,
        shade: Shade,
        threads: Option<usize>,
    ) -> Result<Self, RunError> {
        let mut settings = Self {
            shade,
            ..Self::default()
        };
        for (name, value) in [("points", points), ("threads", threads)] {
            if let Some(value) = value {
                settings.set(name, &value.to_string())?;
            }
        }
        Ok(settings)
    }

    /// Sets one of them.
    ///
    /// # Errors
    /// [`RunError::Param`] if there is no such setting, or it does not take the value.
    pub(crate) fn set(&mut self, name: &str, value: &str) -> Result<(), RunError> {
        params::set(self, name, value).map_err(|error| RunError::Param {
            estimator: "run".into(),
            error,
        })
    }
}
