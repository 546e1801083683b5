//! Which vector instructions a kernel is compiled for.

use interreflect_scene::params::Choice;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The vector instructions that a kernel is compiled for. Results have the same bits on each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InstructionSet {
    /// What every processor of the target has (SSE2 on x86-64).
    Baseline,
    /// AVX2 and FMA (x86-64-v3).
    Avx2,
    /// AVX-512 F, BW, CD, DQ, VL (x86-64-v4).
    Avx512,
}

impl Choice for InstructionSet {}

impl InstructionSet {
    /// Whether this processor has it.
    pub fn available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => pulp::x86::V3::try_new().is_some(),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => pulp::x86::V4::try_new().is_some(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The widest one that this processor has.
    pub fn widest() -> Self {
        let all = [Self::Avx512, Self::Avx2];
        all.into_iter()
            .find(|s| s.available())
            .unwrap_or(Self::Baseline)
    }

    /// Its name on the command line and in reports.
    pub fn name(self) -> &'static str {
        Choice::name(self)
    }

    /// Runs `op`, and all that is inlined into it, compiled for this instruction set; falls back
    /// to the baseline where the processor lacks it.
    pub(super) fn run<Op: pulp::NullaryFnOnce>(self, op: Op) -> Op::Output {
        #[cfg(target_arch = "x86_64")]
        {
            use pulp::x86::{V3, V4};
            match self {
                Self::Avx512 => {
                    if let Some(simd) = V4::try_new() {
                        return simd.vectorize(op);
                    }
                }
                Self::Avx2 => {
                    if let Some(simd) = V3::try_new() {
                        return simd.vectorize(op);
                    }
                }
                Self::Baseline => {}
            }
        }
        op.call()
    }
}
