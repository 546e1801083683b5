//! Scenes of experiments as data.

use serde::{Serialize, Serializer};
use std::fmt;

/// A scene as an experiment names it; as text `room bunny under sky receiver.size=0.5`.
#[derive(Clone, Copy, Debug)]
pub(super) struct SceneSetup {
    /// A scene of the library, or of the models' folder.
    pub(super) source: &'static str,
    /// Its receivers by name.
    pub(super) models: &'static [&'static str],
    /// A public environment map by name.
    pub(super) environment: Option<&'static str>,
    /// Settings, named as on the command line without the leading `scene.`.
    pub(super) settings: &'static [(&'static str, &'static str)],
}

impl SceneSetup {
    /// A scene as it comes.
    pub(super) const fn of(source: &'static str) -> Self {
        Self {
            source,
            models: &[],
            environment: None,
            settings: &[],
        }
    }

    /// With these receivers.
    pub(super) const fn with(self, models: &'static [&'static str]) -> Self {
        Self { models, ..self }
    }

    /// Under an environment map.
    pub(super) const fn under(self, environment: &'static str) -> Self {
        Self {
            environment: Some(environment),
            ..self
        }
    }

    /// With these settings.
    pub(super) const fn set(self, settings: &'static [(&'static str, &'static str)]) -> Self {
        Self { settings, ..self }
    }
}

impl fmt::Display for SceneSetup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.source)?;
        self.models
            .iter()
            .try_for_each(|model| write!(f, " {model}"))?;
        if let Some(environment) = self.environment {
            write!(f, " under {environment}")?;
        }
        let mut settings = self.settings.iter();
        settings.try_for_each(|(name, value)| write!(f, " {name}={value}"))
    }
}

impl Serialize for SceneSetup {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_told_in_one_line() {
        let scene = SceneSetup::of("studio")
            .with(&["bunny"])
            .under("sky")
            .set(&[("receiver.size", "0.5")]);
        assert_eq!(
            scene.to_string(),
            "studio bunny under sky receiver.size=0.5"
        );
        assert_eq!(SceneSetup::of("cave").to_string(), "cave");
    }
}
