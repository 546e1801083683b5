use super::*;
use glam::Vec3;
use interreflect_scene::{Point, PointLayout};

/// Every model is led to by what it leaves out, in words that fit, and the way ends at it.
#[test]
fn the_way_to_each_model_ends_there() {
    let names = |model| left_out(model).into_iter().map(|(name, _)| name);
    let captured = ["further bounces", "receivers as occluders and reflectors"];
    for (model, further) in [
        (
            OwnModel::VisibleFromReference { bounces: 2 },
            &["occlusion by the surroundings"][..],
        ),
        (
            OwnModel::EnvironmentAtInfinity { bounces: 2 },
            &["parallax"][..],
        ),
        (
            OwnModel::MeanRadiance { bounces: 2 },
            &["parallax", "direction"][..],
        ),
    ] {
        let expected = captured.iter().chain(further).copied();
        assert!(names(model).eq(expected), "{model:?}");
        let steps = left_out(model);
        assert_eq!(steps.last().map(|s| s.1), Some(model));
        // Emission reflected by nothing, and by two more surfaces beyond the lights' light: three.
        let OwnModel::LightTransport(first) = steps[0].1 else {
            panic!("traced first: {:?}", steps[0]);
        };
        assert_eq!((first.bounces, first.self_shadowing), (3, true));
        let OwnModel::LightTransport(second) = steps[1].1 else {
            panic!("traced next: {:?}", steps[1]);
        };
        assert_eq!((second.bounces, second.self_shadowing), (3, false));
    }
    let lights = |directional| OwnModel::FirstHitsOfLights { directional };
    let common = ["further bounces", "emission and environment", "occlusion"];
    assert!(names(lights(true)).eq(common));
    assert!(names(lights(false)).eq(common.into_iter().chain(["gloss of lit surfaces"])));
    let steps = left_out(lights(false));
    let OwnModel::LightTransport(once) = steps[1].1 else {
        panic!("traced: {:?}", steps[1]);
    };
    assert_eq!((once.bounces, once.least_bounces), (1, 1));
    assert_eq!(steps[2].1, lights(true));
    assert_eq!(steps.last().map(|s| s.1), Some(lights(false)));
    assert!(left_out(TRUTH).is_empty());
    assert_eq!(left_out(OwnModel::OccludedEnvironment).len(), 1);
}

fn grey(values: [f32; 3]) -> Estimate {
    let mut estimate = Estimate::new(3);
    for (i, value) in values.into_iter().enumerate() {
        estimate.set(i, Vec3::splat(value));
    }
    estimate
}

/// Two points with a surface, of a truth of 1 and 3: mean 2, ε = (.02)². A step of +½ and −1, then back.
#[test]
fn steps_are_signed_weighted_by_the_truth_and_add_up() {
    let surface = Some(Point {
        normal: Vec3::Y,
        ..Point::default()
    });
    let points = Points::new(PointLayout::Surface, [surface, None, surface]);
    let truth = ModelValues {
        values: grey([1.0, 100.0, 3.0]),
        error: grey([0.1, 9.0, 0.3]),
        description: String::new(),
    };
    let mut sum = Sum::new(points, &truth);
    let between = grey([0.05, 0.0, 0.0]);
    sum.step("down", None, &grey([1.5, 0.0, 2.0]), Some(&between));
    sum.step("up", Some(Backend::Cpu), &grey([1.5, 0.0, 4.0]), None);
    let [down, up] = &sum.parts[..] else {
        panic!("two steps");
    };
    let epsilon = 0.02_f64.powi(2);
    let close = |found: f64, expected: f64| {
        // Numbers such as .1 in float32.
        assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
    };
    close(down.mean.unwrap_or(f64::NAN), -0.125);
    close(up.mean.unwrap_or(f64::NAN), 0.5);
    let (one, nine) = (1.0 + epsilon, 9.0 + epsilon);
    close(down.relmse, 0.5 * (0.25 / one + 1.0 / nine));
    close(up.relmse, 0.5 * 4.0 / nine);
    // Both ends' errors of the first step, one end's of the second.
    close(
        down.noise_floor,
        0.5 * ((0.01 + 0.0025) / one + 0.09 / nine),
    );
    close(up.noise_floor, 0.5 * 0.0025 / one);
    assert!(down.above_noise && up.above_noise);
    assert_eq!((&*up.name, up.backend), ("up", Some(Backend::Cpu)));
    sum.step("noise", None, &grey([1.5, 0.0, 4.0]), Some(&grey([0.5; 3])));
    assert!(!sum.parts[2].above_noise, "nothing but noise");
}
