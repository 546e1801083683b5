use super::*;

#[test]
fn each_metric_has_its_numbers() {
    let mut run = run("a", 1.0, 0.5);
    run.own_model = Some(comparison(0.1, 0.02, Verdict::Inconclusive));
    let value = |run: &Run, metric: Metric| metric.value(run).map(|m| (m.value, m.conclusive));
    assert_eq!(value(&run, Metric::Truth), Some((0.5, true)));
    assert_eq!(value(&run, Metric::OwnModel), Some((0.1, false)));
    assert_eq!(value(&run, Metric::Flip), None);
    run.truth.as_mut().unwrap().flip = Some(0.03);
    let flip = Metric::Flip.value(&run).unwrap();
    assert_eq!((flip.value, flip.noise), (0.03, 0.0));
    // Nothing but noise: all of FLIP may be noise.
    let truth = run.truth.as_mut().unwrap();
    (truth.relmse, truth.noise_floor) = (Some(0.1), Some(0.1));
    assert_eq!(Metric::Flip.value(&run).unwrap().noise, 0.03);
    run.truth = None;
    assert_eq!(Metric::Truth.value(&run), None);
}

#[test]
fn numbers_that_are_none_are_no_error() {
    for odd in [f64::NAN, f64::INFINITY, -1.0] {
        assert_eq!(Metric::Truth.value(&run("a", 1.0, odd)), None);
    }
}

#[test]
fn errors_inside_their_noise_are_alike() {
    let error = |value, noise| Measured {
        value,
        noise,
        conclusive: true,
    };
    let (a, b) = (error(0.10, 0.02), error(0.13, 0.02));
    assert!(a.alike(b) && b.alike(a));
    let b = error(0.15, 0.02);
    assert!(a.surely_less(b) && !b.surely_less(a) && !a.alike(b));
    // Two upper bounds say nothing about each other, however far apart.
    let bound = |value| Measured {
        conclusive: false,
        ..error(value, 0.0)
    };
    assert!(bound(0.1).alike(bound(0.9)));
    assert!(bound(0.1).surely_less(error(0.9, 0.0)));
}

/// FLIP goes with the 0.35th power of relMSE: a sixteenth of noise in that is .379 of it.
#[test]
fn flip_has_its_share_of_the_noise() {
    let mut run = run("a", 1.0, 0.5);
    let truth = run.truth.as_mut().unwrap();
    (truth.relmse, truth.noise_floor) = (Some(0.16), Some(0.01));
    truth.flip = Some(0.03);
    let flip = Metric::Flip.value(&run).unwrap();
    assert!((flip.noise / 0.03 - 0.378_929).abs() < 1e-5, "{flip:?}");
}
