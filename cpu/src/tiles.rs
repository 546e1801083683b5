//! Tiles of points, threads and instruction sets: how a CPU kernel is run over a point list.

use crate::lane::{Lane, Vector, WIDTH, Wide};
use interreflect_scene::params::Choice;
use interreflect_scene::{Estimate, LANES, PointLayout, Points};
use rayon::prelude::*;

/// The vector instructions that a kernel is compiled for. Results have the same bits on each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InstructionSet {
    /// What every processor of the target has (SSE2 on x86-64).
    Baseline,
    /// AVX2 and FMA (x86-64-v3).
    Avx2,
    /// AVX-512 F, BW, CD, DQ, VL (x86-64-v4).
    Avx512,
}

impl Choice for InstructionSet {
    const ALL: &'static [(&'static str, Self)] = &[
        ("baseline", Self::Baseline),
        ("avx2", Self::Avx2),
        ("avx512", Self::Avx512),
    ];
}

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
        let found = Self::ALL.iter().find(|(_, s)| *s == self);
        found.map_or("", |(name, _)| name)
    }

    /// Runs `op`, and all that is inlined into it, compiled for this instruction set; falls back
    /// to the baseline where the processor lacks it.
    fn run<Op: pulp::NullaryFnOnce>(self, op: Op) -> Op::Output {
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

/// Sixteen neighbouring points of a block.
#[derive(Clone, Copy)]
pub struct PointLanes<'a> {
    block: &'a [f32],
    offset: usize,
    first: usize,
}

impl PointLanes<'_> {
    /// Index in the point list of the first of the sixteen.
    #[inline(always)]
    pub fn first(&self) -> usize {
        self.first
    }

    /// One plane of the block, by the offsets of [`PointLayout`].
    #[inline(always)]
    pub fn plane(&self, plane: usize) -> Wide {
        let start = plane * LANES + self.offset;
        let mut lanes = [0.0; WIDTH];
        lanes.copy_from_slice(&self.block[start..start + WIDTH]);
        Wide(lanes)
    }

    /// Three neighbouring planes, by the first one's offset.
    #[inline(always)]
    pub fn vector(&self, plane: usize) -> Vector<Wide> {
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
    /// The RGB values of sixteen points. Lanes without a surface may hold anything: they are
    /// set to 0 afterwards.
    fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3];
}

/// How a CPU estimator runs: a thread pool of its own and an instruction set.
pub struct CpuCx {
    pool: rayon::ThreadPool,
    instruction_set: InstructionSet,
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
        Ok(Self {
            pool,
            instruction_set,
        })
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
        let stride = Estimate::PLANES * LANES;
        self.pool.install(|| {
            out.blocks_mut()
                .par_chunks_mut(stride * BLOCKS_PER_TASK)
                .enumerate()
                .for_each(|(task, out)| {
                    self.instruction_set.run(Task {
                        kernel,
                        points,
                        first_block: task * BLOCKS_PER_TASK,
                        out,
                    });
                });
        });
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
        for (i, out) in self
            .out
            .chunks_exact_mut(Estimate::PLANES * LANES)
            .enumerate()
        {
            let block = self.points.block(self.first_block + i);
            for offset in (0..LANES).step_by(WIDTH) {
                let lanes = PointLanes {
                    block,
                    offset,
                    first: (self.first_block + i) * LANES + offset,
                };
                let mask = lanes.plane(PointLayout::MASK);
                let zero = Wide::splat(0.0);
                for (channel, value) in self.kernel.shade(&lanes).into_iter().enumerate() {
                    let masked = mask.select_gt(zero, value, zero);
                    out[channel * LANES + offset..][..WIDTH].copy_from_slice(&masked.0);
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
        "this processor has no {0} instructions; leave the choice out to take the widest it has"
    )]
    Lacking(&'static str),
    /// The operating system refused the threads.
    #[error("the threads can't be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use interreflect_scene::Point;

    struct Sum;
    impl TileKernel for Sum {
        #[inline(always)]
        fn shade(&self, points: &PointLanes<'_>) -> [Wide; 3] {
            let p = points.vector(PointLayout::POSITION);
            let n = points.vector(PointLayout::NORMAL);
            [p.x + n.x, p.dot(n), p.z / n.y]
        }
    }

    #[test]
    fn every_lane_is_shaded_once_and_masked_ones_are_zero() {
        let point = |i: usize| {
            (i % 7 != 2).then(|| Point {
                position: Vec3::new(i as f32, 1.0, 2.0),
                normal: Vec3::new(1.0, 2.0, 3.0),
                ..Point::default()
            })
        };
        for set in [
            InstructionSet::Baseline,
            InstructionSet::Avx2,
            InstructionSet::Avx512,
        ] {
            if !set.available() {
                println!("not run: this processor has no {}", set.name());
                continue;
            }
            for threads in [1, 2] {
                let cx = CpuCx::new(Some(threads), Some(set)).expect("a pool of threads");
                for len in [1, 63, 64, 65, 1500] {
                    let points = Points::new(PointLayout::Surface, (0..len).map(point));
                    let mut out = Estimate::new(len);
                    cx.for_each_tile(&points, &mut out, &Sum);
                    for i in 0..len {
                        let expected = point(i).map_or(Vec3::ZERO, |p| {
                            Vec3::new(i as f32 + 1.0, p.position.dot(p.normal), 1.0)
                        });
                        assert_eq!(out.get(i), expected, "point {i} of {len}");
                    }
                }
            }
        }
    }
}
