//! What a run leaves behind: the JSON contract of `bench --json` and `results.json`.
//!
//! Times are in milliseconds, errors in the units of the compared quantity. A number that does not
//! exist is `null`, never a stand-in, and says why beside it.
//!
//! Longer than most: the contract is read in one place.

mod error_breakdown;
mod invocation;
mod params;
mod timing;

pub use error_breakdown::{ErrorBreakdown, Floor, Part};
pub use invocation::{GivenOption, Invocation, Scope};
pub use params::{ParamMap, ParamValue};
pub use timing::{Fallback, TimeSource, Timing};

use crate::domain::machine::Machine;
use interreflect_estimators::{Configured, Quantity};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// Everything that a `bench` or a `sweep` produced.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// Where it was measured, and with which build.
    pub machine: Machine,
    /// The command that made it, quoted for a shell; empty if it is not known.
    #[serde(default)]
    pub command: String,
    /// The same, taken apart.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub invocation: Option<Invocation>,
    /// Seed of everything random; `None` if it is not known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// One entry per scene, estimator, set of parameters, quantity and backend.
    pub runs: Vec<Run>,
    /// All machines that took part, where that is more than one.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub machines: BTreeMap<String, Machine>,
    /// Path tracing and n-ray gathering at several sample counts, for comparison at equal time.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub baselines: Vec<Run>,
    /// What each model leaves out at best.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub floors: Vec<Floor>,
    /// What the errors are made of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub splits: Vec<ErrorBreakdown>,
}

/// One estimator with one set of parameters, on one scene and one backend.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Name of the scene.
    pub scene: String,
    /// Hash of all that is in the scene; `None` in records that do not know it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene_hash: Option<String>,
    /// What varied of the scene and of how it was run, as `scene.name` or `run.name`.
    #[serde(default, skip_serializing_if = "ParamMap::is_empty")]
    pub settings: ParamMap,
    /// Where it was measured: a key of [`Results::machines`], where several machines took part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// Identifier of the estimator.
    pub estimator: String,
    /// Where it ran.
    pub backend: Backend,
    /// `published` or `corrected`; `None` where the method has no fidelity.
    pub fidelity: Option<String>,
    /// Name of the estimated quantity, in snake case.
    pub quantity: String,
    /// Every parameter, in the method's own order.
    pub params: ParamMap,
    /// Number of points, those without a surface included.
    pub points: usize,
    /// Where the time went.
    pub phases_ms: Phases,
    /// By which clock the phases were timed, where the device or the host can: compile and read-back
    /// are the host's always, and each time says its own.
    pub time_source: TimeSource,
    /// How many times slower than at its best in this session the processor was after this run, if that
    /// is worth a remark: it is throttled, or shared.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub slowed: Option<f64>,
    /// Mean difference from the other backend's estimate over its mean, if that is more than captures
    /// explain: one of the two implementations is wrong.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub backends_apart: Option<f64>,
    /// What of memory a frame holds; `None` if nothing ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bytes: Option<Bytes>,
    /// The run used a software adapter: its times say nothing about a GPU.
    pub software: bool,
    /// Difference to what the method claims to compute.
    pub own_model: Option<Comparison>,
    /// Why `own_model` is `None`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own_model_missing: Option<String>,
    /// Difference to full light transport.
    pub truth: Option<Comparison>,
    /// Why `truth` is `None`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub truth_missing: Option<String>,
    /// Why nothing ran; every phase and comparison is then `None`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub skipped: Option<String>,
    /// The estimate as an EXR image, relative to the folder of the results; `None` where no images
    /// were written.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub image: Option<String>,
}

impl Run {
    /// A run that has not taken place yet: nothing measured, nothing compared.
    pub fn new(
        scene: impl Into<String>,
        estimator: impl Into<String>,
        backend: Backend,
        quantity: impl Into<String>,
    ) -> Self {
        Self {
            scene: scene.into(),
            scene_hash: None,
            settings: ParamMap::default(),
            machine: None,
            estimator: estimator.into(),
            backend,
            fidelity: None,
            quantity: quantity.into(),
            params: ParamMap::default(),
            points: 0,
            phases_ms: Phases::default(),
            time_source: TimeSource::WallClock,
            slowed: None,
            backends_apart: None,
            bytes: None,
            software: false,
            own_model: None,
            own_model_missing: None,
            truth: None,
            truth_missing: None,
            skipped: None,
            image: None,
        }
    }

    /// A run of a method that has not taken place yet, with the method's fidelity and parameters.
    pub fn of(
        scene: impl Into<String>,
        method: &dyn Configured,
        backend: Backend,
        quantity: Quantity,
    ) -> Self {
        Self {
            fidelity: method.fidelity().map(str::to_owned),
            params: ParamMap::of(method),
            ..Self::new(scene, method.info().id, backend, quantity.name())
        }
    }

