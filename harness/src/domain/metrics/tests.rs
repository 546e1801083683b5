#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use crate::domain::record::Verdict;
use interreflect_scene::{Point, PointLayout};

fn estimate(values: &[[f32; 3]]) -> Estimate {
    let mut estimate = Estimate::new(values.len());
    for (i, v) in values.iter().enumerate() {
        estimate.set(i, Vec3::from_array(*v));
    }
    estimate
}

fn grey(values: &[f32]) -> Estimate {
    estimate(&values.iter().map(|v| [*v; 3]).collect::<Vec<_>>())
}

fn exact(values: &Estimate) -> Reference<'_> {
    Reference {
        values,
        standard_error: None,
        description: "exact",
    }
}

fn close(actual: Option<f64>, expected: f64) {
    let actual = actual.unwrap();
    // Sums of a handful of f32 inputs in f64: rounding of .01, .1 and the like to f32 dominates.
    assert!(
        (actual - expected).abs() <= 1e-6 * expected.abs(),
        "{actual} is not {expected}"
    );
}

#[test]
fn metrics_by_hand() {
    // Two points, six values. Mean |r| = 12/6 = 2, so ε = 4e-4.
    let (e, r) = (
        estimate(&[[1.0, 2.0, 3.0], [2.0, 2.0, 1.0]]),
        grey(&[1.0, 3.0]),
    );
    let c = compare(&e, exact(&r), None).unwrap();
    // Errors 0 1 2 −1 −1 −2.
    close(Some(c.rmse), (11.0_f64 / 6.0).sqrt());
    close(Some(c.epsilon), 4e-4);
    close(c.relmse, (5.0 / 1.0004 + 6.0 / 9.0004) / 6.0);
    close(c.energy_ratio, 11.0 / 12.0);
    assert_eq!((c.max, c.p999, c.compared), (2.0, 2.0, 2));
    assert_eq!((c.noise_floor, c.noise_floor_rmse), (Some(0.0), 0.0));
    assert_eq!(c.verdict, Verdict::Conclusive);
    assert_eq!(c.relmse_above_noise, c.relmse);
    assert_eq!(c.reference.as_deref(), Some("exact"));
}

#[test]
fn black_points_count() {
    // A leak onto a black reference: without the black point the error would be 0.
    let (e, r) = (grey(&[1.0, 1.0]), grey(&[1.0, 0.0]));
    let c = compare(&e, exact(&r), None).unwrap();
    close(c.relmse, 0.5 / (0.01_f64 * 0.5).powi(2));
    close(Some(c.rmse), 0.5_f64.sqrt());
    // A black estimate of a lit point is an error of 100 %, not a missing value.
    let c = compare(&grey(&[0.0, 1.0]), exact(&grey(&[1.0, 1.0])), None).unwrap();
    close(c.relmse, 0.5 / 1.0001);
    close(c.energy_ratio, 0.5);
}

#[test]
fn relative_metrics_ignore_the_unit_and_absolute_ones_follow_it() {
    let (e, r) = ([1.0_f32, 2.5, 0.0], [1.5_f32, 2.0, 0.25]);
    let scaled = |v: &[f32], f: f32| grey(&v.iter().map(|x| x * f).collect::<Vec<_>>());
    let (a, b) = (
        compare(&scaled(&e, 1.0), exact(&scaled(&r, 1.0)), None).unwrap(),
        compare(&scaled(&e, 1024.0), exact(&scaled(&r, 1024.0)), None).unwrap(),
    );
    close(b.relmse, a.relmse.unwrap());
    close(b.energy_ratio, a.energy_ratio.unwrap());
    close(Some(b.rmse), 1024.0 * a.rmse);
    close(Some(b.max), 1024.0 * a.max);
}

#[test]
fn a_zero_reference_has_no_relative_metrics() {
    let c = compare(&grey(&[0.0, 2.0]), exact(&grey(&[0.0, 0.0])), None).unwrap();
    assert_eq!(
        (c.relmse, c.energy_ratio, c.noise_floor),
        (None, None, None)
    );
    close(Some(c.rmse), 2.0_f64.sqrt());
    assert_eq!(c.verdict, Verdict::Conclusive);
}

#[test]
fn percentiles_are_by_nearest_rank() {
    let sorted: Vec<f64> = (1..=2000).map(f64::from).collect();
    assert_eq!(nearest_rank(&sorted, 0.999), 1998.0);
    assert_eq!(nearest_rank(&sorted, 1.0), 2000.0);
    assert_eq!(nearest_rank(&sorted[..1], 0.999), 1.0);
}

#[test]
fn a_few_spikes_show_in_the_maximum_only() {
    let mut values = vec![1.0; 2000];
    values[7] = 9.0;
    let c = compare(&grey(&values), exact(&grey(&[1.0; 2000])), None).unwrap();
    assert_eq!((c.p999, c.max), (0.0, 8.0));
}

/// Normally distributed numbers from a fixed sequence (sums of twelve uniform ones).
fn noise(seed: u64) -> impl FnMut() -> f32 {
    let mut state = seed;
    move || {
        let sum: f64 = (0..12)
            .map(|_| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            })
            .sum();
        (sum - 6.0) as f32
    }
}

