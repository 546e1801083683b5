//! Results have the same bits for any order of the points, on the CPU also for any number of
//! threads and any instruction set, and however often a session was prepared.

use crate::subjects::{SUBJECTS, Subject, same_bits};
use crate::world::{
    Outcome, Variant, captures, cpu_stage, estimate, gpu_stage, ignored, on_gpu, run, variants,
};
use interreflect_cpu::tiles::{CpuCx, InstructionSet};
use interreflect_estimators::stage::{CpuStage, Stage};
use interreflect_estimators::{Changed, Inputs};
use interreflect_scene::params::Choice;
use interreflect_scene::{Estimate, Point, Points};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        for subject in &SUBJECTS[2..4] {
            let name = format!("bits/{}/{}", subject.name, variant.name());
            let one = variant.copy();
            if let Some(why) = one.unsupported(subject) {
                trials.push(ignored(name, &why));
                continue;
            }
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                threads_and_instructions(subject, &one)?;
                prepared_again(&cpu_stage(subject), subject, &one)
            }));
            if variant.unsupported_on_gpu(subject).is_none() {
                let one = variant.copy();
                trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                    let stage = gpu_stage(context, subject)?;
                    any_order(&stage, subject, &one)?;
                    prepared_again(&stage, subject, &one)
                }));
            }
        }
    }
    trials
}

fn threads_and_instructions(subject: &'static Subject, variant: &Variant) -> Outcome {
    let points = subject.points(variant.quantity.layout());
    let mut first: Option<Estimate> = None;
    for (set_name, set) in InstructionSet::ALL {
        for threads in [1, 2] {
            if !set.available() {
                println!("not run: this processor has no {set_name}");
                continue;
            }
            let cx = CpuCx::new(Some(threads), Some(*set))?;
            let stage = CpuStage {
                cx: &cx,
                scene: subject.cpu.clone(),
            };
            let estimate = run(&stage, subject, variant, &points)?;
            let first = first.get_or_insert_with(|| estimate.clone());
            same_bits(first, estimate.iter())
                .map_err(|e| format!("{threads} threads, {set_name}: {e}"))?;
        }
    }
    let cx = CpuCx::new(Some(2), None)?;
    let stage = CpuStage {
        cx: &cx,
        scene: subject.cpu.clone(),
    };
    let needs = variant
        .method
        .needs(variant.quantity, &subject.cpu.scene().facts())?;
    // Samples of light transport are drawn by a point's place in the list.
    match needs.light_transport {
        true => Ok(()),
        false => any_order(&stage, subject, variant),
    }
}

/// Reversed points get the same values, reversed.
fn any_order<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let points = subject.points(variant.quantity.layout());
    let mut reversed: Vec<Option<Point>> = points.iter().collect();
    reversed.reverse();
    let reversed = Points::new(points.layout(), reversed);
    let forward = run(stage, subject, variant, &points)?;
    let backward = run(stage, subject, variant, &reversed)?;
    let mut backward: Vec<_> = backward.iter().collect();
    backward.reverse();
    Ok(same_bits(&forward, backward.into_iter()).map_err(|e| format!("points reversed: {e}"))?)
}

/// A session prepared again for captures alone gives what it gave at first.
fn prepared_again<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let (scene, quantity) = (subject.cpu.scene(), variant.quantity);
    let points = subject.points(quantity.layout());
    let captures = captures(stage, subject, variant)?;
    let first = estimate(stage, subject, variant, &captures, &points)?;
    let needs = variant.method.needs(quantity, &scene.facts())?;
    let mut session = stage.open(&*variant.method)?;
    let mut placed = stage.place(&points)?;
    let origin = (scene.facts(), scene.reference_point);
    let view = |changed| Inputs::new(&needs, &captures, &placed.points, &points, origin, changed);
    for changed in [Changed::ALL, Changed::CAPTURES] {
        let inputs = view(changed);
        stage.timed("prepare", &mut |cx| {
            session.prepare(cx, quantity, &inputs, &placed.out)
        })?;
    }
    let inputs = view(Changed::default());
    stage.timed("shade", &mut |cx| {
        session.shade(cx, quantity, &inputs, &mut placed.out)
    })?;
    let again = stage.read_back(&placed.out)?.0;
    Ok(same_bits(&first, again.iter()).map_err(|e| format!("prepared again: {e}"))?)
}
