//! How a scene is run, declared as parameters are: an axis of every figure is one.

use crate::running::error::RunError;
use interreflect_scene::params::{self, Field, Params};

/// Points of a scene if none are asked for.
const POINTS: u32 = 4096;

/// Settings of the run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RunSettings {
    /// Points on the receivers.
    pub(crate) points: u32,
    /// Threads of the CPU backend; 0 = all.
    pub(crate) threads: u32,
}

impl Default for RunSettings {
    fn default() -> Self {
        Self {
            points: POINTS,
            threads: 0,
        }
    }
}

impl RunSettings {
    /// As the options say.
    ///
    /// # Errors
    /// [`RunError::Param`] if one is out of range.
    pub(crate) fn new(points: Option<usize>, threads: Option<usize>) -> Result<Self, RunError> {
        let mut settings = Self::default();
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

impl Params for RunSettings {
    fn fields() -> Vec<Field<Self>> {
        vec![
            Field::u32(
                "points",
                "number of points on the receivers",
                1..=1 << 26,
                |s: &Self| s.points,
                |s, v| s.points = v,
            )
            .log(),
            Field::u32(
                "threads",
                "threads of the CPU backend; 0 = all",
                0..=1024,
                |s: &Self| s.threads,
                |s, v| s.threads = v,
            )
            .log(),
        ]
    }
}
