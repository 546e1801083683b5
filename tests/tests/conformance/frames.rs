//! A session that lives on over the frames of a moving scene gives what a fresh one gives.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene, same_bits};
use crate::variants::{Outcome, configured, cpu_scene, gpu_scene, on_gpu, run};
use glam::Vec3;
use interreflect::frames::{Frame, Frames};
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::motion::{LightMotion, Pose, Track};
use interreflect_scene::{Motion, Point, Points, Scene};
use libtest_mimic::{Failed, Trial};
use std::sync::Arc;

/// What moves, in which test scene, and how it is set in motion.
type Moving = (&'static str, usize, fn(&mut Scene));

const MOVING: [Moving; 4] = [
    ("geometry", 3, |scene| {
        let moved = Pose {
            translate: Vec3::new(0.1, 0.2, 0.0),
            ..Pose::REST
        };
        scene.objects[0].motion = Some(Motion {
            poses: track(Pose::REST, moved),
            ..Motion::default()
        });
    }),
    ("lights", 0, |scene| {
        let centre = scene.reference_point;
        scene.motion.lights = vec![LightMotion {
            position: track(centre + 0.5 * Vec3::Y, centre + 0.5 * Vec3::X),
            direction: track(Vec3::X, Vec3::Y),
        }];
    }),
    ("environment", 4, |scene| {
        scene.motion.environment_deg_per_s = 40.0;
    }),
    // The points follow the camera.
    ("camera", 0, |_| {}),
];

/// From one value at rest to another a second later.
fn track<V>(from: V, to: V) -> Track<V> {
    Track {
        keys: vec![(0.0, from), (1.0, to)],
    }
}

pub(crate) fn trials() -> Vec<Trial> {
    let of = |moving: Moving| {
        let name = format!("frames/{}", moving.0);
        let on_cpu = Trial::test(format!("{name}/cpu"), move || {
            follows(moving, |test_scene| Ok(cpu_scene(test_scene)))
        });
        let on_device = on_gpu(format!("{name}/gpu"), move |context| {
            follows(moving, |test_scene| gpu_scene(context, test_scene))
        });
        [on_cpu, on_device]
    };
    MOVING.into_iter().flat_map(of).collect()
}

/// Each frame, the one in which time stands still too, is what a session of its own gives.
fn follows<S: BackendScene>(
    (what, test_scene, set_in_motion): Moving,
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    let test_scene = &TEST_SCENES[test_scene];
    let mut scene = test_scene.cpu.scene().clone();
    set_in_motion(&mut scene);
    let settings = [("fidelity", "corrected"), ("capture_resolution", "32")];
    let variant = configured("localized_cubemap", Quantity::Irradiance, &settings)?;
    let (method, quantity) = (&*variant.method, variant.quantity);
    let points = test_scene.points(quantity.layout());
    let mut reversed: Vec<Option<Point>> = points.iter().collect();
    reversed.reverse();
    let reversed = Points::new(points.layout(), reversed);
    let mut frames = Frames::<S::Backend>::default();
    let mut shown = Vec::new();
    for time_s in [0.0, 0.5, 0.5, 1.0] {
        let scene_then = scene.at(time_s);
        let then = test_scene.with_scene(Arc::new(CpuScene::new(&scene_then)?));
        let points = match what == "camera" && time_s > 0.0 {
            true => &reversed,
            false => &points,
        };
        let loaded = loaded(&then)?;
        let frame = Frame {
            scene: &scene_then,
            moves: scene.moves(),
            points,
            visible: None,
        };
        let living = frames.next(&loaded, method, quantity, &frame)?.estimate;
        let fresh = run(&loaded, &variant, points)?;
        same_bits(&fresh, living.iter()).map_err(|e| format!("at {time_s} s: {e}"))?;
        shown.push(living);
    }
    ensure!(shown[0] != shown[1], "the motion does not show");
    Ok(())
}
