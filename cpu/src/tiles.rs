//! Tiles of points, threads and instruction sets: how a CPU kernel is run over a point list.

mod instruction_set;
#[cfg(test)]
mod tests;

pub use instruction_set::InstructionSet;

use crate::lane::{Lane, Vector, Wide};
use interreflect_scene::params::Choice;
use interreflect_scene::{Estimate, LANES, PointLayout, Points};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::marker::PhantomData;
use std::sync::Arc;

/// The numbers that kernels compute with: one formula, three arithmetics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Arithmetic {
    /// Sixteen `f32`s side by side, on the context's instruction set.
    #[default]
    Lanes,
    /// One `f32` at a time: the same bits.
    Scalar,
    /// One `f64` at a time, rounded to `f32` when the estimate is stored. The same formula on what
    /// an estimator has prepared, which is in `f32` whatever the arithmetic: what is left of the
    /// difference is the rounding of the formula, not that of its inputs.
    Float64,
}

impl Choice for Arithmetic {}

/// Neighbouring points of a block, one in each lane.
#[derive(Clone, Copy)]
pub struct PointLanes<'a, L> {
    block: &'a [f32],
    offset: usize,
    first: usize,
    lanes: PhantomData<L>,
}

impl<L: Lane> PointLanes<'_, L> {
    /// Index in the point list of the first of them.
    #[inline(always)]
    pub fn first(&self) -> usize {
        self.first
    }

    /// One plane of the block, by the offsets of [`PointLayout`].
    #[inline(always)]
    pub fn plane(&self, plane: usize) -> L {
        let start = plane * LANES + self.offset;
        let values = &self.block[start..start + L::WIDTH];
        L::by_lane(|i| values[i].into())
    }

    /// Three neighbouring planes, by the first one's offset.
    #[inline(always)]
    pub fn vector(&self, plane: usize) -> Vector<L> {
        Vector::new(
            self.plane(plane),
            self.plane(plane + 1),
            self.plane(plane + 2),
        )
    }
}

/// What is computed at each point; `shade` must be `#[inline(always)]`, or the instruction set
/// that was chosen does not reach it.
pub trait TileKernel: Sync {
    /// The RGB values of as many points as there are lanes, each point's by itself. Lanes without a
    /// surface may hold anything: they are set to 0 afterwards.
    fn shade<L: Lane>(&self, points: &PointLanes<'_, L>) -> [L; 3];
}

/// How a CPU estimator runs: a thread pool of its own, an instruction set and an arithmetic.
#[derive(Clone)]
pub struct CpuCx {
    pool: Arc<rayon::ThreadPool>,
    instruction_set: InstructionSet,
    arithmetic: Arithmetic,
}

/// Blocks that one task takes: large enough to hide the pool's cost, small enough to balance.
const BLOCKS_PER_TASK: usize = 8;

impl CpuCx {
    /// A context with its own threads; `None` takes all processors.
    ///
    /// # Errors
    /// [`CpuCxError`] if the threads can't be started or the processor lacks the instruction set.
    pub fn new(
        threads: Option<usize>,
        instruction_set: Option<InstructionSet>,
    ) -> Result<Self, CpuCxError> {
        let instruction_set = instruction_set.unwrap_or_else(InstructionSet::widest);
        if !instruction_set.available() {
            return Err(CpuCxError::Lacking(instruction_set.name()));
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.unwrap_or(0))
            .thread_name(|i| format!("interreflect-{i}"))
            .build()?;
        // Each thread has started: none takes memory of its own, or time, from what is measured later.
        pool.broadcast(|_| ());
        Ok(Self {
            pool: Arc::new(pool),
            instruction_set,
            arithmetic: Arithmetic::default(),
        })
    }

    /// The same threads, on which kernels compute with these numbers.
    pub fn with_arithmetic(&self, arithmetic: Arithmetic) -> Self {
        Self {
            arithmetic,
            ..self.clone()
        }
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// The instruction set that kernels run on.
    pub fn instruction_set(&self) -> InstructionSet {
        self.instruction_set
    }

    /// Runs `op` with this context's threads as rayon's.
    pub fn install<T: Send>(&self, op: impl FnOnce() -> T + Send) -> T {
        self.pool.install(op)
    }

    /// Runs a kernel over all points; the result does not depend on the number of threads.
    ///
    /// # Panics
    /// If `out` has another length than `points`.
    pub fn for_each_tile<K: TileKernel>(&self, points: &Points, out: &mut Estimate, kernel: &K) {
        assert_eq!(
            points.len(),
            out.len(),
            "an estimate is as long as its points"
        );
        self.for_each_chunk(out, &|first_block, out| {
            let task = Task {
                kernel,
                points,
                first_block,
                out,
            };
            match self.arithmetic {
                Arithmetic::Lanes => self.instruction_set.run(task),
                Arithmetic::Scalar => task.shade::<f32>(),
                Arithmetic::Float64 => task.shade::<f64>(),
            }
        });
    }

    /// Calls `shade` on this context's threads with the index of a first block and the blocks from there
    /// on: compiled once, and not for each kernel.
    fn for_each_chunk(&self, out: &mut Estimate, shade: &(dyn Fn(usize, &mut [f32]) + Sync)) {
        let stride = Estimate::PLANES * LANES;
        let chunks = out.blocks_mut().par_chunks_mut(stride * BLOCKS_PER_TASK);
        let chunks = chunks.enumerate();
        self.install(|| chunks.for_each(|(task, out)| shade(task * BLOCKS_PER_TASK, out)));
    }
}

struct Task<'a, K> {
    kernel: &'a K,
    points: &'a Points,
    first_block: usize,
    out: &'a mut [f32],
}

impl<K: TileKernel> pulp::NullaryFnOnce for Task<'_, K> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.shade::<Wide>();
    }
}

impl<K: TileKernel> Task<'_, K> {
    #[inline(always)]
    fn shade<L: Lane>(self) {
        for (i, out) in self
            .out
            .chunks_exact_mut(Estimate::PLANES * LANES)
            .enumerate()
        {
            let block = self.points.block(self.first_block + i);
            for offset in (0..LANES).step_by(L::WIDTH) {
                let points = PointLanes {
                    block,
                    offset,
                    first: (self.first_block + i) * LANES + offset,
                    lanes: PhantomData,
                };
                let mask: L = points.plane(PointLayout::MASK);
                let zero = L::from(0.0);
                for (channel, value) in self.kernel.shade(&points).into_iter().enumerate() {
                    let masked = mask.select_gt(zero, value, zero);
                    let out = &mut out[channel * LANES + offset..][..L::WIDTH];
                    for (out, &value) in out.iter_mut().zip(masked.lanes()) {
                        let value: f64 = value.into();
                        *out = value as f32;
                    }
                }
            }
        }
    }
}

/// Why a CPU context can't be made.
#[derive(Debug, thiserror::Error)]
pub enum CpuCxError {
    /// The processor lacks the instructions that were asked for.
    #[error(
        "this processor has no {0} instructions; omit --instruction-set to use the widest it has"
    )]
    Lacking(&'static str),
    /// The operating system refused the threads.
    #[error("the threads can't be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}
