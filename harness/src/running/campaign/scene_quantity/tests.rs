use super::*;
use crate::running::view::Shade;
use interreflect_cpu::scene::CpuScene;
use interreflect_scene::{PointLayout, SceneRequest, open};

/// A ring before an open background: a black estimate of a white ring differs as much as anything can, and
/// the background, which shows no surface and is black in both, has no part in the mean.
#[test]
fn flip_is_a_mean_over_what_shows_a_surface() {
    let scene = open(&SceneRequest {
        receivers: vec!["torus".into()],
        ..SceneRequest::new("studio")
    });
    let scene = scene.expect("a built-in scene");
    let cpu = CpuScene::new(&scene).expect("a scene that the CPU takes");
    let view =
        View::of_about(&cpu, &scene.camera, (10_000, Shade::default())).expect("a small view");
    let surfaces = view.surfaces();
    let share = surfaces.iter().filter(|s| **s).count() as f64 / surfaces.len() as f64;
    assert!(share < 0.8, "there is a background: {share}");
    let count = view.points(PointLayout::Surface).len();
    let flat = |value: f32| {
        let mut estimate = Estimate::new(count);
        for i in 0..count {
            estimate.set(i, glam::Vec3::splat(value));
        }
        estimate
    };
    let (black, white) = (flat(0.0), flat(1.0));
    let found = flip_of(&view, &black, &white).expect("a surface");
    let images = [&black, &white].map(|e| view.image(e));
    let all = metrics::flip(&images[0], &images[1], |_| true).expect("pixels");
    // Beside the rim, as far as the filters reach, the background counts a little too.
    assert!(found > 1.1 * all.mean, "{found} {all:?}");
    assert!(found <= all.mean / share + 1e-6, "{found} {all:?}");
    assert_eq!(flip_of(&view, &white, &white), Some(0.0));
}
