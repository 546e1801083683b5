//! The built-in scenes, one file each.
//!
//! A scene is a `Recipe`: a name, a line about it, settings declared as
//! [`crate::params`] are, and a function that builds it. Adding one is one file and one line in [`library`].

mod cave;
mod colored_room;
mod cornell_box;
mod divided_room;
mod dragons;
mod furnace;
mod pit;
pub(crate) mod receiver;
mod room;
mod sky;
mod studio;
#[cfg(test)]
mod tests;

pub use receiver::RECEIVERS;

use crate::params::{self, FieldInfo, Params, Value};
use crate::{Scene, SceneError, SceneRequest};

/// What makes a scene of the library.
trait Recipe {
    /// Its settings, named as on the command line without the leading `scene.`.
    type Settings: Params;
    /// Its name on the command line.
    const NAME: &'static str;
    /// One line about it.
    const SUMMARY: &'static str;
    /// How many receivers it takes at most.
    const RECEIVERS: usize = 1;
    /// Whether it is small enough to be measured where no scene is named.
    const BENCHED: bool = true;
    /// Builds it; `receivers` are those asked for, at most [`Self::RECEIVERS`].
    fn build(settings: &Self::Settings, receivers: &[String]) -> Result<Scene, SceneError>;
}

/// Settings, and the value of each.
type SettingValues = Vec<(FieldInfo, Value)>;

/// A scene of the library, its type erased.
#[derive(Clone, Copy, Debug)]
pub struct LibraryScene {
    /// Name on the command line.
    pub name: &'static str,
    /// One line about it.
    pub summary: &'static str,
    /// How many receivers it takes at most.
    pub receivers: usize,
    /// Whether it is small enough to be measured, by every method, where no scene is named.
    pub benched: bool,
    values: fn(&SceneRequest) -> Result<SettingValues, SceneError>,
    open: fn(&SceneRequest) -> Result<Scene, SceneError>,
}

impl LibraryScene {
    const fn of<R: Recipe>() -> Self {
        Self {
            name: R::NAME,
            summary: R::SUMMARY,
            receivers: R::RECEIVERS,
            benched: R::BENCHED,
            values: SceneRequest::values_of::<R::Settings>,
            open: |request| {
                request.at_most(R::RECEIVERS, R::NAME)?;
                R::build(&request.settings()?, &request.receivers)
            },
        }
    }

    /// The scene's settings with their defaults.
    pub fn settings(&self) -> Vec<(FieldInfo, Value)> {
        let defaults = self.values(&SceneRequest::new(self.name));
        defaults.expect("nothing is refused where nothing is asked for")
    }

    /// The scene's settings with their values, as asked for or by default.
    pub(crate) fn values(&self, request: &SceneRequest) -> Result<SettingValues, SceneError> {
        (self.values)(request)
    }

    /// Builds the scene; environment and reference point of the request are left to the caller.
    pub(crate) fn open(&self, request: &SceneRequest) -> Result<Scene, SceneError> {
        (self.open)(request)
    }
}

const LIBRARY: &[LibraryScene] = &[
    LibraryScene::of::<cornell_box::CornellBox>(),
    LibraryScene::of::<colored_room::ColoredRoom>(),
    LibraryScene::of::<divided_room::DividedRoom>(),
    LibraryScene::of::<studio::Studio>(),
    LibraryScene::of::<furnace::Furnace>(),
    LibraryScene::of::<cave::Cave>(),
    LibraryScene::of::<pit::Pit>(),
    LibraryScene::of::<dragons::Dragons>(),
];

/// The built-in scenes.
pub fn library() -> &'static [LibraryScene] {
    LIBRARY
}

/// The built-in scene of a name.
///
/// # Errors
/// [`SceneError::UnknownScene`] names the nearest one.
pub fn find(name: &str) -> Result<&'static LibraryScene, SceneError> {
    let names = || LIBRARY.iter().map(|s| s.name);
    LIBRARY
        .iter()
        .find(|s| s.name == name)
        .ok_or_else(|| SceneError::UnknownScene {
            name: name.into(),
            hint: params::nearest(name, names())
                .map(|n| format!(", did you mean `{n}`?"))
                .unwrap_or_default(),
            known: names().collect::<Vec<_>>().join(", "),
        })
}
