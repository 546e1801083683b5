//! Captures that are kept while receivers move, or shared by several of them.

use crate::ensure;
use crate::subjects::{SUBJECTS, Subject, same_bits};
use crate::world::{
    Outcome, Variant, captures, cpu_stage, estimate, gpu_stage, ignored, on_gpu, run, variants,
};
use glam::Vec3;
use interreflect::clock::Sampling;
use interreflect::measure::measure;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::stage::{Placed, Stage};
use interreflect_estimators::{Backend, Changed, Inputs, Quantity, Session};
use interreflect_scene::{Estimate, Points, Role, Scene};
use libtest_mimic::{Failed, Trial};
use std::sync::Arc;

/// Distance that the receivers have moved.
const MOVED_M: f32 = 0.2;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        let name = format!("moved/{}", variant.name());
        let one = variant.copy();
        if let Some(why) = one.unsupported(&SUBJECTS[0]) {
            trials.push(ignored(name, &why));
            continue;
        }
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            let subject = &SUBJECTS[0];
            points_move(&cpu_stage(subject), subject, &one)?;
            captures_change(&one, |s| Ok(cpu_stage(s)))?;
            kept_or_not(&one, |s| Ok(cpu_stage(s)))?;
            shared(&one, |s| Ok(cpu_stage(s)))
        }));
        if variant.unsupported_on_gpu(&SUBJECTS[0]).is_none() {
            trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                let subject = &SUBJECTS[0];
                points_move(&gpu_stage(context, subject)?, subject, &variant)?;
                captures_change(&variant, |s| gpu_stage(context, s))?;
                kept_or_not(&variant, |s| gpu_stage(context, s))?;
                shared(&variant, |s| gpu_stage(context, s))
            }));
        }
    }
    trials
}

/// The subject with another scene, at the same points.
fn changed(subject: &Subject, change: impl FnOnce(&mut Scene)) -> Result<Subject, Failed> {
    let mut scene = subject.cpu.scene().clone();
    change(&mut scene);
    Ok(subject.with_scene(Arc::new(CpuScene::new(&scene)?)))
}

/// A session prepared once, whose points then move, gives what a fresh one gives.
fn points_move<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let (scene, quantity) = (subject.cpu.scene(), variant.quantity);
    let before = subject.points(quantity.layout());
    let after = before.iter().skip(3).map(|point| {
        point.map(|mut p| {
            p.position += Vec3::new(0.1, 0.05, -0.1);
            p.material.shininess += 3.0;
            p
        })
    });
    let after = Points::new(before.layout(), after);
    let captures = captures(stage, subject, variant)?;
    let fresh = estimate(stage, subject, variant, &captures, &after)?;
    let needs = variant.method.needs(quantity, &scene.facts())?;
    let mut session = stage.open(&*variant.method)?;
    let origin = (scene.facts(), scene.capture_origin(needs.keep_within_m));
    let mut last = None;
    for (points, changed) in [(&before, Changed::ALL), (&after, Changed::POINTS)] {
        let mut placed = stage.place(points)?;
        let inputs = Inputs::new(&needs, &captures, &placed.points, points, origin, changed);
        last = Some(frame(
            stage,
            &mut *session,
            quantity,
            &inputs,
            &mut placed.out,
        )?);
    }
    let moved = last.ok_or("nothing was shaded")?;
    Ok(same_bits(&fresh, moved.iter()).map_err(|e| format!("moved points: {e}"))?)
}

/// A session's next frame.
fn frame<S: Stage>(
    stage: &S,
    session: &mut dyn Session<S::Backend>,
    quantity: Quantity,
    inputs: &Inputs<'_, S::Backend>,
    out: &mut <S::Backend as Backend>::Out,
) -> Result<Estimate, Failed> {
    stage.timed("prepare", &mut |cx| {
        session.prepare(cx, quantity, inputs, out)
    })?;
    stage.timed("shade", &mut |cx| session.shade(cx, quantity, inputs, out))?;
    Ok(stage.read_back(out)?.0)
}

