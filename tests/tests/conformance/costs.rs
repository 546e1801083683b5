//! What a scene does not have costs no pass.

use crate::ensure;
use crate::subjects::{SUBJECTS, Subject};
use crate::world::{Outcome, Variant, gpu_scene, on_gpu, variants};
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::{Changed, Quantity};
use interreflect_gpu::{GpuContext, GpuError, capture_cube, capture_light_views};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{CubeSpec, Needs, Point, Points};
use libtest_mimic::{Failed, Trial};
use std::sync::Arc;

pub(crate) fn trials() -> Vec<Trial> {
    vec![
        on_gpu("costs/no_shadow_pass_without_lights".into(), shadows),
        on_gpu("costs/no_place_without_surfaces".into(), places),
        on_gpu("costs/no_lobes_without_speculars".into(), lobes),
        on_gpu("costs/no_mirror_pass_without_mirrors".into(), mirrors),
    ]
}

/// Every method that runs on the device.
fn on_device() -> impl Iterator<Item = Variant> {
    variants(32).into_iter().filter(|v| v.gpu().is_ok())
}

/// Labels of the passes that making the captures takes.
fn capture_passes(
    context: &Arc<GpuContext>,
    subject: &Subject,
    needs: &Needs,
) -> Result<Vec<&'static str>, Failed> {
    let loaded = gpu_scene(context, subject)?;
    let origin = subject.cpu.scene().reference_point;
    let (passes, _) = context.record("capture", |cx| {
        for spec in &needs.cubes {
            capture_cube(cx, &loaded.scene, origin, *spec, None)?;
        }
        for spec in &needs.light_views {
            capture_light_views(cx, &loaded.scene, *spec)?;
        }
        Ok::<_, GpuError>(cx.passes().to_vec())
    })?;
    Ok(passes)
}

/// Labels of the passes of `prepare` and `shade`.
fn method_passes(
    context: &Arc<GpuContext>,
    subject: &Subject,
    variant: &Variant,
    points: &Points,
) -> Result<Vec<&'static str>, Failed> {
    let loaded = gpu_scene(context, subject)?;
    let mut executor = variant.executor(&loaded, points)?;
    let mut passes = Vec::new();
    executor.phase("prepare", Changed::ALL, |session, frame| {
        session.prepare(frame)?;
        passes.extend_from_slice(frame.cx.passes());
        Ok(())
    })?;
    executor.phase("shade", Changed::NOTHING, |session, frame| {
        let prepared = session.prepared();
        prepared.map_or(Ok(()), |prepared| prepared.shade(frame))?;
        passes.extend_from_slice(frame.cx.passes());
        Ok(())
    })?;
    Ok(passes)
}

/// Label of the pass that lights need.
const SHADOWS: &str = "shadow maps";

/// In the emitting box there is no light: no method's captures render shadow maps. In the
/// coloured room with its lamp those of every method that captures radiance do.
fn shadows(context: &Arc<GpuContext>) -> Outcome {
    let [lit, unlit] = [&SUBJECTS[0], &SUBJECTS[3]].map(|s| -> &Subject { s });
    ensure!(
        lit.cpu.scene().facts().lights > 0 && unlit.cpu.scene().facts().lights == 0,
        "the scenes are not what they should be"
    );
    for variant in on_device() {
        for (subject, expected) in [(lit, true), (unlit, false)] {
            if !variant.runs_in(subject) {
                continue;
            }
            let facts = subject.cpu.scene().facts();
            let needs = variant.method.needs(variant.quantity, &facts)?;
            let passes = capture_passes(context, subject, &needs)?;
            let radiance = needs.cubes.iter().any(|c| c.channels.radiance);
            ensure!(
                passes.contains(&SHADOWS) == (expected && radiance),
                "{} in {}: {passes:?}",
                variant.name(),
                subject.name
            );
        }
    }
    Ok(())
}

