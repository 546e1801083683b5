//! What runs must share to be held against each other.

use crate::domain::record::Run;
use serde::Serialize;
use std::fmt;

/// A scene, a quantity and a number of points: what a frame costs is for so many points, and one method's
/// time grows with them where another's does not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Problem {
    /// Name of the scene.
    pub scene: String,
    /// Hash of all that is in it, where records know it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene_hash: Option<String>,
    /// Name of the estimated quantity, in snake case.
    pub quantity: String,
    /// Number of points, those without a surface included.
    pub points: usize,
}

impl Problem {
    /// Where a run stands.
    pub fn of(run: &Run) -> Self {
        Self {
            scene: run.scene.clone(),
            scene_hash: run.scene_hash.clone(),
            quantity: run.quantity.clone(),
            points: run.points,
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let quantity = self.quantity.replace('_', " ");
        write!(f, "{}: {quantity}, {} points", self.scene, self.points)
    }
}
