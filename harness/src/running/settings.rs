//! What is asked for, as plain values: settings, changes to a scene, how to run, how precise references are.

use glam::Vec3;
use interreflect_cpu::path_tracer::Stop;
use interreflect_cpu::tiles::InstructionSet;
use std::path::PathBuf;

/// Qualifier of settings that are meant for the scene.
pub(crate) const SCENE: &str = "scene";

/// A parameter as given, not yet checked against any method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// `name`, or `id.name`.
    pub name: String,
    /// The text after the equals sign.
    pub value: String,
}

impl Setting {
    /// A setting of this value.
    pub fn new(name: impl Into<String>, value: impl ToString) -> Self {
        Self {
            name: name.into(),
            value: value.to_string(),
        }
    }

    /// The estimator that the setting is meant for, if it says so, and the parameter's name.
    pub fn split(&self) -> (Option<&str>, &str) {
        match self.name.split_once('.') {
            Some((estimator, name)) => (Some(estimator), name),
            None => (None, &self.name),
        }
    }
}

/// Changes to a scene beside its settings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneChanges {
    /// `sphere`, `torus`, `blob` or OBJ files that take the receivers' place, in their order.
    pub receivers: Vec<PathBuf>,
    /// Latitude-longitude image as environment.
    pub environment: Option<PathBuf>,
    /// Where cube maps are captured, in metres.
    pub reference_point: Option<Vec3>,
}

/// How to run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContextOptions {
    /// Vulkan adapter: part of its name, or its number.
    pub adapter: Option<String>,
    /// Threads of the CPU backend; all if `None`.
    pub threads: Option<usize>,
    /// Instruction set of the CPU kernels; the best that the processor has if `None`.
    pub instruction_set: Option<InstructionSet>,
    /// Seed of everything random.
    pub seed: u64,
}

/// When a path-traced reference is good enough: at the first of these that is reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReferenceBudget {
    /// Samples per point.
    pub samples: Option<usize>,
    /// Relative standard error of the mean.
    pub relative_error: Option<f64>,
    /// Seconds for each reference.
    pub seconds: Option<f64>,
}

/// Samples per point if nothing is said.
const SAMPLES: u32 = 1024;

impl ReferenceBudget {
    /// When the path tracer stops; after a thousand samples if nothing is said.
    pub fn stop(&self) -> Stop {
        let nothing = *self == Self::default();
        Stop {
            samples: match self.samples {
                Some(samples) => Some(u32::try_from(samples).unwrap_or(u32::MAX)),
                None => nothing.then_some(SAMPLES),
            },
            relative_error: self.relative_error.map(|e| e as f32),
            seconds: self.seconds.map(|s| s as f32),
        }
    }
}
