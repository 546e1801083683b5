//! Captured radiance that holds further reflections leads to the truth, reflection by reflection.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{CPU, Outcome, Variant, bounced, cpu_scene, run};
use interreflect_conformance::own_model::evaluate;
use interreflect_cpu::path_tracer::Stop;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::{Estimate, LightPaths, PointLayout};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = vec![Trial::test("bounces/cornell-box/model", || {
        model_converges_to_truth(&TEST_SCENES[1])
    })];
    for variant in bounced(64) {
        let name = format!("bounces/cornell-box/{}", variant.name());
        trials.push(Trial::test(name, move || {
            every_bounce_adds_less(&TEST_SCENES[1], variant)
        }));
    }
    trials
}

const SAMPLES: Stop = Stop {
    samples: Some(1024),
    relative_error: None,
    seconds: None,
};

/// What is seen from the reference point, at its place, against full light transport.
fn model_converges_to_truth(test_scene: &TestScene) -> Outcome {
    let points = test_scene.points(PointLayout::Surface);
    let value = |model| {
        let (scene, quantity) = (&test_scene.cpu, Quantity::Irradiance);
        evaluate(&CPU, model, quantity, scene, &points, &SAMPLES, 5).values
    };
    let truth = value(OwnModel::LightTransport(LightPaths::default()));
    let mut last = f64::INFINITY;
    let mut errors = Vec::new();
    for bounces in [0, 1, 2, 4] {
        let model = value(OwnModel::VisibleFromReference { bounces });
        let difference = |(a, b): (glam::Vec3, glam::Vec3)| (a - b).as_dvec3().length_squared();
        let squared: f64 = model.iter().zip(truth.iter()).map(difference).sum();
        let of_truth: f64 = truth.iter().map(|v| v.as_dvec3().length_squared()).sum();
        let error = (squared / of_truth).sqrt();
        errors.push(error);
        ensure!(error < last, "errors with 0, 1, 2, 4 bounces: {errors:?}");
        last = error;
    }
    println!("relative errors with 0, 1, 2, 4 bounces: {errors:?}");
    // What is left is visibility: the blocks hide parts of the room from points that the reference
    // point sees, and the reference point does not see behind them.
    ensure!(last < 0.5 * errors[0], "errors: {errors:?}");
    Ok(())
}

/// The estimates' sum grows, by less with every bounce: surfaces absorb.
fn every_bounce_adds_less(test_scene: &TestScene, mut variant: Variant) -> Outcome {
    let points = test_scene.points(variant.quantity.layout());
    let mut sums: Vec<f64> = Vec::new();
    for bounces in 0..6 {
        variant.method.set("bounces", &bounces.to_string())?;
        let estimate: Estimate = run(&cpu_scene(test_scene), &variant, &points)?;
        sums.push(estimate.iter().map(|v| f64::from(v.element_sum())).sum());
    }
    let added: Vec<f64> = sums.windows(2).map(|s| s[1] - s[0]).collect();
    for (k, pair) in added.windows(2).enumerate() {
        ensure!(
            pair[1] > 0.0 && pair[1] < pair[0],
            "bounce {} adds {}, the one before {}: {sums:?}",
            k + 2,
            pair[1],
            pair[0]
        );
    }
    Ok(())
}
