//! Options that several commands share.

use super::values::{choice, count, fraction, milliseconds, seconds, threads, vector};
use crate::domain::record::Backend;
use crate::running::clock::Sampling;
use crate::running::settings::{ContextOptions, ReferenceBudget, SceneChanges};
use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use glam::Vec3;
use interreflect_cpu::tiles::InstructionSet;
use std::path::PathBuf;

/// Changes to a scene.
#[derive(Clone, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Scene")]
pub struct SceneOptions {
    /// Receiver: `sphere`, `torus`, `blob` or an OBJ file, scaled to the receiver's size; repeatable for
    /// scenes with several
    #[arg(long, value_name = "FILE")]
    pub receiver: Vec<PathBuf>,
    /// Latitude-longitude image (HDR or EXR) as environment
    #[arg(long, value_name = "FILE")]
    pub environment: Option<PathBuf>,
    /// Reference point: where cube maps are captured
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = vector)]
    pub reference_point: Option<Vec3>,
}

impl SceneOptions {
    /// The changes that are asked for.
    pub fn changes(&self) -> SceneChanges {
        SceneChanges {
            receivers: self.receiver.clone(),
            environment: self.environment.clone(),
            reference_point: self.reference_point,
        }
    }
}

/// How to run.
#[derive(Clone, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Run")]
pub struct RunOptions {
    /// Vulkan adapter: part of its name, or its number in `interreflect list`
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
    /// Threads of the CPU backend, at most 1024; default: all
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Instruction set of the CPU kernels; default: the widest that the processor supports
    #[arg(long, value_name = "SET", value_parser = choice::<InstructionSet>())]
    pub instruction_set: Option<InstructionSet>,
    /// Random seed
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(..=u64::from(u32::MAX)))]
    pub seed: u64,
}

impl RunOptions {
    /// What a context is made from.
    pub fn context(&self) -> ContextOptions {
        ContextOptions {
            adapter: self.adapter.clone(),
            threads: self.threads,
            instruction_set: self.instruction_set,
            seed: self.seed,
        }
    }
}

/// How long phases are timed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Timing")]
pub struct TimingOptions {
    /// Largest number of repetitions of each phase
    #[arg(long, value_name = "N", value_parser = count)]
    pub repeat: Option<usize>,
    /// Stop once the median's 95 % confidence interval is within ± this fraction of it
    #[arg(long, value_name = "FRACTION", value_parser = fraction)]
    pub spread: Option<f64>,
    /// Time limit of each phase in milliseconds, warm-up included
    #[arg(long, value_name = "MS", value_parser = milliseconds)]
    pub patience: Option<f64>,
}

impl TimingOptions {
    /// The options over what holds if nothing is said.
    pub fn sampling(&self) -> Sampling {
        let usual = Sampling::default();
        let most = self.repeat.unwrap_or(usual.most);
        Sampling {
            least: usual.least.min(most),
            most,
            spread: self.spread.unwrap_or(usual.spread),
            patience_ms: self.patience.unwrap_or(usual.patience_ms),
        }
    }
}

/// When a path-traced reference is good enough.
#[derive(Clone, Copy, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Reference")]
pub struct ReferenceOptions {
    /// Samples per point
    #[arg(long, value_name = "N", value_parser = count)]
    pub samples: Option<usize>,
    /// Stop at this relative standard error of the mean, such as .01
    #[arg(long, value_name = "FRACTION", value_parser = fraction)]
    pub error: Option<f64>,
    /// Time limit of each reference
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub seconds: Option<f64>,
}

impl ReferenceOptions {
    /// The budget that is asked for.
    pub fn budget(&self) -> ReferenceBudget {
        ReferenceBudget {
            samples: self.samples,
            relative_error: self.error,
            seconds: self.seconds,
        }
    }
}

/// One backend or both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Backends {
    /// Host threads
    Cpu,
    /// A Vulkan device
    Gpu,
    /// CPU, then GPU
    #[default]
    Both,
}

impl Backends {
    /// The backends, in the order in which they run.
    pub fn list(self) -> &'static [Backend] {
        match self {
            Self::Cpu => &[Backend::Cpu],
            Self::Gpu => &[Backend::Gpu],
            Self::Both => &[Backend::Cpu, Backend::Gpu],
        }
    }
}

impl ValueEnum for Backend {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Cpu, Self::Gpu]
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let help = match self {
            Self::Cpu => "Host threads",
            Self::Gpu => "A Vulkan device, hardware or software",
        };
        Some(PossibleValue::new(self.name()).help(help))
    }
}
