//! One method on one backend: captured, prepared and shaded, each phase timed.

use crate::error::HarnessError;
use crate::metrics::check_finite;
use crate::record::{Phases, Timing};
use interreflect_estimators::stage::{Placed, Stage};
use interreflect_estimators::{Backend, Changed, Configured, Inputs, Quantity};
use interreflect_scene::{Estimate, Needs, Points, Scene};

/// An estimate and the time that it took.
pub struct Measured {
    /// The quantity at each point.
    pub estimate: Estimate,
    /// Where the time went.
    pub phases: Phases,
    /// Captures that were declared and never read: empty for an honest method.
    pub unread: Needs,
}

/// Time after which a phase is not repeated further.
const PATIENCE_MS: f64 = 1500.0;

/// Runs a method `repeat` times, fewer where one time takes long; the first time warms up and
/// counts only if there is no second.
///
/// # Errors
/// [`HarnessError`] if the method can't run here, or estimates a number that is not finite.
pub fn measure<S: Stage>(
    stage: &S,
    scene: &Scene,
    method: &dyn Configured,
    quantity: Quantity,
    points: &Points,
    repeat: usize,
) -> Result<Measured, HarnessError> {
    let facts = scene.facts();
    let needs = method.needs(quantity, &facts)?;
    let mut session = stage.open(method)?;
    let Placed {
        points: placed,
        mut out,
    } = stage.place(points)?;
    let mut compiled = Compiled::default();

    let solve_ms = stage.solve(&needs)?;
    // Captures that are kept were made before this frame: neither they nor their pipelines cost it.
    let kept = scene.keeps_captures(needs.keep_within_m);
    let (captures, capture_ms) = if kept || needs.no_captures() {
        (stage.capture(&needs)?.0, None)
    } else {
        compiled.repeat(stage, repeat, || stage.capture(&needs))?
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
    let mut frame = std::iter::once(&first).chain(std::iter::repeat(&again));
    let (_, prepare_ms) = compiled.repeat(stage, repeat, || {
        let inputs = frame.next().unwrap_or(&again);
        let ms = stage.timed("prepare", &mut |cx| {
            session.prepare(cx, quantity, inputs, &out)
        })?;
        Ok(((), ms))
    })?;
    let (_, shade_ms) = compiled.repeat(stage, repeat, || {
        let ms = stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &first, &mut out)
        })?;
        Ok(((), ms))
    })?;
    let (estimate, readback_ms) = read_back(stage, &out, repeat)?;
    check_finite(method.info().id, &estimate, Some(points))?;

    let unread = unread(&needs, [first.read(), again.read()]);
    Ok(Measured {
        estimate,
        phases: Phases {
            solve: solve_ms.and_then(|ms| Timing::of(&[ms])),
            capture: capture_ms,
            compile: compiled.ms.and_then(|ms| Timing::of(&[ms])),
            prepare: prepare_ms,
            shade: shade_ms,
            readback: readback_ms,
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
    repeat: usize,
) -> Result<(Estimate, Option<Timing>), HarnessError> {
    let (mut estimate, _) = stage.read_back(out)?;
    let mut times = Vec::new();
    for _ in 0..repeat {
        let (values, Some(ms)) = stage.read_back(out)? else {
            break;
        };
        estimate = values;
        times.push(ms);
    }
    Ok((estimate, Timing::of(&times)))
}

/// Compilation: what the pipeline cache reports and the excess of each phase's first run.
#[derive(Default)]
struct Compiled {
    ms: Option<f64>,
}

impl Compiled {
    fn repeat<S: Stage, T>(
        &mut self,
        stage: &S,
        repeat: usize,
        mut phase: impl FnMut() -> Result<(T, f64), interreflect_estimators::EstimatorError>,
    ) -> Result<(T, Option<Timing>), HarnessError> {
        let before = stage.compiled_ms();
        let (mut value, first_ms) = phase()?;
        let in_cache = before.zip(stage.compiled_ms()).map(|(b, a)| a - b);
        let mut times = Vec::new();
        while times.len() < repeat && times.iter().sum::<f64>() + first_ms < PATIENCE_MS {
            let (v, ms) = phase()?;
            value = v;
            times.push(ms);
        }
        if times.is_empty() {
            times.push(first_ms);
        }
        let timing = Timing::of(&times);
        if let (Some(in_cache), Some(timing)) = (in_cache, timing) {
            let excess = (first_ms - timing.median).max(0.0);
            *self.ms.get_or_insert(0.0) += in_cache.max(excess);
        }
        Ok((value, timing))
    }
}