/// Under an open sky nothing has a place: six passes for each cube, one a face, and no channel but
/// radiance. In a room some method asks for more.
fn places(context: &Arc<GpuContext>) -> Outcome {
    let [room, sky] = [&SUBJECTS[3], &SUBJECTS[4]].map(|s| -> &Subject { s });
    let mut located = 0;
    for variant in on_device() {
        let needs_in = |subject: &Subject| {
            let facts = subject.cpu.scene().facts();
            variant.method.needs(variant.quantity, &facts)
        };
        let has_place = |c: &CubeSpec| c.channels.distance || c.channels.normal;
        if !variant.runs_in(sky) {
            continue;
        }
        let needs = needs_in(sky)?;
        ensure!(
            !needs.cubes.iter().any(has_place),
            "{} asks for {:?}",
            variant.name(),
            needs.cubes
        );
        let passes = capture_passes(context, sky, &needs)?;
        ensure!(
            passes.len() == CUBE_FACES * needs.cubes.len(),
            "{}: {passes:?}",
            variant.name()
        );
        let placed = |needs: Needs| needs.cubes.iter().any(has_place);
        located += usize::from(variant.runs_in(room) && placed(needs_in(room)?));
    }
    ensure!(located > 0, "no method asks for the place of anything");
    Ok(())
}

/// Where no point has a specular lobe, no pass is for lobes: a method's passes are fewer than where
/// some have, or the same if it has none for them.
fn lobes(context: &Arc<GpuContext>) -> Outcome {
    let subject: &Subject = &SUBJECTS[0];
    let mut fewer = 0;
    let glossy = |v: &Variant| v.quantity == Quantity::GlossyRadiance && v.runs_in(subject);
    for variant in on_device().filter(glossy) {
        let of = |shines: bool| {
            let points = subject.points(variant.quantity.layout());
            let dull = |p: Point| {
                let mut p = p;
                p.material.specular *= f32::from(u8::from(shines));
                p
            };
            let points = points.iter().map(|p| p.map(dull));
            let points = Points::new(variant.quantity.layout(), points);
            method_passes(context, subject, &variant, &points)
        };
        let (with, without) = (of(true)?, of(false)?);
        ensure!(
            without.len() <= with.len(),
            "{}: {without:?} without lobes, {with:?} with them",
            variant.name()
        );
        fewer += usize::from(without.len() < with.len());
    }
    ensure!(fewer > 0, "no method has a pass for lobes");
    Ok(())
}

/// Label of the pass that mirrors in lights' views need.
const MIRRORS: &str = "mirrors in light views";

/// Pictures from the lights take one pass a view, one that finds what is lit, no shadow maps; and
/// one that follows mirrors where the scene has some.
fn mirrors(context: &Arc<GpuContext>) -> Outcome {
    let plain: &Subject = &SUBJECTS[1];
    let mut scene = plain.cpu.scene().clone();
    for material in &mut scene.materials {
        material.mirror = true;
    }
    let mirrored = plain.with_scene(Arc::new(CpuScene::new(&scene)?));
    let mut pictured = 0;
    for variant in on_device().filter(|v| v.runs_in(plain)) {
        for (subject, expected) in [(plain, false), (&mirrored, true)] {
            let facts = subject.cpu.scene().facts();
            let needs = variant.method.needs(variant.quantity, &facts)?;
            let only = Needs {
                light_views: needs.light_views,
                ..Needs::default()
            };
            let passes = capture_passes(context, subject, &only)?;
            let views = subject.cpu.scene().light_frames().len();
            let each = views + 1 + usize::from(expected);
            ensure!(
                passes.len() == each * only.light_views.len(),
                "{}: {passes:?}",
                variant.name()
            );
            ensure!(
                passes.contains(&MIRRORS) == (expected && !only.light_views.is_empty()),
                "{}: {passes:?}",
                variant.name()
            );
            pictured += only.light_views.len();
        }
    }
    ensure!(pictured > 0, "no method takes pictures from lights");
    Ok(())
}
