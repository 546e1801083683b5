//! Scenes and values of experiments as data: what is written down is what runs.

use super::experiment_context::ExperimentContext;
use super::finding::Finding;
use crate::running::error::RunError;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// A setup whose fields are all that tells one run from another: scenes, models, and values in the paper's
/// terms. How many points and samples are taken is the context's.
pub trait Runs: Serialize + Sync {
    /// Carries it out.
    ///
    /// # Errors
    /// [`RunError`] if a scene or a method is refused or fails.
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError>;
}

/// A setup of any type.
pub trait Setup: Sync {
    /// Its fields: an object with `scene` or `scenes`, and the values by name.
    fn described(&self) -> Value;

    /// Carries it out.
    ///
    /// # Errors
    /// As [`Runs::run`].
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError>;
}

impl<T: Runs> Setup for T {
    fn described(&self) -> Value {
        serde_json::to_value(self).unwrap_or_default()
    }

    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        Runs::run(self, context)
    }
}

/// A setup whose scenes and values are in the code that runs, described by nothing: for experiments that no paper
/// has.
pub(super) struct InCode(pub(super) fn(&ExperimentContext<'_>) -> Result<Finding, RunError>);

impl Runs for InCode {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        (self.0)(context)
    }
}

impl Serialize for InCode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_unit()
    }
}
