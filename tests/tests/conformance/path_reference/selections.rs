//! Light paths in selections that add up.

use super::images::QUANTITIES;
use super::scenes::{cpu, glowing};
use super::{Ask, IRRADIANCE, hold};
use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::Outcome;
use glam::{DVec3, Vec3};
use interreflect_conformance::statistics::Scores;
use interreflect_cpu::path_tracer::Traced;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{LightPaths, Material, Point, PointLayout, Points, Role, Scene};
use libtest_mimic::Trial;
use std::sync::LazyLock;

static CAVE: LazyLock<TestScene> = LazyLock::new(|| TestScene::library("cave", &[]));

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    let [colored_room, cornell_box, ..] = &TEST_SCENES;
    for test_scene in [colored_room, cornell_box, &CAVE] {
        for (name, quantity) in QUANTITIES {
            let ask = Ask {
                quantity,
                samples: 256,
                ..IRRADIANCE
            };
            let name = format!(
                "path_reference/reflections_add_up/{}/{name}",
                test_scene.name
            );
            trials.push(Trial::test(name, move || reflections(test_scene, ask)));
        }
    }
    for (name, test) in [
        ("absent_receivers", absent_receivers as fn() -> Outcome),
        ("layers_add_up", layers),
        ("at_infinity", at_infinity),
    ] {
        let name = format!("path_reference/{name}");
        trials.push(Trial::test(name, test));
    }
    trials
}

/// From `least` to `most` reflections, 0 = without end.
fn reflections_of(least_bounces: u32, bounces: u32) -> LightPaths {
    LightPaths {
        least_bounces,
        bounces,
        ..LightPaths::ALL
    }
}

/// The scene with surfaces that only emit: what arrives without any reflection.
fn unreflected(test_scene: &TestScene) -> CpuScene {
    let mut scene = test_scene.cpu.scene().clone();
    for material in &mut scene.materials {
        *material = Material::emitter(material.emission);
    }
    cpu(&scene)
}

/// Each sample is a sum in f32, a dozen roundings of 6e-8 in each of them; relative to the largest.
const ROUNDING: f32 = 1e-6;

/// Two estimates part by rounding only.
fn near(a: Vec3, b: Vec3, scale: f32, point: usize) -> Outcome {
    let error = (a - b).abs().max_element();
    ensure!(error <= ROUNDING * scale, "point {point}: {a} and {b}");
    Ok(())
}

/// None, one, two, and three or more: with seeds of their own by their errors, and with the same seed,
/// which gives the same paths, but for rounding.
fn reflections(test_scene: &TestScene, ask: Ask) -> Outcome {
    let points = test_scene.points(PointLayout::Material);
    let black = unreflected(test_scene);
    let parts = |seed: &dyn Fn(u64) -> u64| -> Vec<Traced> {
        let of = |part: u64, scene: &CpuScene, least, most| {
            let ask = ask.seeded(seed(part)).of(reflections_of(least, most));
            ask.trace(scene, &points)
        };
        let scene = &*test_scene.cpu;
        vec![
            of(0, &black, 0, 0),
            of(1, scene, 1, 1),
            of(2, scene, 2, 2),
            of(3, scene, 3, 0),
        ]
    };
    let whole = ask.trace(&test_scene.cpu, &points);
    let apart = parts(&|part| 10 + part);
    let mut terms = vec![(1.0, &whole)];
    terms.extend(apart.iter().map(|part| (-1.0, part)));
    hold(Scores::new(&terms, |_| DVec3::ZERO, 0.0), 0.12)?;

    let same = parts(&|_| ask.seed);
    let scale = whole.mean.iter().map(Vec3::max_element).fold(0.0, f32::max);
    for i in 0..points.len() {
        let sum = same.iter().map(|part| part.mean.get(i)).sum();
        near(whole.mean.get(i), sum, scale, i)?;
    }
    let reflected = same[1..].iter().map(|part| &part.mean);
    for (i, mean) in reflected.enumerate() {
        let lit = mean.iter().any(|value| value.max_element() > 1e-3 * scale);
        ensure!(lit, "{} or more reflections give nothing", i + 1);
    }
    Ok(())
}

