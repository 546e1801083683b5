use super::*;
use glam::Vec3;
use interreflect_scene::Estimate;
use statrs::distribution::{Normal, StudentsT};

const POINTS: usize = 400;

/// Estimates of 1 that are off by `off` spreads more than chance; each channel has its own chance.
fn estimates(stream: u32, off: f64, spread: f64) -> Traced {
    let student = StudentsT::new(0.0, 1.0, 31.0).expect("degrees of freedom");
    let mut traced = Traced {
        mean: Estimate::new(POINTS),
        spread: Estimate::new(POINTS),
        unseen: Estimate::new(POINTS),
        standard_error: Estimate::new(POINTS),
        samples: 1 << 20,
    };
    for i in 0..POINTS {
        let chance = sobol_burley::sample_4d(i as u32, 0, stream);
        let t = |c: usize| student.inverse_cdf(f64::from(chance[c]).max(1e-7));
        let value = |c: usize| (1.0 + spread * (t(c) + off)) as f32;
        traced.mean.set(i, Vec3::from([0, 1, 2].map(value)));
        traced.spread.set(i, Vec3::splat(spread as f32));
    }
    traced
}

fn verdict(traced: &Traced) -> Result<(), Disagreement> {
    Scores::against(traced, |_| 1.0)?.check()
}

#[test]
fn what_is_right_is_accepted() {
    for stream in 0..20 {
        assert_eq!(verdict(&estimates(stream, 0.0, 0.01)), Ok(()));
        let [a, b] = [(0, 0.01), (100, 0.03)].map(|(s, e)| estimates(stream + s, 0.0, e));
        let between = Scores::between(&a, &b).expect("numbers");
        assert_eq!(between.check(), Ok(()));
    }
}

#[test]
fn a_bias_of_all_points_is_rejected() {
    for off in [0.7, -1.0, 3.0] {
        let found = verdict(&estimates(1, off, 0.01));
        assert!(matches!(
            found,
            Err(Disagreement::Off { .. } | Disagreement::Outlier { .. })
        ));
    }
}

#[test]
fn one_point_that_is_wrong_is_rejected() {
    let mut traced = estimates(1, 0.0, 0.01);
    traced.mean.set(17, Vec3::new(1.0, 1.08, 1.0));
    let found = verdict(&traced);
    assert!(
        matches!(found, Err(Disagreement::Outlier { point: 17, .. })),
        "{found:?}"
    );
    traced.mean.set(17, Vec3::new(1.0, f32::NAN, 1.0));
    assert_eq!(
        verdict(&traced),
        Err(Disagreement::NotANumber { point: 17 })
    );
}

#[test]
fn errors_that_are_stated_wrongly_are_rejected() {
    let stated = |factor: f32| {
        let mut traced = estimates(1, 0.0, 0.01);
        for i in 0..POINTS {
            traced.spread.set(i, traced.spread.get(i) * factor);
        }
        verdict(&traced)
    };
    assert!(matches!(stated(1.3), Err(Disagreement::TooGood { .. })));
    assert!(matches!(stated(0.7), Err(Disagreement::Off { .. })));
    assert_eq!(stated(1.0), Ok(()));
}

#[test]
fn a_thing_compared_with_itself_tells_nothing() {
    let traced = estimates(1, 0.0, 0.0);
    assert_eq!(verdict(&traced), Err(Disagreement::Nothing));
    let noisy = estimates(1, 0.0, 0.01);
    let same = Scores::between(&noisy, &noisy).expect("numbers").check();
    assert!(
        matches!(same, Err(Disagreement::TooGood { .. })),
        "{same:?}"
    );
}

#[test]
fn bounds_are_those_of_tables() {
    // Two-sided at 1e-3: 3.2905. Of 100 values each is tested at 1.0005e-5: 4.4171.
    assert!((largest_bound(1, 1e-3) - 3.290_527).abs() < 1e-5);
    assert!((largest_bound(100, 1e-3) - 4.417).abs() < 1e-3);
    // Student's t of 31 degrees: 2.0395 leaves 2½ % on each side, as 1.96 does.
    assert!((score(2.039_513, 31.0) - 1.959_964).abs() < 1e-5);
    assert!((score(-4.0 * 1.155_4, 31.0) + 4.0).abs() < 1e-3);
    // χ² of 100 degrees: 149.449 is exceeded once in a thousand.
    assert!((quantile(0.999, 100) - 1.494_49).abs() < 1e-4);
    assert!(score(1e3, 31.0) > 17.0);
    let mean = [0.9, 1.1, 1.0, 1.2, 0.8];
    assert!(score_of(&mean, 1.0).abs() < 1e-12);
    // (1 − 0.9)/√(0.1/20) = √2 with 4 degrees: one-sided 0.1151.
    let z = score_of(&mean, 0.9);
    let p = Normal::standard().sf(z);
    assert!((p - 0.115_1).abs() < 1e-4, "{p}");
}