/// Verdict on an estimate that is off by a relative bias, against a reference with noise.
fn verdict(points: usize, bias: f32, sigma: f32, seed: u64) -> Comparison {
    let mut noise = noise(seed);
    let reference: Vec<f32> = (0..points).map(|_| 1.0 + sigma * noise()).collect();
    let error = grey(&vec![sigma; points]);
    let values = grey(&reference);
    let reference = Reference {
        values: &values,
        standard_error: Some(&error),
        description: "",
    };
    compare(&grey(&vec![1.0 + bias; points]), reference, None).unwrap()
}

#[test]
fn a_difference_below_the_noise_is_inconclusive() {
    for seed in 0..200 {
        // A perfect estimate: the reference's noise is all there is, few points or many.
        assert_eq!(
            verdict(1000, 0.0, 0.05, seed).verdict,
            Verdict::Inconclusive,
            "seed {seed}"
        );
        // A bias of three standard errors stands out of a thousand points.
        assert_eq!(
            verdict(1000, 0.15, 0.05, seed).verdict,
            Verdict::Conclusive,
            "seed {seed}"
        );
    }
    let c = verdict(1000, 0.0, 0.05, 1);
    // ε moves the floor by 1e-4, the noise in r² by about 3σ²; relMSE varies by √(2/1000).
    let (floor, relmse) = (c.noise_floor.unwrap(), c.relmse.unwrap());
    assert!((floor / 0.0025 - 1.0).abs() < 0.03, "floor {floor}");
    assert!(
        (relmse / floor - 1.0).abs() < 4.0 * (2.0_f64 / 1000.0).sqrt(),
        "relMSE {relmse}"
    );
}

#[test]
fn few_points_need_a_larger_difference() {
    let conclusive = |points| {
        let runs =
            (0..2000).filter(|&s| verdict(points, 0.0, 0.05, s).verdict == Verdict::Conclusive);
        runs.count()
    };
    // With one point noise alone exceeds twice its floor in 16 % of all cases (z² > 2), and the
    // floor plus three deviations, z² > 1 + 3√2, in 2.2 %: 44 of 2000, ± 4 standard deviations.
    let count = conclusive(1);
    assert!((17..=71).contains(&count), "{count} of 2000 single points");
}

#[test]
fn points_without_a_surface_are_left_out() {
    let surface = Point {
        normal: Vec3::Y,
        ..Point::default()
    };
    let points = Points::new(PointLayout::Surface, [Some(surface), None]);
    let (e, r) = (grey(&[1.0, f32::NAN]), grey(&[1.0, 5.0]));
    let c = compare(&e, exact(&r), Some(&points)).unwrap();
    assert_eq!((c.compared, c.rmse, c.energy_ratio), (1, 0.0, Some(1.0)));
    let nothing = Points::new(PointLayout::Surface, [None, None]);
    let error = compare(&e, exact(&r), Some(&nothing)).unwrap_err();
    assert_eq!(error, MetricsError::NoPoints { points: 2 });
}

#[test]
fn a_value_that_is_not_finite_is_an_error_that_names_the_point() {
    let surface = Point {
        position: Vec3::new(1.0, 2.0, 3.0),
        normal: Vec3::Y,
        ..Point::default()
    };
    let points = Points::new(PointLayout::Surface, [Some(surface); 3]);
    let (e, r) = (grey(&[1.0, 1.0, f32::INFINITY]), grey(&[1.0; 3]));
    let message = compare(&e, exact(&r), Some(&points))
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("estimate is not finite at point 2 at position [1, 2, 3]"),
        "{message}"
    );
    let message = compare(&r, exact(&e), Some(&points))
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("reference is not finite at point 2"),
        "{message}"
    );
}

#[test]
fn lists_of_other_lengths_are_refused() {
    let error = compare(&grey(&[1.0]), exact(&grey(&[1.0, 2.0])), None).unwrap_err();
    let expected = MetricsError::Length {
        estimate: 1,
        what: "reference",
        other: 2,
    };
    assert_eq!(error, expected);
}

#[test]
fn an_underestimated_error_at_a_dark_point_decides_nothing() {
    // Bright points with honest noise; one dark point whose samples all agreed on 0 while the
    // estimate has the faint light that is there.
    let mut reference = Estimate::new(101);
    let mut standard_error = Estimate::new(101);
    for i in 0..100 {
        reference.set(i, Vec3::splat(1.0));
        standard_error.set(i, Vec3::splat(0.1));
    }
    let mut estimate = reference.clone();
    estimate.set(100, Vec3::splat(0.3));
    let reference = Reference {
        values: &reference,
        standard_error: Some(&standard_error),
        description: "",
    };
    let comparison = compare(&estimate, reference, None).expect("finite values");
    assert!(
        comparison
            .relmse
            .is_some_and(|r| r > 2.0 * comparison.noise_floor.unwrap_or(0.0))
    );
    assert_eq!(comparison.verdict, Verdict::Inconclusive);
}
