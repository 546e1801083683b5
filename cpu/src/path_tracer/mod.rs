//! The path tracer: full light transport at arbitrary points, or chosen parts of it.
//!
//! Each point is estimated by [`REPLICATES`] independent randomisations of one low-discrepancy
//! sequence. Their spread gives the standard error: it needs no assumption on how fast the
//! sequence converges. Sequences are seeded by point and replicate and summed in order, so the
//! same seed gives the same bits for any number of threads.

mod coarse;
pub(crate) mod emitters;
mod environment;
mod estimator;
mod lobe;
mod sampling;
mod settings;
mod spread;

pub use coarse::CoarseSolution;
pub use settings::{PathQuantity, Stop};

use crate::scene::CpuScene;
use estimator::Estimator;
use glam::DVec3;
use interreflect_scene::{Estimate, LightPaths, Points};
use rayon::prelude::*;
use sampling::{SEQUENCE_LENGTH, Sample, hash};
use std::{
    sync::atomic::{AtomicUsize, Ordering},
    time::Instant,
};

/// Independent randomisations of each point's sequence; the samples a point are a multiple of it,
/// at most 2¹⁶ times as many.
pub const REPLICATES: u32 = 32;

/// Makes a z-score from [`REPLICATES`] means as rare as a normal one at |z| = 4: Student's t with
/// 31 degrees of freedom exceeds 4 × this as often as a normal variable exceeds 4.
pub const STUDENT_AT_4_SIGMA: f64 = 1.1554;

/// Rounding to f32 and the lift of points off their surface, relative to the estimate.
const ROUNDING: f64 = 1e-6;

/// Replicates that a task samples before it looks for more work.
const TASK: usize = 8;

/// Estimates of all points.
#[derive(Clone, Debug, PartialEq)]
pub struct Traced {
    /// The estimate; zero where a point has no surface, NaN where its data are not numbers.
    pub mean: Estimate,
    /// Standard deviation of `mean` as the spread of the [`REPLICATES`] tells it and nothing else:
    /// the error over it follows Student's t with one degree of freedom less, as far as means of a
    /// replicate are normal.
    pub spread: Estimate,
    /// One standard error of `mean`, from the spread of the replicates; scaled so that |z| > 4
    /// is as rare as for a normal variable in spite of their number.
    ///
    /// N samples may all miss a part of the hemisphere smaller than 1/N (at a point that faces a
    /// wall closely, say) and then agree by mistake. So an error of 1/N is added in quadrature,
    /// relative to the estimate or to the root mean square over all points, whichever is larger;
    /// and 1e-6 of the estimate for rounding.
    pub standard_error: Estimate,
    /// Samples at each point.
    pub samples: u32,
}

/// Traces paths from all points until `stop` is satisfied.
///
/// `progress` is called with the fraction done, from any thread, at most a hundred times a round.
pub fn trace(
    scene: &CpuScene,
    points: &Points,
    quantity: PathQuantity,
    paths: &LightPaths,
    stop: &Stop,
    seed: u64,
    progress: &(dyn Fn(f32) + Sync),
) -> Traced {
    let start = Instant::now();
    let estimator = Estimator::new(scene, paths);
    let largest = stop.largest(REPLICATES, SEQUENCE_LENGTH);
    let mut sums = vec![DVec3::ZERO; points.len() * REPLICATES as usize];
    let (mut done, mut error) = (0, f32::INFINITY);
    loop {
        let count = stop.next_round(done, largest, error, start.elapsed());
        if count == 0 {
            break;
        }
        let tasks = sums.len().div_ceil(TASK);
        let report = |finished: usize| {
            let step = (finished * 100 / tasks) != ((finished - 1) * 100 / tasks);
            if step {
                let done = done as f32 + count as f32 * finished as f32 / tasks as f32;
                progress(stop.progress(done, largest, start.elapsed()));
            }
        };
        let finished = AtomicUsize::new(0);
        sums.par_chunks_mut(TASK)
            .enumerate()
            .for_each(|(task, sums)| {
                let first = task * TASK;
                let index = first / REPLICATES as usize;
                if let Some(point) = points.get(index) {
                    let gather = estimator.gather(&point, quantity);
                    for (offset, sum) in sums.iter_mut().enumerate() {
                        let stream = hash(seed ^ hash((first + offset) as u64)) as u32;
                        *sum += match &gather {
                            Some(gather) => (done..done + count)
                                .map(|i| {
                                    estimator.sample(gather, Sample::new(i, stream)).as_dvec3()
                                })
                                .sum(),
                            None => DVec3::NAN,
                        };
                    }
                }
                report(finished.fetch_add(1, Ordering::Relaxed) + 1);
            });
        done += count;
        if stop.relative_error.is_some() {
            error = relative_error(&statistics(&sums, done));
        }
    }
    let samples = done * REPLICATES;
    let mut traced = Traced {
        mean: Estimate::new(points.len()),
        spread: Estimate::new(points.len()),
        standard_error: Estimate::new(points.len()),
        samples,
    };
    for (index, of_point) in statistics(&sums, done).into_iter().enumerate() {
        traced.mean.set(index, of_point.mean.as_vec3());
        traced.spread.set(index, of_point.spread.as_vec3());
        let error = of_point.standard_error;
        traced.standard_error.set(index, error.as_vec3());
    }
    traced
}

