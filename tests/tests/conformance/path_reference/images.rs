//! Renderings of the library's scenes against each other, by their own errors.

use super::scenes::cpu;
use super::{Ask, IRRADIANCE, hold};
use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::statistics::{Disagreement, Scores};
use interreflect_cpu::path_tracer::{PathQuantity, Traced};
use interreflect_scene::{LightPaths, PointLayout, Scene};
use libtest_mimic::Trial;

/// The quantities that carry light, with their names.
pub(super) const QUANTITIES: [(&str, PathQuantity); 2] = [
    ("irradiance", PathQuantity::Irradiance),
    ("glossy_radiance", PathQuantity::GlossyRadiance),
];

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for test_scene in &TEST_SCENES[..3] {
        for (name, quantity) in QUANTITIES {
            let ask = Ask {
                quantity,
                ..IRRADIANCE
            };
            let name = format!("path_reference/two_seeds/{}/{name}", test_scene.name);
            trials.push(Trial::test(name, move || two_seeds(test_scene, ask)));
        }
        let name = format!("path_reference/sources_add_up/{}", test_scene.name);
        trials.push(Trial::test(name, move || sources_add_up(test_scene)));
    }
    for (name, test) in [
        ("through_surfaces", through_surfaces as fn() -> Outcome),
        ("wrong_images_are_rejected", wrong_images),
    ] {
        trials.push(Trial::test(format!("path_reference/{name}"), test));
    }
    trials
}

/// Different seeds and different numbers of samples.
fn two_seeds(test_scene: &TestScene, ask: Ask) -> Outcome {
    let points = test_scene.points(PointLayout::Material);
    let first = ask.trace(&test_scene.cpu, &points);
    let fewer = Ask {
        samples: ask.samples / 4,
        ..ask.seeded(3)
    };
    for other in [ask.seeded(2), fewer] {
        let other = other.trace(&test_scene.cpu, &points);
        hold(Scores::between(&first, &other), 0.1)?;
    }
    Ok(())
}

/// Two seeds where all surfaces along the first leg reflect.
fn through_surfaces() -> Outcome {
    let through = IRRADIANCE.of(LightPaths {
        indirect_visibility: false,
        ..LightPaths::ALL
    });
    let test_scene = &*TEST_SCENES[0];
    let points = test_scene.points(PointLayout::Material);
    let [a, b] = [1, 2].map(|seed| through.seeded(seed).trace(&test_scene.cpu, &points));
    hold(Scores::between(&a, &b), 0.08)
}

/// Light of each kind of source alone, traced in scenes of their own with sources drawn otherwise,
/// adds up to the whole.
fn sources_add_up(test_scene: &TestScene) -> Outcome {
    let points = test_scene.points(PointLayout::Material);
    let whole = IRRADIANCE.trace(&test_scene.cpu, &points);
    let cuts: [fn(&mut Scene); 3] = [
        |scene| scene.lights.clear(),
        |scene| scene.environment = None,
        |scene| {
            scene
                .materials
                .iter_mut()
                .for_each(|m| m.emission = Vec3::ZERO)
        },
    ];
    let parts = (0..cuts.len()).map(|kept| {
        let mut scene = test_scene.cpu.scene().clone();
        let cut = (0..cuts.len()).filter(|&other| other != kept);
        cut.for_each(|other| cuts[other](&mut scene));
        IRRADIANCE
            .seeded(10 + kept as u64)
            .trace(&cpu(&scene), &points)
    });
    let parts: Vec<Traced> = parts.collect();
    let mut terms = vec![(1.0, &whole)];
    terms.extend(parts.iter().map(|part| (-1.0, part)));
    hold(Scores::new(&terms, |_| DVec3::ZERO, 0.0), 0.08)
}

/// What the trials above can see: an image that is right passes, one that is off by a few errors
/// everywhere does not, nor one that is off by 1 % where errors are small.
fn wrong_images() -> Outcome {
    let test_scene = &*TEST_SCENES[0];
    let points = test_scene.points(PointLayout::Material);
    let ask = Ask {
        samples: 2048,
        ..IRRADIANCE
    };
    let [a, b] = [1, 2].map(|seed| ask.seeded(seed).trace(&test_scene.cpu, &points));
    hold(Scores::between(&a, &b), 0.03)?;
    type Wrong = (&'static str, fn(Vec3, Vec3) -> Vec3);
    let wrong: [Wrong; 4] = [
        ("three errors more", |mean, error| mean + 3.0 * error),
        ("two errors less", |mean, error| mean - 2.0 * error),
        ("1 % more", |mean, _| mean * 1.01),
        ("1 % less", |mean, _| mean * 0.99),
    ];
    for (name, change) in wrong {
        let mut b = b.clone();
        for i in 0..points.len() {
            let (mean, error) = (b.mean.get(i), b.standard_error.get(i));
            b.mean.set(i, change(mean, error));
        }
        let found = Scores::between(&a, &b)?.check();
        let rejected = matches!(
            found,
            Err(Disagreement::Outlier { .. } | Disagreement::Off { .. })
        );
        ensure!(rejected, "{name}: {found:?}");
    }
    Ok(())
}
