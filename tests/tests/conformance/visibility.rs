//! Visibility: depth maps, occlusion queries and rays against each other, refined, and only where it
//! is about to be seen.

mod ways;

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene, same_bits};
use crate::variants::{CPU, Outcome, configured, cpu_scene, gpu_scene, ignored, on_gpu};
use glam::Quat;
use interreflect::view::{Look, Mirrors, Shade, ShadedAt, View};
use interreflect_cpu::scene::CpuScene;
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
    let (refined, filtered) = ("visibility/refinement", "visibility/filtering");
    trials.extend([
        Trial::test(format!("{refined}/cpu"), || {
            refinement(&cpu_scene(studio()))
        }),
        on_gpu(format!("{refined}/gpu"), |c| {
            refinement(&gpu_scene(c, studio())?)
        }),
        Trial::test(format!("{filtered}/cpu"), || {
            filtering(&cpu_scene(studio()))
        }),
        on_gpu(format!("{filtered}/gpu"), |c| {
            filtering(&gpu_scene(c, studio())?)
        }),
        Trial::test("visibility/evaluations", evaluations),
    ]);
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

/// A camera that goes around: each frame has at the vertices of visible triangles what an evaluation
/// of all vertices gives.
fn filtering<S: BackendScene>(loaded: &S) -> Outcome {
    let views = orbit()?;
    let points = views[0].points(PointLayout::Surface);
    let settings = |filter| {
        [
            ("level", "1"),
            ("map_resolution", "128"),
            ("filter", filter),
        ]
    };
    let changed = |i: usize| {
        if i == 0 {
            Changed::ALL
        } else {
            Changed::NOTHING
        }
    };
    let sequence = || {
        views
            .iter()
            .enumerate()
            .map(|(i, view)| (changed(i), Some(view)))
    };
    let all = frames(loaded, &settings("false"), &points, sequence())?;
    let filtered = frames(loaded, &settings("true"), &points, sequence())?;
    for (i, view) in views.iter().enumerate() {
        let (a, b) = (view.image(&all[i]), view.image(&filtered[i]));
        ensure!(a.pixels == b.pixels, "frame {i} has other visible vertices");
    }
    ensure!(
        filtered[0].iter().zip(all[0].iter()).any(|(a, b)| a != b),
        "vertices at the back were evaluated in the first frame too"
    );
    Ok(())
}

/// How many points were evaluated, by what a session shows of itself.
fn evaluations_of(records: &[Records]) -> Result<u64, Failed> {
    let found = records.iter().find(|r| r.name == "evaluations");
    let found = found.and_then(|r| r.values.first());
    Ok(*found.ok_or("no count of evaluations")? as u64)
}

/// Six views of the studio's receiver, 15° apart.
fn orbit() -> Result<Vec<View>, Failed> {
    let scene: &CpuScene = &studio().cpu;
    let camera = scene.scene().camera;
    let views = (0..6).map(|i| {
        let turn = Quat::from_rotation_y((15.0 * i as f32).to_radians());
        let eye = camera.target + turn * (camera.eye - camera.target);
        let camera = small(Camera { eye, ..camera });
        CPU.install(|| View::new(scene, &camera, VERTICES))
    });
    Ok(views.collect::<Result<_, _>>()?)
}

/// With the lists no vertex is evaluated twice, only those are that were seen, and a camera that goes
/// a quarter around leaves some untouched; without them all are evaluated in the first frame.
fn evaluations() -> Outcome {
    let (views, loaded) = (orbit()?, cpu_scene(studio()));
    let points = views[0].points(PointLayout::Surface);
    let mut seen: Vec<bool> = vec![false; points.len()];
    let mut counts = [Vec::new(), Vec::new()];
    for (filter, counts) in [false, true].into_iter().zip(&mut counts) {
        let settings = [
            ("level", "0"),
            ("map_resolution", "64"),
            ("filter", if filter { "true" } else { "false" }),
        ];
        let variant = configured("directional_ao", AO, &settings)?;
        let mut executor = variant.executor(&loaded, &points)?;
        for (i, view) in views.iter().enumerate() {
            let changed = if i == 0 {
                Changed::ALL
            } else {
                Changed::NOTHING
            };
            executor.set_visible(view.visible());
            executor.prepare(changed)?;
            counts.push(evaluations_of(&executor.records()?)?);
        }
    }
    let mut expected = Vec::new();
    for view in &views {
        let visible = view.visible().ok_or("no vertices")?;
        for &triangle in visible.visible {
            visible.triangles[triangle as usize]
                .iter()
                .for_each(|&v| seen[v as usize] = true);
        }
        expected.push(seen.iter().filter(|s| **s).count() as u64);
    }
    let all = points.len() as u64;
    println!(
        "evaluated of {all}: {:?} without lists, {:?} with them",
        counts[0], counts[1]
    );
    ensure!(
        counts[0] == vec![all; views.len()],
        "without lists: {:?}",
        counts[0]
    );
    ensure!(
        counts[1] == expected,
        "with lists: {:?}, seen: {expected:?}",
        counts[1]
    );
    ensure!(
        expected[0] < all / 2 && *expected.last().unwrap_or(&0) < all,
        "nothing to save"
    );
    Ok(())
}