    /// Estimator and fidelity as one label, such as `localized_cubemap, corrected`.
    pub fn label(&self) -> String {
        match &self.fidelity {
            Some(fidelity) => format!("{}, {fidelity}", self.estimator),
            None => self.estimator.clone(),
        }
    }
}

/// Where a run took place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Backend {
    /// Host threads.
    Cpu,
    /// A Vulkan device, hardware or software.
    Gpu,
}

impl Backend {
    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cpu => "cpu",
            Self::Gpu => "gpu",
        }
    }
}

impl fmt::Display for Backend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Time of each phase; `None` where a run has no such phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Phases {
    /// Computing, once for the scene, the coarse solution that captures hold. Where a later run finds
    /// it done, this is still what it took.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solve: Option<Timing>,
    /// Taking the captures that the method declared; `None` where there are none, or where those of
    /// an earlier frame are kept.
    pub capture: Option<Timing>,
    /// Pipeline-cache misses and the first run's excess.
    pub compile: Option<Timing>,
    /// From captures to the method's own data.
    pub prepare: Option<Timing>,
    /// The estimate at all points.
    pub shade: Option<Timing>,
    /// Bringing the estimate back to the host.
    pub readback: Option<Timing>,
}

impl Phases {
    /// Names with times, in the order in which phases run.
    pub fn named(&self) -> [(&'static str, Option<Timing>); 6] {
        [
            ("solve", self.solve),
            ("capture", self.capture),
            ("compile", self.compile),
            ("prepare", self.prepare),
            ("shade", self.shade),
            ("readback", self.readback),
        ]
    }

    /// Sum of the medians of what a frame pays once all is compiled: capture, prepare and shade.
    /// `None` if nothing was shaded.
    pub fn frame_ms(&self) -> Option<f64> {
        Some(self.frame()?.median)
    }

    /// What a frame pays, with the interval that its parts' intervals leave: their distances from the
    /// medians add up as those of independent times do.
    pub fn frame(&self) -> Option<Timing> {
        let shade = self.shade?;
        let parts = [self.capture, self.prepare];
        Some(parts.into_iter().flatten().fold(shade, Timing::and))
    }
}

/// Bytes on the backend's side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Bytes {
    /// Captures; on a device with what they were drawn by.
    pub captures: u64,
    /// What the method made of them: on the host what it keeps between frames, on a device all buffers and
    /// textures of its first frame. `None` on the host of a program that does not count its memory.
    pub own: Option<u64>,
    /// Points and their estimate.
    pub points: u64,
}

/// How an estimate differs from a reference; how each number is made is said in
/// [`crate::domain::metrics`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// Mean squared error relative to the reference's square plus `epsilon`; `None` for a
    /// reference that is zero everywhere.
    pub relmse: Option<f64>,
    /// Root of the mean squared error, in the quantity's unit.
    pub rmse: f64,
    /// Sum of the estimate over the sum of the reference, signs kept: 1 keeps the energy, less is
    /// too dark; `None` for a reference that sums to zero.
    pub energy_ratio: Option<f64>,
    /// 99.9th percentile of the absolute error, in the quantity's unit.
    pub p999: f64,
    /// Largest absolute error, in the quantity's unit.
    pub max: f64,
    /// The relMSE to be expected of a perfect estimate, from the reference's own standard error;
    /// `None` where `relmse` is.
    pub noise_floor: Option<f64>,
    /// Whether the reference resolves the difference.
    pub verdict: Verdict,
    /// `relmse` less `noise_floor`, not below 0: the best guess of the estimate's own error.
    pub relmse_above_noise: Option<f64>,
    /// The RMSE to be expected of a perfect estimate.
    pub noise_floor_rmse: f64,
    /// The ε of relMSE, in the quantity's unit squared.
    pub epsilon: f64,
    /// Mean FLIP of the image against the reference's, both tone-mapped alike, in [0, 1]: what a viewer
    /// would notice when flipping between them. `None` where there is no image.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flip: Option<f64>,
    /// Number of points that were compared: those with a surface.
    pub compared: usize,
    /// What the estimate was compared with, its sample count and seed where it has them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference: Option<String>,
}

/// Whether a reference's noise lets a difference be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The difference is well above the reference's own error.
    Conclusive,
    /// The difference could be the reference's own error: the numbers are upper bounds.
    Inconclusive,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Conclusive => "conclusive",
            Self::Inconclusive => "inconclusive",
        })
    }
}

#[cfg(test)]
mod tests;
