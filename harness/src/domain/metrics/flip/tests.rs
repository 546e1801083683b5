#![allow(clippy::unwrap_used, reason = "tests")]
use super::*;
use glam::Vec3;

const SIZE: usize = 32;

fn everywhere(_: usize) -> bool {
    true
}

/// Stripes of several widths between dim and bright, so that there are edges to lose.
fn pattern() -> HdrImage {
    let mut image = HdrImage::new(SIZE, SIZE);
    for y in 0..SIZE {
        for x in 0..SIZE {
            let stripe = (x / (1 + y / 8)) % 2;
            image.set(x, y, Vec3::new(0.3, 0.5, 0.4) * (0.4 + 0.6 * stripe as f32));
        }
    }
    image
}

/// The pattern, brighter by a factor.
fn times(factor: f32) -> HdrImage {
    let mut image = pattern();
    image.pixels.iter_mut().for_each(|p| *p *= factor);
    image
}

#[test]
fn an_image_does_not_differ_from_itself() {
    let same = flip(&pattern(), &pattern(), everywhere).unwrap();
    assert_eq!(
        same,
        Flip {
            mean: 0.0,
            p95: 0.0
        }
    );
    let black = HdrImage::new(SIZE, SIZE);
    assert_eq!(flip(&black, &black, everywhere).unwrap().mean, 0.0);
}

#[test]
fn a_growing_error_gives_a_growing_difference() {
    let differences: Vec<f64> = [1.0, 0.9, 0.7, 0.5, 0.2, 0.0]
        .map(|f| flip(&times(f), &pattern(), everywhere).unwrap().mean)
        .into();
    assert!(differences.is_sorted_by(|a, b| a < b), "{differences:?}");
    assert!(differences.iter().all(|d| (0.0..=1.0).contains(d)));
}

/// Grey against black has no edges, so that the answer is the colour term alone. In L*a*b* two greys differ
/// by their lightness; that is raised to 0.7 and compared with what the same formulas give for green and
/// blue (Hunt's adjustment, the distance HyAB: 203.3 to the power of 0.7), of which the first 40 % take 95 %
/// of the scale.
#[test]
fn greys_differ_by_their_lightness() {
    let uniform = |v: f32| {
        let mut image = HdrImage::new(SIZE, SIZE);
        image.pixels.fill(Vec3::splat(v));
        image
    };
    // The reference shows as 0.9 of white: sRGB 243 of 255, linear 0.8963, L* 95.8.
    let shown = flip(&HdrImage::new(SIZE, SIZE), &uniform(1.0), everywhere).unwrap();
    let lightness = 116.0 * 0.8963_f64.cbrt() - 16.0;
    let (distance, most) = (lightness.powf(0.7), 203.3_f64.powf(0.7));
    let knee = 0.4 * most;
    assert!(distance < most && distance > knee);
    let expected = 0.95 + (distance - knee) / (most - knee) * 0.05;
    // 8 bits, and the constants of the library's float32.
    assert!(
        (shown.mean - expected).abs() < 1e-3,
        "{} {expected}",
        shown.mean
    );
    assert!((shown.p95 - shown.mean).abs() < 1e-6);
    // A tenth less is no more than a tenth of that lightness.
    let less = flip(&uniform(0.9), &uniform(1.0), everywhere).unwrap();
    assert!(less.mean > 0.0 && less.mean < 0.2 * shown.mean, "{less:?}");
}

/// A pixel that shows no surface has no weight, however wrong it is; beyond the reach of the filters it
/// has no influence either.
#[test]
fn what_shows_no_surface_does_not_count() {
    let (mut estimate, reference) = (pattern(), pattern());
    for y in 0..SIZE {
        estimate.set(0, y, Vec3::splat(9.0));
    }
    let beyond = |i: usize| i % SIZE > FLIP_REACH;
    assert_eq!(flip(&estimate, &reference, beyond).unwrap().mean, 0.0);
    let all = flip(&estimate, &reference, everywhere).unwrap();
    let but_one = flip(&estimate, &reference, |i| i % SIZE > 0).unwrap();
    assert!(all.mean > but_one.mean && but_one.mean > 0.0);
    assert_eq!(flip(&estimate, &reference, |_| false), None);
}

/// The exposure is the reference's: an estimate that is brighter than white throughout is white.
#[test]
fn clipped_estimates_are_alike() {
    let brighter = |f| flip(&times(f), &pattern(), everywhere).unwrap();
    assert_eq!(brighter(100.0), brighter(1000.0));
    assert!(brighter(100.0).mean > 0.0);
}

#[test]
fn odd_sizes_and_odd_values_have_an_answer() {
    let one = |v| HdrImage {
        width: 1,
        height: 1,
        pixels: vec![v],
    };
    let white = one(Vec3::ONE);
    let difference = |v| flip(&one(v), &white, everywhere).unwrap();
    assert_eq!(difference(Vec3::ONE).mean, 0.0);
    for odd in [
        Vec3::ZERO,
        Vec3::NEG_ONE,
        Vec3::NAN,
        Vec3::INFINITY,
        Vec3::splat(f32::MAX),
    ] {
        let d = difference(odd);
        assert!(
            (0.0..=1.0).contains(&d.mean) && d.p95 == d.mean,
            "{odd}: {d:?}"
        );
    }
    let unlit = flip(&white, &one(Vec3::NAN), everywhere).unwrap();
    assert!(unlit.mean.is_finite());
    assert_eq!(flip(&white, &pattern(), everywhere), None);
    let nothing = HdrImage::new(0, 0);
    assert_eq!(flip(&nothing, &nothing, everywhere), None);
}