/// A session prepared once, whose scene then changes around the same points, gives what a fresh one
/// gives.
fn captures_change<S: Stage>(
    variant: &Variant,
    stage: impl Fn(&Subject) -> Result<S, Failed>,
) -> Outcome {
    // In the closed room nothing is open, whatever stands in it.
    let after: &Subject = match variant.quantity {
        Quantity::AmbientOcclusion => &SUBJECTS[2],
        _ => &SUBJECTS[0],
    };
    let before = changed(after, |scene| {
        scene.objects.retain(|o| o.role == Role::Environment);
        for material in &mut scene.materials {
            material.albedo *= 0.5;
            material.emission *= 0.5;
        }
    })?;
    let points = after.points(variant.quantity.layout());
    let mut session = stage(after)?.open(&*variant.method)?;
    let Placed {
        points: placed,
        mut out,
    } = stage(after)?.place(&points)?;
    let mut shade = |subject: &Subject, changed| {
        let (stage, scene) = (stage(subject)?, subject.cpu.scene());
        let facts = scene.facts();
        let needs = variant.method.needs(variant.quantity, &facts)?;
        let captures = captures(&stage, subject, variant)?;
        let origin = (facts, scene.capture_origin(needs.keep_within_m));
        let inputs = Inputs::new(&needs, &captures, &placed, &points, origin, changed);
        frame(&stage, &mut *session, variant.quantity, &inputs, &mut out)
    };
    let first = shade(&before, Changed::ALL)?;
    let then = shade(after, Changed::SCENE)?;
    ensure!(first != then, "the change does not show");
    let fresh = run(&stage(after)?, after, variant, &points)?;
    Ok(same_bits(&fresh, then.iter()).map_err(|e| format!("captures changed: {e}"))?)
}

/// Within the distance the captures of before are used, and none are paid for; beyond it fresh ones
/// are. Methods that keep nothing always have fresh ones.
fn kept_or_not<S: Stage>(
    variant: &Variant,
    stage: impl Fn(&Subject) -> Result<S, Failed>,
) -> Outcome {
    let subject = &SUBJECTS[0];
    let here = subject.cpu.scene().reference_point;
    let home = here - Vec3::X * MOVED_M;
    let moved = changed(subject, |scene| scene.captured_at = Some(home))?;
    let at_home = changed(subject, |scene| {
        scene.reference_point = home;
        scene.captured_at = None;
    })?;
    let points = subject.points(variant.quantity.layout());
    let (mut near, mut far) = (variant.copy(), variant.copy());
    let keeps = (near.method.set("recapture_distance", "0.21")).is_ok();
    far.method.set("recapture_distance", "0.19").ok();
    for (variant, kept) in [(&near, keeps), (&far, false)] {
        let needs = variant
            .method
            .needs(variant.quantity, &moved.cpu.scene().facts())?;
        let (method, quantity) = (&*variant.method, variant.quantity);
        let scene = moved.cpu.scene();
        let measured = measure(
            &stage(&moved)?,
            scene,
            method,
            quantity,
            &points,
            &Sampling::ONCE,
        )?;
        let timed = measured.phases.capture.is_some();
        ensure!(
            timed != (kept || needs.no_captures()),
            "kept: {kept}, and a capture is timed: {timed}"
        );
        let like = if kept { &at_home } else { subject };
        let expected = run(&stage(like)?, like, variant, &points)?;
        same_bits(&expected, measured.estimate.iter()).map_err(|e| format!("kept {kept}: {e}"))?;
    }
    Ok(())
}

/// Three receivers share the captures: each point has what it has with one receiver.
fn shared<S: Stage>(variant: &Variant, stage: impl Fn(&Subject) -> Result<S, Failed>) -> Outcome {
    let three = Subject::library(
        "colored-room",
        &[("receivers", "3"), ("receiver.size", "0.4")],
    );
    let one = three.with_scene(SUBJECTS[0].cpu.clone());
    let points = three.points(variant.quantity.layout());
    let xs = || points.iter().flatten().map(|p| p.position.x);
    ensure!(
        xs().any(|x| x < -0.4) && xs().any(|x| x.abs() < 0.2) && xs().any(|x| x > 0.4),
        "the points are not on all receivers"
    );
    let needs = variant
        .method
        .needs(variant.quantity, &three.cpu.scene().facts())?;
    let together = run(&stage(&three)?, &three, variant, &points)?;
    ensure!(together.iter().all(Vec3::is_finite), "not finite");
    // Light transport sees the other receivers.
    if needs.light_transport {
        return Ok(());
    }
    let alone = run(&stage(&one)?, &one, variant, &points)?;
    Ok(same_bits(&alone, together.iter())?)
}