/// The mean of so many samples a point, of one sequence: what they tell of their own error is nothing.
/// Zero where a point has no surface.
pub fn mean_of_samples(
    scene: &CpuScene,
    points: &Points,
    quantity: PathQuantity,
    paths: &LightPaths,
    samples: u32,
    seed: u64,
) -> Estimate {
    let estimator = Estimator::new(scene, paths);
    let mean = |index: usize| {
        let gather = estimator.gather(&points.get(index)?, quantity)?;
        let stream = hash(seed ^ hash(index as u64)) as u32;
        let sample = |i| estimator.sample(&gather, Sample::new(i, stream)).as_dvec3();
        Some((0..samples).map(sample).sum::<DVec3>() / f64::from(samples))
    };
    let means: Vec<_> = (0..points.len()).into_par_iter().map(mean).collect();
    let mut estimate = Estimate::new(points.len());
    for (index, mean) in means.into_iter().enumerate() {
        estimate.set(index, mean.unwrap_or(DVec3::ZERO).as_vec3());
    }
    estimate
}

/// What the replicates of one point tell.
struct Statistics {
    mean: DVec3,
    spread: DVec3,
    standard_error: DVec3,
}

/// The statistics of every point, after `done` samples in each replicate.
fn statistics(sums: &[DVec3], done: u32) -> Vec<Statistics> {
    let replicates = f64::from(REPLICATES);
    let squared = |v: DVec3| v * v;
    let of_point = |sums: &[DVec3]| {
        let scale = 1.0 / f64::from(done);
        let mean = sums.iter().sum::<DVec3>() * scale / replicates;
        let squares: DVec3 = sums.iter().map(|&s| squared(s * scale - mean)).sum();
        (mean, squares / (replicates * (replicates - 1.0)))
    };
    let points: Vec<_> = sums.chunks(REPLICATES as usize).map(of_point).collect();
    let sound = points.iter().filter(|(mean, _)| mean.is_finite());
    let (count, sum) = sound.fold((0.0_f64, DVec3::ZERO), |(n, sum), &(mean, _)| {
        (n + 1.0, sum + squared(mean))
    });
    let mean_square = sum / count.max(1.0);
    let unseen = 1.0 / (f64::from(done) * replicates);
    let error = |(mean, variance): (DVec3, DVec3)| {
        // A plain maximum would lose that a mean is not a number.
        let reference = DVec3::select(squared(mean).cmplt(mean_square), mean_square, squared(mean));
        let least = reference * (unseen * unseen) + squared(mean) * (ROUNDING * ROUNDING);
        let scaled = variance * (STUDENT_AT_4_SIGMA * STUDENT_AT_4_SIGMA);
        Statistics {
            mean,
            spread: variance.map(f64::sqrt),
            standard_error: (scaled + least).map(f64::sqrt),
        }
    };
    points.into_iter().map(error).collect()
}

/// Root of Σ standard error² over Σ estimate²; points that are not numbers are left out.
fn relative_error(statistics: &[Statistics]) -> f32 {
    let (mut errors, mut squares) = (0.0, 0.0);
    for of_point in statistics {
        let (mean, error) = (of_point.mean, of_point.standard_error);
        if mean.is_finite() && error.is_finite() {
            errors += error.length_squared();
            squares += mean.length_squared();
        }
    }
    if errors == 0.0 {
        0.0
    } else {
        (errors / squares).sqrt() as f32
    }
}
