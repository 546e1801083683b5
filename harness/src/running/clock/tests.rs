use super::*;

use interreflect_gpu::Mistimed;
use std::convert::Infallible;

fn host(ms: f64) -> Elapsed {
    Elapsed {
        wall_ms: ms,
        device_ms: None,
    }
}

fn device(wall_ms: f64, ms: f64) -> Elapsed {
    Elapsed {
        wall_ms,
        device_ms: Some(Ok(ms)),
    }
}

/// Times about `ms`, with a relative deviation.
fn noisy(ms: f64, deviation: f64, n: usize, seed: u64) -> Vec<f64> {
    let mut random = fastrand::Rng::with_seed(seed);
    // Twelve uniform numbers: nearly normal.
    let mut normal = || (0..12).map(|_| random.f64()).sum::<f64>() - 6.0;
    (0..n).map(|_| ms * (1.0 + deviation * normal())).collect()
}

#[test]
fn steady_times_settle_early_and_wild_ones_do_not() -> Result<(), Infallible> {
    let sampling = Sampling {
        patience_ms: 1e6,
        ..Sampling::default()
    };
    let times = |deviation| {
        let mut series = noisy(10.0, deviation, 300, 3).into_iter().map(host);
        sampling.repeat(host(50.0), || {
            Ok::<_, Infallible>(series.next().unwrap_or(host(10.0)))
        })
    };
    let (steady, wild) = (times(0.01)?, times(0.9)?);
    assert_eq!(steady.len(), sampling.least);
    assert_eq!(wild.len(), sampling.most);
    assert!(
        sampling
            .timing(&steady)
            .is_some_and(|t| t.settled == Some(true))
    );
    assert!(
        sampling
            .timing(&wild)
            .is_some_and(|t| t.settled == Some(false))
    );
    Ok(())
}

#[test]
fn patience_ends() -> Result<(), Infallible> {
    let sampling = Sampling::default();
    let slow = sampling.repeat(host(1.0), || Ok::<_, Infallible>(host(200.0)))?;
    assert_eq!(slow.len(), 2);
    let once = sampling.repeat(host(300.0), || Ok::<_, Infallible>(host(200.0)))?;
    assert_eq!(once, [host(300.0)]);
    assert!(
        sampling
            .timing(&once)
            .is_some_and(|t| t.settled == Some(false) && t.n == 1)
    );
    assert_eq!(
        Sampling::ONCE.repeat(host(2.0), || Ok::<_, Infallible>(host(9.0)))?,
        [host(2.0)]
    );
    Ok(())
}

/// In 95 of 100 cases the interval should hold the true median; with 200 series 3σ is 4.6 %, and the
/// percentile bootstrap of a few times is known to be a little narrow.
#[test]
fn intervals_hold_the_median_as_often_as_they_say() {
    let holds = (0..200_u64).filter(|&seed| {
        interval(&noisy(10.0, 0.1, 25, seed)).is_some_and(|(low, high)| low <= 10.0 && 10.0 <= high)
    });
    let share = holds.count() as f64 / 200.0;
    assert!((0.88..=1.0).contains(&share), "{share}");
}

#[test]
fn a_trend_is_seen_and_noise_is_not() {
    let steady = noisy(10.0, 0.05, 40, 1);
    assert_eq!(drift(&steady), None);
    let warming = steady
        .iter()
        .enumerate()
        .map(|(i, t)| t * (1.0 + 0.01 * i as f64));
    let found = drift(&warming.collect::<Vec<_>>());
    // 1 % a time over 39 steps, over a median of 1.2.
    assert!(
        found.is_some_and(|d| (d - 0.39 / 1.195).abs() < 0.08),
        "{found:?}"
    );
}

#[test]
fn clocks_that_step_are_not_believed() {
    assert_eq!(quantum(&[1.0, 2.0, 1.0, 1.0, 2.0]), Some(1.0));
    assert_eq!(quantum(&[0.1; 5]), Some(0.1));
    assert_eq!(quantum(&[1.01, 1.0, 1.01, 1.0, 1.0]), None);
    assert_eq!(quantum(&noisy(1.0, 0.2, 30, 9)), None);
    let coarse = [3.0, 3.5, 3.1, 3.2, 3.3].map(|wall| device(wall, 1.0));
    let timing = Sampling::default().timing(&coarse);
    let timing = timing.expect("five times");
    assert_eq!((timing.median, timing.source), (3.2, TimeSource::WallClock));
    assert_eq!(timing.fallback, Some(Fallback::Coarse { step_ms: 1.0 }));
}

#[test]
fn one_refused_time_means_the_hosts_clock_for_all() {
    let mut times = [1.0, 1.1, 1.2, 1.3, 1.4].map(|ms| device(ms + 5.0, ms));
    let by_device = Sampling::default().timing(&times).expect("five times");
    assert_eq!(
        (by_device.median, by_device.source),
        (1.2, TimeSource::GpuTimestamps)
    );
    times[3].device_ms = Some(Err(Mistimed::Backwards));
    let by_host = Sampling::default().timing(&times).expect("five times");
    assert_eq!(
        (by_host.median, by_host.source),
        (6.2, TimeSource::WallClock)
    );
    assert_eq!(by_host.fallback, Some(Fallback::Backwards));
}
