//! Public models and environment maps, where they are, and what takes their place where not.

use std::path::{Path, PathBuf};

/// Names the folder of models instead of `assets/`.
const FOLDER: &str = "INTERREFLECT_ASSETS";

/// Folders that may hold models; the first that has a file gives it.
#[derive(Clone, Debug)]
pub struct Assets {
    folders: Vec<PathBuf>,
}

/// A model, or what stands in for it.
#[derive(Clone, Debug)]
pub(super) struct Model {
    /// What is shown, in words.
    pub(super) name: String,
    /// What a scene is given as its receiver.
    pub(super) receiver: PathBuf,
    /// What is missing, and what takes its place.
    pub(super) note: Option<String>,
}

impl Assets {
    /// The folder that `INTERREFLECT_ASSETS` names; without one `assets/` here, or where the program
    /// was built.
    pub fn find() -> Self {
        if let Some(folder) = std::env::var_os(FOLDER) {
            return Self::within(vec![folder.into()]);
        }
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        Self::within(vec![
            "assets".into(),
            workspace.join("assets"),
            workspace.join("../shared/assets"),
        ])
    }

    /// Models in these folders.
    pub fn within(folders: Vec<PathBuf>) -> Self {
        Self { folders }
    }

    /// A mesh by its name without an ending, or the built-in blob in its place.
    pub(super) fn mesh(&self, name: &str) -> Model {
        match self.file(&format!("meshes/{name}.obj")) {
            Some(path) => Model {
                name: name.into(),
                receiver: path,
                note: None,
            },
            None => Model {
                name: format!("blob (for {name})"),
                receiver: "blob".into(),
                note: Some(format!(
                    "{name}.obj not found, `blob` is used instead; `make assets` downloads the models"
                )),
            },
        }
    }

    /// An environment map by its name without an ending.
    pub(super) fn environment(&self, name: &str) -> Option<PathBuf> {
        ["hdr", "exr"]
            .iter()
            .find_map(|ending| self.file(&format!("envmaps/{name}.{ending}")))
    }

    /// A scene by its name without an ending.
    pub(super) fn scene(&self, name: &str) -> Option<PathBuf> {
        self.file(&format!("scenes/{name}.obj"))
    }

    fn file(&self, name: &str) -> Option<PathBuf> {
        let paths = self.folders.iter().map(|folder| folder.join(name));
        paths.into_iter().find(|path| path.is_file())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_model_is_replaced_and_said_so() {
        let model = Assets::within(Vec::new()).mesh("bunny");
        assert_eq!(model.receiver, Path::new("blob"));
        assert!(
            model
                .note
                .is_some_and(|n| n.starts_with("bunny.obj not found, `blob` is used instead"))
        );
    }
}
