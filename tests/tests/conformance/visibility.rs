//! Visibility: depth maps, occlusion queries and rays against each other, refined, and only where it
//! is about to be seen.

mod filtered;
mod rigid;
mod ways;

use crate::test_scenes::{TEST_SCENES, TestScene, same_bits};
use crate::variants::{Outcome, configured, cpu_scene, gpu_scene, ignored, on_gpu};
use interreflect::view::{Look, Mirrors, Shade, ShadedAt, View};
use interreflect_estimators::execution::BackendScene;
use interreflect_estimators::{Changed, Quantity, Records};
use interreflect_scene::{Camera, Estimate, PointLayout, Points};
use libtest_mimic::{Failed, Trial};
use std::path::PathBuf;
use ways::ways_agree;

const VERTICES: Look = Look {
    at: ShadedAt::Vertices,
    mirrors: Mirrors::Included,
    shade: Shade::Receivers,
};

const AO: Quantity = Quantity::AmbientOcclusion;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = vec![on_gpu("visibility/ways_agree/blob".into(), |context| {
        ways_agree(context, "blob".as_ref())
    })];
    for model in ["bunny", "dragon"] {
        let name = format!("visibility/ways_agree/{model}");
        let file = PathBuf::from(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../shared/assets/meshes"
        ))
        .join(format!("{model}.obj"));
        trials.push(match file.exists() {
            true => on_gpu(name, move |context| ways_agree(context, &file)),
            false => ignored(name, "the model is not there"),
        });
    }
    let refined = "visibility/refinement";
    trials.extend([
        Trial::test(format!("{refined}/cpu"), || {
            refinement(&cpu_scene(studio()))
        }),
        on_gpu(format!("{refined}/gpu"), |c| {
            refinement(&gpu_scene(c, studio())?)
        }),
    ]);
    trials.extend(filtered::trials());
    trials.extend(rigid::trials());
    trials
}

fn studio() -> &'static TestScene {
    &TEST_SCENES[2]
}

fn small(camera: Camera) -> Camera {
    Camera {
        resolution: [64, 64],
        ..camera
    }
}

/// Frames of a session of one method: what changed, and what the camera sees.
fn frames<'v, S: BackendScene>(
    loaded: &'v S,
    settings: &[(&str, &str)],
    points: &'v Points,
    frames: impl IntoIterator<Item = (Changed, Option<&'v View>)>,
) -> Result<Vec<Estimate>, Failed> {
    let variant = configured("directional_ao", AO, settings)?;
    let mut executor = variant.executor(loaded, points)?;
    let mut estimates = Vec::new();
    for (changed, view) in frames {
        executor.set_visible(view.and_then(View::visible));
        executor.prepare(changed)?;
        executor.shade()?;
        estimates.push(executor.read_back()?.0);
    }
    Ok(estimates)
}

/// After the surfaces come to rest the level rises by one a frame, and gives bit for bit what a fresh
/// evaluation at that level gives. A changed environment changes nothing here.
fn refinement<S: BackendScene>(loaded: &S) -> Outcome {
    let points = studio().points(PointLayout::Surface);
    let settings = |level| {
        [
            ("level", level),
            ("moving_level", "0"),
            ("fidelity", "corrected"),
        ]
    };
    let moved = Changed::SCENE | Changed::POINTS;
    let rest = [Changed::NOTHING, Changed::ENVIRONMENT, Changed::NOTHING];
    let all = [Changed::ALL, moved].into_iter().chain(rest);
    let refined = frames(loaded, &settings("3"), &points, all.map(|c| (c, None)))?;
    for (frame, level) in [(1, "0"), (2, "1"), (3, "2"), (4, "3")] {
        let fresh = frames(loaded, &settings(level), &points, [(Changed::ALL, None)])?;
        same_bits(&fresh[0], refined[frame].iter())
            .map_err(|e| format!("frame {frame}, level {level}: {e}"))?;
    }
    Ok(())
}

/// How many points were evaluated, by what a session shows of itself.
fn evaluations_of(records: &[Records]) -> Result<u64, Failed> {
    let found = records.iter().find(|r| r.name == "evaluations");
    let found = found.and_then(|r| r.values.first());
    Ok(*found.ok_or("no count of evaluations")? as u64)
}
