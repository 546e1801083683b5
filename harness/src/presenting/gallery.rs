//! The linear images of a campaign, in the folder of its results.

use super::output::{Header, write_exr};
use crate::domain::files::FileError;
use crate::domain::record::Run;
use crate::running::campaign::Images;
use crate::running::view::View;
use interreflect_conformance::own_model::ModelValues;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;
use std::path::{Path, PathBuf};

/// Name of the file that holds a row's truth.
pub(crate) const TRUTH: &str = "truth.exr";

/// Linear images, written as they come, so that a campaign that was stopped leaves what it had.
pub(crate) struct Gallery {
    /// The folder of the results; without one, no images are kept.
    folder: Option<PathBuf>,
    /// What all images have in common.
    header: Header,
}

impl Gallery {
    /// A gallery without images.
    pub(crate) fn new(folder: Option<&Path>, header: Header) -> Self {
        Self {
            folder: folder.map(Into::into),
            header,
        }
    }
}

impl Images for Gallery {
    fn truth(
        &self,
        scene: &str,
        quantity: Quantity,
        view: &View,
        truth: &ModelValues,
    ) -> Result<(), FileError> {
        let Some(folder) = &self.folder else {
            return Ok(());
        };
        let header = self.header.clone().of_quantity(scene, quantity.name());
        write_exr(
            &folder.join(folder_of(scene, quantity.name())).join(TRUTH),
            &view.image(&truth.values),
            Some(&view.surfaces()),
            &header.with("reference", &truth.description),
        )
    }

    fn estimate(
        &self,
        name: &str,
        run: &mut Run,
        view: &View,
        estimate: &Estimate,
    ) -> Result<(), FileError> {
        let Some(folder) = &self.folder else {
            return Ok(());
        };
        let file = format!("{}/{name}.exr", folder_of(&run.scene, &run.quantity));
        let image = view.image(estimate);
        let header = self.header.clone().of_run(run);
        write_exr(&folder.join(&file), &image, Some(&view.surfaces()), &header)?;
        run.image = Some(file);
        Ok(())
    }
}

/// The folder of the images of a scene and quantity, relative to that of the results.
pub(crate) fn folder_of(scene: &str, quantity: &str) -> String {
    format!("images/{scene}/{quantity}")
}
