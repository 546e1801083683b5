use super::{interval, quantum};

/// Pascal's triangle by logarithms: P(Bin(n, p) ≥ k).
fn at_least(n: usize, p: f64, k: usize) -> f64 {
    let ln_factorial = |n: usize| (1..=n).map(|i| (i as f64).ln()).sum::<f64>();
    let term = |i: usize| {
        let choose = ln_factorial(n) - ln_factorial(i) - ln_factorial(n - i);
        let power = |base: f64, times: usize| match times {
            0 => 0.0,
            _ => times as f64 * base.ln(),
        };
        (choose + power(p, i) + power(1.0 - p, n - i)).exp()
    };
    (k..=n).map(term).sum()
}

/// The ends' ranks, from 1, among 1, 2, … n.
fn ranks(n: usize) -> (usize, usize) {
    let times: Vec<f64> = (1..=n).map(|i| i as f64).collect();
    let (low, high) = interval(&times).expect("more than one time");
    (low as usize, high as usize)
}

/// Odd numbers of times, whose bootstrap medians are times themselves.
fn counts() -> impl Iterator<Item = usize> {
    (41..=241).step_by(4)
}

/// The true median lies between the a-th and the b-th of n independent times with the probability that a
/// binomial of n and ½ is from a to b − 1, whatever their distribution.
#[test]
fn intervals_hold_the_true_median_in_95_of_100_cases() {
    let covered = |n: usize| {
        let (a, b) = ranks(n);
        at_least(n, 0.5, a) - at_least(n, 0.5, b)
    };
    let series = counts().count() as f64;
    let mean = counts().map(covered).sum::<f64>() / series;
    // 90 % intervals would hold it in .9; all counts share one stream of 200 resamples, whose ends are a
    // hundredth off.
    assert!((0.93..0.97).contains(&mean), "{mean}");
}

#[test]
fn few_times_have_no_interval_and_equal_ones_no_width() {
    assert_eq!(interval(&[]), None);
    assert_eq!(interval(&[3.0]), None);
    assert_eq!(interval(&[3.0; 9]), Some((3.0, 3.0)));
}

/// A clock is too coarse where its step is more than a twentieth of the median and a quarter of the times are
/// equal.
#[test]
fn steps_of_a_clock_are_large_or_do_no_harm() {
    let stepping = |step: f64| [1.0, 1.0, 1.0 + step, 1.0 + step, 1.0 + 2.0 * step];
    assert_eq!(quantum(&stepping(0.04)), None);
    let found = quantum(&stepping(0.07)).expect("a coarse clock");
    assert!((found - 0.07).abs() < 1e-12, "{found}");
    let one_pair = |n: usize| {
        let mut times: Vec<f64> = (0..n)
            .map(|i| 1.0 + 0.3 * i as f64 / n as f64 * 3.0)
            .collect();
        times[0] = times[1];
        quantum(&times).is_some()
    };
    assert!(one_pair(4) && !one_pair(6));
    assert_eq!(quantum(&[1.0, 1.0]), None, "two times say nothing");
}
