//! What a method declares is what it reads, and it shades nothing before it has read it.

use crate::ensure;
use crate::subjects::{SUBJECTS, Subject};
use crate::world::{Outcome, Variant, captures, cpu_stage, gpu_stage, ignored, on_gpu, variants};
use interreflect::measure::measure;
use interreflect_estimators::stage::{Placed, Stage};
use interreflect_estimators::{Captures, Changed, EstimatorError, Inputs};
use interreflect_scene::{CubeChannels, CubeSpec, LightViewChannels, LightViewSpec, Needs};
use libtest_mimic::{Failed, Trial};

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        for subject in &SUBJECTS {
            let name = format!("needs/{}/{}", subject.name, variant.name());
            let one = variant.copy();
            if let Some(why) = one.unsupported(subject) {
                trials.push(ignored(name, &why));
                continue;
            }
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                all_read(&cpu_stage(subject), subject, &one)?;
                nothing_else(&cpu_stage(subject), subject, &one)?;
                unprepared(&cpu_stage(subject), subject, &one)
            }));
            let (name, one) = (format!("{name}/gpu"), variant.copy());
            trials.push(on_gpu_or_why_not(name, subject, one));
        }
    }
    trials
}

/// A method without an implementation on the device says why, and never anything else.
fn on_gpu_or_why_not(name: String, subject: &'static Subject, variant: Variant) -> Trial {
    if let Some(why) = variant.unsupported_on_gpu(subject) {
        return ignored(name, &why);
    }
    on_gpu(name, move |context| {
        let stage = gpu_stage(context, subject)?;
        all_read(&stage, subject, &variant)?;
        unprepared(&stage, subject, &variant)
    })
}

/// The harness's own account: nothing is declared and not read, on any backend, and what is not
/// in the scene is not asked for.
fn all_read<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let points = subject.points(variant.quantity.layout());
    let scene = subject.cpu.scene();
    let measured = measure(stage, scene, &*variant.method, variant.quantity, &points, 0)?;
    let unread = measured.unread;
    ensure!(
        unread == Needs::default(),
        "declared and never read: {unread:?}"
    );
    let needs = variant.method.needs(variant.quantity, &scene.facts())?;
    for spec in &needs.cubes {
        let place = spec.channels.distance || spec.channels.normal;
        ensure!(
            scene.facts().surfaces || !place,
            "asks for the place of surfaces, where there are none: {spec:?}"
        );
    }
    ensure!(
        needs.light_views.is_empty() || scene.facts().surfaces && scene.facts().lights > 0,
        "asks for pictures where no light or no surface is: {:?}",
        needs.light_views
    );
    Ok(())
}

/// Captures that exist but were not declared can't be read.
fn nothing_else<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let scene = subject.cpu.scene();
    let facts = scene.facts();
    let declared = variant.method.needs(variant.quantity, &facts)?;
    let points = subject.points(variant.quantity.layout());
    let Placed { points: placed, .. } = stage.place(&points)?;
    let mut more = declared.clone();
    more.light_transport = true;
    let spec = |size, normal| CubeSpec {
        size,
        channels: CubeChannels {
            radiance: true,
            normal,
            ..CubeChannels::default()
        },
        bounces: 0,
    };
    let others = [spec(3, false), spec(3, true)];
    more.cubes.extend(others);
    let view = |size, normal| LightViewSpec {
        size,
        channels: LightViewChannels {
            normal,
            ..LightViewChannels::default()
        },
    };
    let other_views = [view(3, false), view(3, true)];
    more.light_views.extend(other_views);
    let captures: Captures<S::Backend> = stage.capture(&more)?.0;
    let origin = (facts, scene.reference_point);
    let inputs = Inputs::new(&declared, &captures, &placed, &points, origin, Changed::ALL);
    for spec in others {
        refused(inputs.cube(&spec))?;
    }
    for spec in other_views {
        refused(inputs.light_view(&spec))?;
    }
    if !declared.light_transport {
        refused(inputs.light_transport())?;
    }
    ensure!(
        inputs.read() == Needs::default(),
        "a refused capture counts as read: {:?}",
        inputs.read()
    );
    Ok(())
}

/// A session that was not prepared says so. One without a state, which traces the scene itself, may
/// answer.
fn unprepared<S: Stage>(stage: &S, subject: &Subject, variant: &Variant) -> Outcome {
    let captures = captures(stage, subject, variant)?;
    let scene = subject.cpu.scene();
    let facts = scene.facts();
    let declared = variant.method.needs(variant.quantity, &facts)?;
    if declared.light_transport {
        return Ok(());
    }
    let points = subject.points(variant.quantity.layout());
    let Placed {
        points: placed,
        mut out,
    } = stage.place(&points)?;
    let origin = (facts, scene.reference_point);
    let inputs = Inputs::new(&declared, &captures, &placed, &points, origin, Changed::ALL);
    let mut session = stage.open(&*variant.method)?;
    let shaded = stage.timed("shade", &mut |cx| {
        session.shade(cx, variant.quantity, &inputs, &mut out)
    });
    match shaded {
        Err(EstimatorError::Unprepared) => Ok(()),
        Err(other) => Err(format!("unprepared, it fails with another reason: {other}").into()),
        Ok(_) => Err("it shades without having been prepared".into()),
    }
}

fn refused<T>(read: Result<T, EstimatorError>) -> Result<(), Failed> {
    match read {
        Err(EstimatorError::Undeclared(_)) => Ok(()),
        Err(other) => Err(format!("refused with another reason: {other}").into()),
        Ok(_) => Err("an undeclared capture was read".into()),
    }
}
