//! One method on one backend: captured, prepared and shaded, each phase timed.

use crate::domain::metrics::check_finite;
use crate::domain::record::{Bytes, Phases, Timing};
use crate::running::clock::Sampling;
use crate::running::error::RunError;
use crate::running::memory::{Footprint, freed};
use interreflect_estimators::execution::{BackendScene, Elapsed, Executor};
use interreflect_estimators::{Backend, Changed, Configured, EstimatorError, Quantity};
use interreflect_scene::{Estimate, Needs, Points};
use std::time::Instant;

/// An estimate, the time that it took, and the memory.
pub struct Measured {
    /// The quantity at each point.
    pub estimate: Estimate,
    /// Where the time went.
    pub phases: Phases,
    /// What a frame holds.
    pub bytes: Bytes,
    /// Captures that were declared and never read: empty for an honest method.
    pub unread: Needs,
}

/// Runs a method, each phase as often as `sampling` says; the first time warms up and counts only if
/// there is no second.
///
/// # Errors
/// [`RunError`] if the method can't run here, or estimates a number that is not finite.
pub fn measure<S: BackendScene>(
    scene: &S,
    method: &dyn Configured,
    quantity: Quantity,
    points: &Points,
    sampling: &Sampling,
) -> Result<Measured, RunError> {
    let mut executor = scene.executor(method, quantity, points)?;
    let mut watch = Watch::new(scene, sampling);

    let solve_ms = executor.solve()?;
    let captured = watch.first(|| executor.capture())?;
    let made_bytes = captured.bytes;
    // Captures that are kept were made before this frame: neither they nor their pipelines cost it.
    let kept = executor.keeps_captures();
    let capture = match kept || executor.needs().no_captures() {
        true => None,
        false => watch.again(captured.value, captured.compiled_ms, || executor.capture())?,
    };
    // Later frames see new captures, or new points where captures are kept: that is what prepare
    // costs again and again.
    let later = if kept {
        Changed::POINTS
    } else {
        Changed::SCENE
    };
    let prepared = watch.first(|| executor.prepare(Changed::ALL))?;
    let prepare = watch.again(prepared.value, prepared.compiled_ms, || {
        executor.prepare(later)
    })?;
    let shaded = watch.first(|| executor.shade())?;
    let shade = watch.again(shaded.value, shaded.compiled_ms, || executor.shade())?;
    let compile = watch.compiled_ms;
    let (estimate, readback) = read_back(&executor, sampling)?;
    check_finite(method.info().id, &estimate, Some(points))?;

    let unread = executor.unread();
    let host_bytes = scene.host_bytes(&*executor.captures()?);
    let made = prepared.bytes + shaded.bytes;
    let kept_bytes = freed(executor.into_session());
    let once = |ms: Option<f64>| ms.and_then(|ms| Timing::of(&[ms]));
    Ok(Measured {
        phases: Phases {
            solve: once(solve_ms),
            capture,
            compile: once(compile),
            prepare,
            shade,
            readback,
        },
        bytes: Bytes {
            captures: host_bytes.unwrap_or(made_bytes),
            own: scene.made_bytes().map_or(kept_bytes, |_| Some(made)),
            points: (points.bytes() + estimate.bytes()) as u64,
        },
        estimate,
        unread,
    })
}

fn read_back<B: Backend>(
    executor: &Executor<'_, B>,
    sampling: &Sampling,
) -> Result<(Estimate, Option<Timing>), RunError> {
    let start = Instant::now();
    let (estimate, Some(_)) = executor.read_back()? else {
        return Ok((executor.read_back()?.0, None));
    };
    let times = sampling.repeat(Elapsed::since(start), || {
        let start = Instant::now();
        executor.read_back()?;
        Ok::<_, EstimatorError>(Elapsed::since(start))
    })?;
    Ok((estimate, sampling.timing(&times)))
}

/// Runs phases, and counts what they compile and keep.
struct Watch<'a, S> {
    scene: &'a S,
    sampling: &'a Sampling,
    footprint: Footprint,
    /// What the pipeline cache reports and the excess of each phase's first run; `None` where nothing is
    /// compiled.
    compiled_ms: Option<f64>,
}

/// What a phase's first run gave.
struct First<T> {
    value: T,
    /// Milliseconds in the pipeline cache.
    compiled_ms: Option<f64>,
    /// Bytes that it left.
    bytes: u64,
}

impl<'a, S: BackendScene> Watch<'a, S> {
    fn new(scene: &'a S, sampling: &'a Sampling) -> Self {
        Self {
            scene,
            sampling,
            footprint: Footprint::of(scene),
            compiled_ms: None,
        }
    }

    fn first<T>(
        &mut self,
        phase: impl FnOnce() -> Result<T, EstimatorError>,
    ) -> Result<First<T>, EstimatorError> {
        let before = self.scene.compiled_ms();
        self.footprint.more(self.scene);
        let value = phase()?;
        Ok(First {
            value,
            compiled_ms: before.zip(self.scene.compiled_ms()).map(|(b, a)| a - b),
            bytes: self.footprint.more(self.scene),
        })
    }

    /// Repeats a phase whose first run took so long, compilation in it.
    fn again(
        &mut self,
        first: Elapsed,
        in_cache_ms: Option<f64>,
        phase: impl FnMut() -> Result<Elapsed, EstimatorError>,
    ) -> Result<Option<Timing>, EstimatorError> {
        let times = self.sampling.repeat(first, phase)?;
        let timing = self.sampling.timing(&times);
        if let (Some(in_cache_ms), Some(timing)) = (in_cache_ms, timing) {
            let excess_ms = (first.ms() - timing.median).max(0.0);
            *self.compiled_ms.get_or_insert(0.0) += in_cache_ms.max(excess_ms);
        }
        Ok(timing)
    }
}