/// Without self-shadowing it is as if the receivers were not there.
fn absent_receivers() -> Outcome {
    let test_scene = &*TEST_SCENES[0];
    let points = test_scene.points(PointLayout::Material);
    let mut scene = test_scene.cpu.scene().clone();
    scene.objects.retain(|o| o.role == Role::Environment);
    let bare = cpu(&scene);
    let absent = LightPaths {
        self_shadowing: false,
        ..LightPaths::ALL
    };
    let whole = IRRADIANCE.trace(&test_scene.cpu, &points);
    let traced = IRRADIANCE.of(absent).trace(&test_scene.cpu, &points);
    let same = IRRADIANCE.trace(&bare, &points);
    for (i, (a, b)) in traced.mean.iter().zip(same.mean.iter()).enumerate() {
        near(a, b, a.max_element(), i)?;
    }
    let other = IRRADIANCE.seeded(2).trace(&bare, &points);
    hold(Scores::between(&traced, &other), 0.05)?;
    let shadowed = Scores::between(&whole, &other)?.check();
    ensure!(shadowed.is_err(), "the receivers hide nothing");
    Ok(())
}

/// The coloured room with surfaces that only emit, each its own radiance.
fn glowing_room() -> Scene {
    let mut scene = TEST_SCENES[0].cpu.scene().clone();
    scene.lights.clear();
    scene.environment = None;
    for (i, material) in scene.materials.iter_mut().enumerate() {
        *material = glowing(0.0, 0.3 + 0.1 * i as f32);
    }
    scene
}

/// With nothing hidden, what walls and receivers emit adds up.
fn layers() -> Outcome {
    // Points before the receiver that look at it.
    let before = |p: Point| Point {
        position: p.position + 0.1 * p.normal,
        normal: -p.normal,
        ..p
    };
    let points = TEST_SCENES[0].points(PointLayout::Material);
    let before = points.iter().map(|point| point.map(before));
    let points = Points::new(PointLayout::Material, before);
    let through = IRRADIANCE.of(LightPaths {
        indirect_visibility: false,
        ..LightPaths::ALL
    });
    let alone = |role: Role, seed: u64| {
        let mut scene = glowing_room();
        scene.objects.retain(|o| o.role == role);
        through.seeded(seed).trace(&cpu(&scene), &points)
    };
    let (walls, receivers) = (alone(Role::Environment, 2), alone(Role::Receiver, 3));
    let whole = cpu(&glowing_room());
    let together = through.trace(&whole, &points);
    let terms = [(1.0, &together), (-1.0, &walls), (-1.0, &receivers)];
    hold(Scores::new(&terms, |_| DVec3::ZERO, 0.0), 0.05)?;
    let hidden = IRRADIANCE.seeded(4).trace(&whole, &points);
    let found = Scores::between(&together, &hidden)?.check();
    ensure!(found.is_err(), "nothing is hidden");
    Ok(())
}

/// Surroundings at infinity look from everywhere as the walls do from the reference point, which lies
/// inside a receiver.
fn at_infinity() -> Outcome {
    let points = TEST_SCENES[0].points(PointLayout::Material);
    let scene = cpu(&glowing_room());
    let position = scene.scene().reference_point;
    let moved = (points.iter()).map(|point| point.map(|p| Point { position, ..p }));
    let moved = Points::new(PointLayout::Material, moved);
    let far = IRRADIANCE.of(LightPaths {
        environment_at_infinity: true,
        ..LightPaths::ALL
    });
    let bare = IRRADIANCE.seeded(2).of(LightPaths {
        self_shadowing: false,
        ..LightPaths::ALL
    });
    let at_infinity = far.trace(&scene, &points);
    hold(
        Scores::between(&at_infinity, &bare.trace(&scene, &moved)),
        0.05,
    )?;
    let found = Scores::between(&at_infinity, &bare.trace(&scene, &points))?.check();
    ensure!(found.is_err(), "the walls look the same from everywhere");
    Ok(())
}
