//! Runs of the path tracer: seeds, threads, stopping, input that is not a number.
#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use glam::Vec3;
use interreflect_cpu::path_tracer::{PathQuantity, REPLICATES, Stop, mean_of_samples, trace};
use interreflect_scene::{Light, LightPaths, Material, Point, Role};
use std::sync::Mutex;
use support::estimates::{irradiance, samples};
use support::{cpu, glowing, lit, object, point, points, sphere, under, walls};

/// A room with everything in it: emitters, lights, a mirror, gloss, a receiver, an opening.
fn busy_scene() -> interreflect_scene::Scene {
    let mut scene = walls([0.0, 0.3, 0.0, 0.0, 2.0, 0.0].map(|l| glowing(0.5, l)));
    scene.materials[2] = Material {
        specular: Vec3::splat(0.8),
        mirror: true,
        ..scene.materials[2]
    };
    scene.materials[3].specular = Vec3::splat(0.4);
    scene.objects[0].mesh.triangles.truncate(11);
    scene.objects[0].mesh.materials.truncate(11);
    scene
        .objects
        .push(object(Role::Receiver, sphere(0.4, 6, false, true)));
    let scene = under(scene, 0.7);
    lit(
        scene,
        Light::Point {
            position: Vec3::new(0.2, 0.7, 0.1),
            intensity: Vec3::ONE,
            picture: None,
        },
    )
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let scene = busy_scene();
    let list = points(support::directions(30).map(|d| point(d * 0.41, d)));
    for indirect_visibility in [true, false] {
        let paths = LightPaths {
            indirect_visibility,
            ..LightPaths::ALL
        };
        let stop = Stop {
            samples: Some(500),
            relative_error: Some(1e-9),
            seconds: None,
        };
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| {
                trace(
                    &cpu(&scene),
                    &list,
                    PathQuantity::Irradiance,
                    &paths,
                    &stop,
                    9,
                    &|_| (),
                )
            })
        };
        let one = run(1);
        for threads in [2, 3] {
            assert!(one == run(threads), "{threads} threads give other bits");
        }
        assert_eq!(one.samples, 512);
        // Rounds do not change what is sampled.
        let at_once = trace(
            &cpu(&scene),
            &list,
            PathQuantity::Irradiance,
            &paths,
            &samples(500),
            9,
            &|_| (),
        );
        for (a, b) in one.mean.iter().zip(at_once.mean.iter()) {
            assert!((a - b).abs().max_element() <= 1e-6 * a.max_element());
        }
    }
}

#[test]
fn a_requested_error_is_reached_and_progress_ends_at_one() {
    let scene = cpu(&busy_scene());
    let list = points(support::directions(10).map(|d| point(d * 0.41, d)));
    let seen = Mutex::new(Vec::new());
    let run = |stop: &Stop| {
        let progress = |f| seen.lock().unwrap().push(f);
        trace(
            &scene,
            &list,
            PathQuantity::Irradiance,
            &LightPaths::ALL,
            stop,
            1,
            &progress,
        )
    };
    let stop = Stop {
        relative_error: Some(0.02),
        ..Stop::default()
    };
    let traced = run(&stop);
    let norm = |e: &interreflect_scene::Estimate| e.iter().map(|v| v.length_squared()).sum::<f32>();
    assert!(norm(&traced.standard_error) <= 0.02_f32.powi(2) * norm(&traced.mean) * 1.001);
    assert!(traced.samples % REPLICATES == 0 && traced.samples < 1 << 20);
    assert!(seen.lock().unwrap().iter().all(|f| (0.0..=1.0).contains(f)));
    seen.lock().unwrap().clear();
    run(&samples(320));
    let last = seen.lock().unwrap().iter().copied().fold(0.0, f32::max);
    assert_eq!(last, 1.0);
}

#[test]
fn points_that_are_not_numbers_stay_alone() {
    let scene = cpu(&walls([glowing(0.0, 1.0); 6]));
    let nan = Point {
        position: Vec3::NAN,
        normal: Vec3::X,
        ..Point::default()
    };
    let list = points([
        point(Vec3::ZERO, Vec3::X),
        Some(nan),
        None,
        Some(Point::default()),
    ]);
    for quantity in [PathQuantity::Irradiance, PathQuantity::AmbientOcclusion] {
        let stop = Stop {
            samples: Some(64),
            relative_error: Some(0.5),
            seconds: Some(5.0),
        };
        let traced = trace(&scene, &list, quantity, &LightPaths::ALL, &stop, 1, &|_| ());
        assert!(traced.mean.get(0).is_finite());
        assert!(traced.mean.get(1).is_nan() && traced.standard_error.get(1).is_nan());
        assert_eq!(traced.mean.get(2), Vec3::ZERO);
        assert!(traced.mean.get(3).is_nan(), "a normal without length");
    }
    let nothing = irradiance(&scene, &points([]), LightPaths::ALL, 10);
    assert!(nothing.mean.is_empty());
}

/// Few samples are off, but not to one side: the mean of many such estimates is within four of its own
/// standard errors of the traced one, whose error is added.
#[test]
fn few_samples_have_the_same_mean_whatever_their_number() {
    const RUNS: u64 = 400;
    let scene = cpu(&busy_scene());
    let list = points(support::directions(4).map(|d| point(d * 0.41, d)));
    let (quantity, paths) = (PathQuantity::Irradiance, LightPaths::ALL);
    let truth = trace(
        &scene,
        &list,
        quantity,
        &paths,
        &samples(1 << 14),
        99,
        &|_| {},
    );
    for count in [1, 7] {
        let estimates: Vec<_> = (0..RUNS)
            .map(|seed| mean_of_samples(&scene, &list, quantity, &paths, count, seed))
            .collect();
        for i in 0..list.len() {
            let red = || estimates.iter().map(|e| f64::from(e.get(i).x));
            let mean = red().sum::<f64>() / RUNS as f64;
            let squares = red().map(|v| (v - mean).powi(2)).sum::<f64>();
            let error = (squares / (RUNS * (RUNS - 1)) as f64).sqrt();
            let of_truth = f64::from(truth.standard_error.get(i).x);
            let off = mean - f64::from(truth.mean.get(i).x);
            assert!(
                off.abs() < 4.0 * error.hypot(of_truth),
                "{count}: {off} of {error}"
            );
        }
    }
}
