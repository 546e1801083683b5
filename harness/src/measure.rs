//! One method on one backend: captured, prepared and shaded, each phase timed.

use crate::clock::Sampling;
use crate::error::HarnessError;
use crate::footprint::{Footprint, freed};
use crate::metrics::check_finite;
use crate::record::{Bytes, Phases, Timing};
use interreflect_estimators::stage::{Elapsed, Placed, Stage};
use interreflect_estimators::{Backend, Changed, Configured, EstimatorError, Inputs, Quantity};
use interreflect_scene::{Estimate, Needs, Points, Scene};
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
/// [`HarnessError`] if the method can't run here, or estimates a number that is not finite.
pub fn measure<S: Stage>(
    stage: &S,
    scene: &Scene,
    method: &dyn Configured,
    quantity: Quantity,
    points: &Points,
    sampling: &Sampling,
) -> Result<Measured, HarnessError> {
    let facts = scene.facts();
    let needs = method.needs(quantity, &facts)?;
    let mut session = stage.open(method)?;
    let mut watch = Watch::new(stage, sampling);
    let Placed {
        points: placed,
        mut out,
    } = stage.place(points)?;

    let solve_ms = stage.solve(&needs)?;
    let first = watch.first(|| stage.capture(&needs))?;
    let made_bytes = first.bytes;
    let (captures, elapsed) = first.value;
    // Captures that are kept were made before this frame: neither they nor their pipelines cost it.
    let kept = scene.keeps_captures(needs.keep_within_m);
    let capture = match kept || needs.no_captures() {
        true => None,
        false => watch.again(elapsed, first.compiled_ms, || Ok(stage.capture(&needs)?.1))?,
    };
    let inputs = |changed| {
        let origin = (facts, scene.capture_origin(needs.keep_within_m));
        Inputs::new(&needs, &captures, &placed, points, origin, changed)
    };
    // Later frames see new captures, or new points where captures are kept: that is what prepare
    // costs again and again.
    let later = if kept {
        Changed::POINTS
    } else {
        Changed::SCENE
    };
    let (first, again) = (inputs(Changed::ALL), inputs(later));
    let mut prepare = |inputs: &Inputs<'_, S::Backend>| {
        stage.timed("prepare", &mut |cx| {
            session.prepare(cx, quantity, inputs, &out)
        })
    };
    let prepared = watch.first(|| prepare(&first))?;
    let prepare = watch.again(prepared.value, prepared.compiled_ms, || prepare(&again))?;
    let mut shade = || {
        stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &first, &mut out)
        })
    };
    let shaded = watch.first(&mut shade)?;
    let shade = watch.again(shaded.value, shaded.compiled_ms, shade)?;
    let compile = watch.compiled_ms;
    let (estimate, readback) = read_back(stage, &out, sampling)?;
    let made = prepared.bytes + shaded.bytes;
    let kept_bytes = freed(session);
    let own = stage.made_bytes().map_or(kept_bytes, |_| made);
    let points_bytes = (points.bytes() + estimate.bytes()) as u64;
    check_finite(method.info().id, &estimate, Some(points))?;

    let unread = unread(&needs, [first.read(), again.read()]);
    let once = |ms: Option<f64>| ms.and_then(|ms| Timing::of(&[ms]));
    Ok(Measured {
        estimate,
        phases: Phases {
            solve: once(solve_ms),
            capture,
            compile: once(compile),
            prepare,
            shade,
            readback,
        },
        bytes: Bytes {
            captures: stage.host_bytes(&captures).unwrap_or(made_bytes),
            own,
            points: points_bytes,
        },
        unread,
    })
}

/// What was declared and never read.
fn unread(needs: &Needs, read: [Needs; 2]) -> Needs {
    let [first, again] = &read;
    Needs {
        cubes: &(&needs.cubes - &first.cubes) - &again.cubes,
        light_views: &(&needs.light_views - &first.light_views) - &again.light_views,
        directional_depths: &(&needs.directional_depths - &first.directional_depths)
            - &again.directional_depths,
        environment: needs.environment && !first.environment,
        light_transport: needs.light_transport && !read[0].light_transport,
        ..Needs::default()
    }
}

fn read_back<S: Stage>(
    stage: &S,
    out: &<S::Backend as Backend>::Out,
    sampling: &Sampling,
) -> Result<(Estimate, Option<Timing>), HarnessError> {
    let start = Instant::now();
    let (estimate, Some(_)) = stage.read_back(out)? else {
        return Ok((stage.read_back(out)?.0, None));
    };
    let times = sampling.repeat(Elapsed::since(start), || {
        let start = Instant::now();
        stage.read_back(out)?;
        Ok::<_, EstimatorError>(Elapsed::since(start))
    })?;
    Ok((estimate, sampling.timing(&times)))
}

/// Runs phases, and counts what they compile and keep.
struct Watch<'a, S> {
    stage: &'a S,
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

impl<'a, S: Stage> Watch<'a, S> {
    fn new(stage: &'a S, sampling: &'a Sampling) -> Self {
        Self {
            stage,
            sampling,
            footprint: Footprint::of(stage),
            compiled_ms: None,
        }
    }

    fn first<T>(
        &mut self,
        phase: impl FnOnce() -> Result<T, EstimatorError>,
    ) -> Result<First<T>, EstimatorError> {
        let before = self.stage.compiled_ms();
        self.footprint.more(self.stage);
        let value = phase()?;
        Ok(First {
            value,
            compiled_ms: before.zip(self.stage.compiled_ms()).map(|(b, a)| a - b),
            bytes: self.footprint.more(self.stage),
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

#[cfg(test)]
mod tests;
