//! Runs for tests.
#![allow(clippy::unwrap_used, reason = "tests")]

use crate::domain::metrics::{Reference, compare};
use crate::domain::record::{Backend, Comparison, ParamValue, Phases, Run, Timing, Verdict};
use glam::Vec3;
use interreflect_scene::Estimate;

/// A comparison with these numbers.
pub(crate) fn comparison(relmse: f64, noise: f64, verdict: Verdict) -> Comparison {
    let mut estimate = Estimate::new(1);
    estimate.set(0, Vec3::ONE);
    let reference = Reference {
        values: &estimate,
        standard_error: None,
        description: "",
    };
    Comparison {
        relmse: Some(relmse),
        noise_floor: Some(noise),
        verdict,
        ..compare(&estimate, reference, None).unwrap()
    }
}

/// A time whose interval reaches so far to either side.
pub(crate) fn timing(ms: f64, spread: f64) -> Option<Timing> {
    Some(Timing {
        low: ms - spread,
        high: ms + spread,
        ..Timing::of(&[ms])?
    })
}

/// A run of `estimator` with this frame time and error, both without noise.
pub(crate) fn run(estimator: &str, ms: f64, relmse: f64) -> Run {
    noisy(estimator, (ms, 0.0), (relmse, 0.0))
}

/// As [`run`], with the reach of the time's interval and the noise of the error.
pub(crate) fn noisy(estimator: &str, (ms, spread): (f64, f64), (relmse, noise): (f64, f64)) -> Run {
    Run {
        points: 64,
        phases_ms: Phases {
            shade: timing(ms, spread),
            ..Phases::default()
        },
        truth: Some(comparison(relmse, noise, Verdict::Conclusive)),
        ..Run::new("room", estimator, Backend::Cpu, "irradiance")
    }
}

/// The run with a parameter.
pub(crate) fn with(mut run: Run, name: &str, value: ParamValue) -> Run {
    run.params.0.push((name.into(), value));
    run
}

/// A path-traced run whose error falls by the number of samples.
pub(crate) fn traced(samples: u32, bounces: u32, ms_a_sample: f64, error_of_one: f64) -> Run {
    let n = f64::from(samples);
    let run = run("path_reference", n * ms_a_sample, error_of_one / n);
    let run = with(run, "samples", ParamValue::U32(samples));
    with(run, "bounces", ParamValue::U32(bounces))
}
