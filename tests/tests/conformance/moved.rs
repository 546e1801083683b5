//! Captures that are kept while receivers move, or shared by several of them.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene, same_bits};
use crate::variants::{
    Outcome, Variant, captures, cpu_scene, estimate, gpu_scene, ignored, on_gpu, run, variants,
};
use glam::Vec3;
use interreflect::clock::Sampling;
use interreflect::measure::measure;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::execution::{BackendScene, Executor};
use interreflect_estimators::{Changed, Quantity};
use interreflect_scene::{Points, Role, Scene};
use libtest_mimic::{Failed, Trial};
use std::sync::Arc;

/// Distance that the receivers have moved.
const MOVED_M: f32 = 0.2;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        let name = format!("moved/{}", variant.name());
        let one = variant.copy();
        if let Some(why) = one.unsupported(&TEST_SCENES[0]) {
            trials.push(ignored(name, &why));
            continue;
        }
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            let test_scene = &TEST_SCENES[0];
            points_move(&cpu_scene(test_scene), test_scene, &one)?;
            captures_change(&one, |s| Ok(cpu_scene(s)))?;
            kept_or_not(&one, |s| Ok(cpu_scene(s)))?;
            shared(&one, |s| Ok(cpu_scene(s)))
        }));
        if variant.unsupported_on_gpu(&TEST_SCENES[0]).is_none() {
            trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                let test_scene = &TEST_SCENES[0];
                points_move(&gpu_scene(context, test_scene)?, test_scene, &variant)?;
                captures_change(&variant, |s| gpu_scene(context, s))?;
                kept_or_not(&variant, |s| gpu_scene(context, s))?;
                shared(&variant, |s| gpu_scene(context, s))
            }));
        }
    }
    trials
}

/// The test scene with another scene, at the same points.
fn changed(test_scene: &TestScene, change: impl FnOnce(&mut Scene)) -> Result<TestScene, Failed> {
    let mut scene = test_scene.cpu.scene().clone();
    change(&mut scene);
    Ok(test_scene.with_scene(Arc::new(CpuScene::new(&scene)?)))
}

/// A session prepared once, whose points then move, gives what a fresh one gives.
fn points_move<S: BackendScene>(loaded: &S, test_scene: &TestScene, variant: &Variant) -> Outcome {
    let before = test_scene.points(variant.quantity.layout());
    let after = before.iter().skip(3).map(|point| {
        point.map(|mut p| {
            p.position += Vec3::new(0.1, 0.05, -0.1);
            p.material.shininess += 3.0;
            p
        })
    });
    let after = Points::new(before.layout(), after);
    let captures = captures(loaded, variant)?;
    let fresh = estimate(loaded, variant, &captures, &after)?;
    let mut executor = variant.executor(loaded, &before)?;
    executor.set_captures(captures);
    executor.estimate()?;
    executor.place(&after)?;
    executor.prepare(Changed::POINTS)?;
    executor.shade()?;
    let moved = executor.read_back()?.0;
    Ok(same_bits(&fresh, moved.iter()).map_err(|e| format!("moved points: {e}"))?)
}

/// A session prepared once, whose scene then changes around the same points, gives what a fresh one
/// gives.
fn captures_change<S: BackendScene>(
    variant: &Variant,
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    // In the closed room nothing is open, whatever stands in it.
    let after: &TestScene = match variant.quantity {
        Quantity::AmbientOcclusion => &TEST_SCENES[2],
        _ => &TEST_SCENES[0],
    };
    let before = changed(after, |scene| {
        scene.objects.retain(|o| o.role == Role::Environment);
        for material in &mut scene.materials {
            material.albedo *= 0.5;
            material.emission *= 0.5;
        }
    })?;
    let points = after.points(variant.quantity.layout());
    let (scene_before, scene_after) = (loaded(&before)?, loaded(after)?);
    let mut executor = variant.executor(&scene_before, &points)?;
    let first = executor.estimate()?;
    let session = executor.suspend().without_captures();
    let (method, quantity) = (&*variant.method, variant.quantity);
    let mut executor = Executor::resume(&scene_after, method, quantity, &points, session)?;
    executor.prepare(Changed::SCENE)?;
    executor.shade()?;
    let then = executor.read_back()?.0;
    ensure!(first != then, "the change does not show");
    let fresh = run(&loaded(after)?, variant, &points)?;
    Ok(same_bits(&fresh, then.iter()).map_err(|e| format!("captures changed: {e}"))?)
}

/// Within the distance the captures of before are used, and none are paid for; beyond it fresh ones
/// are. Methods that keep nothing always have fresh ones.
fn kept_or_not<S: BackendScene>(
    variant: &Variant,
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    let test_scene = &TEST_SCENES[0];
    let here = test_scene.cpu.scene().reference_point;
    let home = here - Vec3::X * MOVED_M;
    let moved = changed(test_scene, |scene| scene.captured_at = Some(home))?;
    let at_home = changed(test_scene, |scene| {
        scene.reference_point = home;
        scene.captured_at = None;
    })?;
    let points = test_scene.points(variant.quantity.layout());
    let (mut near, mut far) = (variant.copy(), variant.copy());
    let keeps = (near.method.set("recapture_distance", "0.21")).is_ok();
    far.method.set("recapture_distance", "0.19").ok();
    for (variant, kept) in [(&near, keeps), (&far, false)] {
        let needs = variant
            .method
            .needs(variant.quantity, &moved.cpu.scene().facts())?;
        let (method, quantity) = (&*variant.method, variant.quantity);
        let measured = measure(&loaded(&moved)?, method, quantity, &points, &Sampling::ONCE)?;
        let timed = measured.phases.capture.is_some();
        ensure!(
            timed != (kept || needs.no_captures()),
            "kept: {kept}, and a capture is timed: {timed}"
        );
        let like = if kept { &at_home } else { test_scene };
        let expected = run(&loaded(like)?, variant, &points)?;
        same_bits(&expected, measured.estimate.iter()).map_err(|e| format!("kept {kept}: {e}"))?;
    }
    Ok(())
}

/// Three receivers share the captures: each point has what it has with one receiver.
fn shared<S: BackendScene>(
    variant: &Variant,
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    let three = TestScene::library(
        "colored-room",
        &[("receivers", "3"), ("receiver.size", "0.4")],
    );
    let one = three.with_scene(TEST_SCENES[0].cpu.clone());
    let points = three.points(variant.quantity.layout());
    let xs = || points.iter().flatten().map(|p| p.position.x);
    ensure!(
        xs().any(|x| x < -0.4) && xs().any(|x| x.abs() < 0.2) && xs().any(|x| x > 0.4),
        "the points are not on all receivers"
    );
    let needs = variant
        .method
        .needs(variant.quantity, &three.cpu.scene().facts())?;
    let together = run(&loaded(&three)?, variant, &points)?;
    ensure!(together.iter().all(Vec3::is_finite), "not finite");
    // Light transport and the lights' pictures see the other receivers.
    if needs.light_transport || !needs.rsms.is_empty() {
        return Ok(());
    }
    let alone = run(&loaded(&one)?, variant, &points)?;
    Ok(same_bits(&alone, together.iter())?)
}
