//! What an error is made of.

use super::{Backend, Comparison, ParamMap};
use serde::{Deserialize, Serialize};

/// The error that a method's model has against the truth, however well it is computed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Floor {
    /// Name of the scene.
    pub scene: String,
    /// Name of the quantity, in snake case.
    pub quantity: String,
    /// Identifier of the estimator.
    pub estimator: String,
    /// What the estimator sets out to compute, in words of the code.
    pub model: String,
    /// The model's values against full light transport.
    pub against_truth: Comparison,
}

/// The way from the truth to an estimate, in steps that add up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorBreakdown {
    /// Name of the scene.
    pub scene: String,
    /// Name of the quantity, in snake case.
    pub quantity: String,
    /// Identifier of the estimator.
    pub estimator: String,
    /// `published` or `corrected`; `None` where the method has no fidelity.
    pub fidelity: Option<String>,
    /// Every parameter, in the method's own order.
    pub params: ParamMap,
    /// The steps, from the truth to the estimate on the last backend.
    pub parts: Vec<Part>,
}

/// One step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// What it adds or leaves out.
    pub name: String,
    /// The backend whose estimate it ends at, where it ends at one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub backend: Option<Backend>,
    /// Mean of the signed step over the truth's mean: the steps add up to the whole; `None` where the truth
    /// is zero.
    pub mean: Option<f64>,
    /// relMSE of the step: its square over the truth's square plus ε, averaged.
    pub relmse: f64,
    /// What of it the references' own errors explain.
    pub noise_floor: f64,
    /// Whether it is more than that, as [`crate::domain::significance`] says.
    pub above_noise: bool,
}
