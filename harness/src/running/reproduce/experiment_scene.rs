//! Which scene an experiment wants, in the words of the command line.

use super::assets::Model;
use crate::running::settings::{SceneChanges, Setting};
use std::path::PathBuf;

/// A scene and what is to be different in it.
#[derive(Clone, Debug, Default)]
pub(super) struct ExperimentScene {
    pub(super) source: String,
    pub(super) changes: SceneChanges,
    pub(super) settings: Vec<Setting>,
    pub(super) notes: Vec<String>,
}

impl ExperimentScene {
    /// A scene as it comes: a name of the library or a file.
    pub(super) fn of(source: impl Into<String>) -> Self {
        Self {
            source: source.into(),
            ..Self::default()
        }
    }

    /// With a setting, named as on the command line without the leading `scene.`.
    pub(super) fn set(mut self, name: &str, value: impl ToString) -> Self {
        self.settings.push(setting(&format!("scene.{name}"), value));
        self
    }

    /// With one more receiver.
    pub(super) fn with(mut self, model: &Model) -> Self {
        self.changes.receivers.push(model.receiver.clone());
        self.notes.extend(model.note.clone());
        self
    }

    /// With one more receiver, of the library.
    pub(super) fn with_shape(mut self, name: &str) -> Self {
        self.changes.receivers.push(name.into());
        self
    }

    /// Under an environment; the scene's own if there is none.
    pub(super) fn under(mut self, environment: Option<PathBuf>) -> Self {
        self.changes.environment = environment;
        self
    }
}

/// A setting as given on the command line.
pub(super) fn setting(name: &str, value: impl ToString) -> Setting {
    Setting::new(name, value)
}
