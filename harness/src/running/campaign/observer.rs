//! Who hears of a campaign, and who keeps its images: what is shown and written is not decided here.

use super::Campaign;
use crate::domain::files::FileError;
use crate::domain::record::Run;
use crate::running::error::RunError;
use crate::running::view::View;
use crate::running::warning::Warning;
use interreflect_conformance::own_model::ModelValues;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;

/// Hears of a campaign while it goes on.
pub(crate) trait Observer {
    /// Something is remarkable, though nothing failed.
    fn warn(&mut self, warning: &Warning);

    /// So many tasks of one quantity of a scene begin.
    fn begin(&mut self, scene: &str, quantity: Quantity, tasks: usize);

    /// One of them begins.
    fn task(&mut self, label: String);

    /// It is done, and its result is there.
    ///
    /// # Errors
    /// [`RunError`] if what there is so far can't be written: the campaign then ends.
    fn done(&mut self, campaign: &Campaign<'_>) -> Result<(), RunError>;

    /// All of them are done.
    fn end(&mut self);
}

/// Keeps images as they come, so that a campaign that was stopped leaves what it had.
pub(crate) trait Images {
    /// Keeps the truth of a scene and quantity.
    ///
    /// # Errors
    /// [`FileError`] if it can't be written.
    fn truth(
        &self,
        scene: &str,
        quantity: Quantity,
        view: &View,
        truth: &ModelValues,
    ) -> Result<(), FileError>;

    /// Keeps a run's estimate, under a name that no other run of its scene and quantity has, and tells the
    /// run where it is.
    ///
    /// # Errors
    /// [`FileError`] if it can't be written.
    fn estimate(
        &self,
        name: &str,
        run: &mut Run,
        view: &View,
        estimate: &Estimate,
    ) -> Result<(), FileError>;
}
