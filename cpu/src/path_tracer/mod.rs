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

/// Makes two standard errors hold the truth as often as those of a normal variable, 95.45 %: the two-sided
/// quantile of Student's t with 31 degrees of freedom, over 2.
const STUDENT_AT_2_SIGMA: f64 = 1.0398;

/// Degrees of freedom that the spread over all points counts for in that of one point. Replicates of few
/// samples are skewed: where they happen to miss what is bright, mean and spread are both too small, and
/// two standard errors from the point's own spread alone hold the truth too seldom. With this many they do at
/// 93 to 97 % of points in every scene of the library that has noise: `path_reference/coverage`.
const SHARED_FREEDOM: f64 = 16.0;

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
    /// What `spread` can't tell: N samples may all miss a part of the hemisphere smaller than 1/N (at a
    /// point that faces a wall closely, say) and then agree by mistake. An error of 1/N, relative to the
    /// estimate or to the root mean square over all points, whichever is larger; and in quadrature 1e-6
    /// of the estimate for rounding.
    pub unseen: Estimate,
    /// One standard error of `mean`: of independent randomisations, the truth lies within two of them at
    /// 93 to 97 % of points.
    ///
    /// Its square is a mean of `spread`² and of what the spread of all points lets expect at one of this
    /// value, times a factor for the number of replicates, plus `unseen`².
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
        unseen: Estimate::new(points.len()),
        standard_error: Estimate::new(points.len()),
        samples,
    };
    for (index, of_point) in statistics(&sums, done).into_iter().enumerate() {
        traced.mean.set(index, of_point.mean.as_vec3());
        traced.spread.set(index, of_point.spread.as_vec3());
        traced.unseen.set(index, of_point.unseen.as_vec3());
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
    unseen: DVec3,
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
    let none = (0.0_f64, DVec3::ZERO, DVec3::ZERO);
    let (count, squares, variances) =
        sound.fold(none, |(n, squares, variances), (mean, variance)| {
            (n + 1.0, squares + squared(*mean), variances + variance)
        });
    let mean_square = squares / count.max(1.0);
    // Relative to the square of a value; nothing where all values are 0.
    let shared = (variances / squares.max(DVec3::splat(f64::MIN_POSITIVE))).min(DVec3::ONE);
    let own_freedom = replicates - 1.0;
    let unseen = 1.0 / (f64::from(done) * replicates);
    let error = |(mean, variance): (DVec3, DVec3)| {
        // A plain maximum would lose that a mean is not a number.
        let reference = DVec3::select(squared(mean).cmplt(mean_square), mean_square, squared(mean));
        let unseen = reference * (unseen * unseen) + squared(mean) * (ROUNDING * ROUNDING);
        // Variances grow with the value more slowly than its square.
        let expected = shared * mean.abs() * mean_square.map(f64::sqrt);
        let pooled =
            (variance * own_freedom + expected * SHARED_FREEDOM) / (own_freedom + SHARED_FREEDOM);
        let seen = pooled * (STUDENT_AT_2_SIGMA * STUDENT_AT_2_SIGMA);
        Statistics {
            mean,
            spread: variance.map(f64::sqrt),
            unseen: unseen.map(f64::sqrt),
            standard_error: (seen + unseen).map(f64::sqrt),
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
