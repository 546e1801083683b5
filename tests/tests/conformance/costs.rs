//! What a scene does not have costs no pass.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{Outcome, Variant, gpu_scene, on_gpu, variants};
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::{Changed, Quantity};
use interreflect_gpu::{GpuContext, GpuError, capture_cube, capture_rsms};
use interreflect_scene::conventions::CUBE_FACES;
use interreflect_scene::{CubeSpec, Needs, Point, Points, RsmSpec};
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
    test_scene: &TestScene,
    needs: &Needs,
) -> Result<Vec<&'static str>, Failed> {
    let loaded = gpu_scene(context, test_scene)?;
    let origin = test_scene.cpu.scene().reference_point;
    let (passes, _) = context.record("capture", |cx| {
        for spec in &needs.cubes {
            capture_cube(cx, &loaded.scene, origin, *spec, None)?;
        }
        for spec in &needs.rsms {
            capture_rsms(cx, &loaded.scene, *spec)?;
        }
        Ok::<_, GpuError>(cx.passes().to_vec())
    })?;
    Ok(passes)
}

/// Labels of the passes of `prepare` and `shade`.
fn method_passes(
    context: &Arc<GpuContext>,
    test_scene: &TestScene,
    variant: &Variant,
    points: &Points,
) -> Result<Vec<&'static str>, Failed> {
    let loaded = gpu_scene(context, test_scene)?;
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
    let [lit, unlit] = [&TEST_SCENES[0], &TEST_SCENES[3]].map(|s| -> &TestScene { s });
    ensure!(
        lit.cpu.scene().facts().lights > 0 && unlit.cpu.scene().facts().lights == 0,
        "the scenes are not what they should be"
    );
    for variant in on_device() {
        for (test_scene, expected) in [(lit, true), (unlit, false)] {
            if !variant.runs_in(test_scene) {
                continue;
            }
            let facts = test_scene.cpu.scene().facts();
            let needs = variant.method.needs(variant.quantity, &facts)?;
            let passes = capture_passes(context, test_scene, &needs)?;
            let radiance = needs.cubes.iter().any(|c| c.channels.radiance);
            ensure!(
                passes.contains(&SHADOWS) == (expected && radiance),
                "{} in {}: {passes:?}",
                variant.name(),
                test_scene.name
            );
        }
    }
    Ok(())
}

/// Under an open sky nothing has a place: six passes for each cube, one a face, and no channel but
/// radiance. In a room some method asks for more.
fn places(context: &Arc<GpuContext>) -> Outcome {
    let [room, sky] = [&TEST_SCENES[3], &TEST_SCENES[4]].map(|s| -> &TestScene { s });
    let mut located = 0;
    for variant in on_device() {
        let needs_in = |test_scene: &TestScene| {
            let facts = test_scene.cpu.scene().facts();
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
    let test_scene: &TestScene = &TEST_SCENES[0];
    let mut fewer = 0;
    let glossy = |v: &Variant| v.quantity == Quantity::GlossyRadiance && v.runs_in(test_scene);
    for variant in on_device().filter(glossy) {
        let of = |shines: bool| {
            let points = test_scene.points(variant.quantity.layout());
            let dull = |p: Point| {
                let mut p = p;
                p.material.specular *= f32::from(u8::from(shines));
                p
            };
            let points = points.iter().map(|p| p.map(dull));
            let points = Points::new(variant.quantity.layout(), points);
            method_passes(context, test_scene, &variant, &points)
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
const MIRRORS: &str = "mirrors in RSMs";

/// Pictures from the lights take one pass a view, one that finds what is lit, no shadow maps; and
/// one that follows mirrors where the scene has some.
fn mirrors(context: &Arc<GpuContext>) -> Outcome {
    let plain: &TestScene = &TEST_SCENES[1];
    let mut scene = plain.cpu.scene().clone();
    for material in &mut scene.materials {
        material.mirror = true;
    }
    let mirrored = plain.with_scene(Arc::new(CpuScene::new(&scene)?));
    let mut pictured = 0;
    for variant in on_device().filter(|v| v.runs_in(plain)) {
        for (test_scene, expected) in [(plain, false), (&mirrored, true)] {
            let facts = test_scene.cpu.scene().facts();
            let needs = variant.method.needs(variant.quantity, &facts)?;
            let only = Needs {
                rsms: needs.rsms,
                ..Needs::default()
            };
            let passes = capture_passes(context, test_scene, &only)?;
            let views = |spec: &RsmSpec| test_scene.cpu.scene().light_frames(spec.views).len();
            let each = |spec| views(spec) + 1 + usize::from(expected);
            ensure!(
                passes.len() == only.rsms.iter().map(each).sum::<usize>(),
                "{}: {passes:?}",
                variant.name()
            );
            ensure!(
                passes.contains(&MIRRORS) == (expected && !only.rsms.is_empty()),
                "{}: {passes:?}",
                variant.name()
            );
            pictured += only.rsms.len();
        }
    }
    ensure!(pictured > 0, "no method takes pictures from lights");
    Ok(())
}
