//! Which pictures are taken, and what they show.

use crate::ensure;
use crate::test_scenes::{TestScene, inside};
use crate::variants::{Outcome, cpu_scene, gpu_scene, on_both, on_gpu};
use glam::Vec3;
use interreflect_estimators::Tolerance;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::{Estimate, Light, LightPicture, Object, Point, Role, shapes};
use libtest_mimic::{Failed, Trial};
use std::sync::LazyLock;

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::from(on_both(
        "radiance_maps/receivers_are_in_the_picture",
        || &WITH_A_RECEIVER,
        receivers_are_in_the_picture,
        receivers_are_in_the_picture,
    ));
    trials.push(Trial::test(
        "radiance_maps/pictures_all_around_add_up/cpu",
        || pictures_all_around_add_up(|test_scene| Ok(cpu_scene(test_scene))),
    ));
    trials.push(on_gpu(
        "radiance_maps/pictures_all_around_add_up/gpu".into(),
        |context| pictures_all_around_add_up(|test_scene| gpu_scene(context, test_scene)),
    ));
    trials
}

/// Where a ball hangs under the lights of the box, and its radius in metres.
pub(crate) const BALL: Vec3 = Vec3::new(0.07, 0.11, 0.05);
pub(crate) const BALL_M: f32 = 0.25;

/// The box with these lights, a ball of a role, and these points.
pub(crate) fn with_a_ball(role: Role, lights: &[Light], points: Vec<Option<Point>>) -> TestScene {
    let plain = super::lit_box(lights, Vec::new());
    let mut scene = plain.cpu.scene().clone();
    let mut mesh = shapes::sphere(BALL_M, 12);
    mesh.positions.iter_mut().for_each(|p| *p += BALL);
    scene.objects.push(Object {
        motion: None,
        name: "ball".into(),
        role,
        mesh,
    });
    TestScene::new("ball-in-a-box", &scene, points)
}

fn under_the_spot(role: Role) -> TestScene {
    with_a_ball(role, &super::LIGHTS[1..2], inside(100))
}

static WITH_A_RECEIVER: LazyLock<TestScene> = LazyLock::new(|| under_the_spot(Role::Receiver));

/// A light shines on receivers, they are in its way and light what is around them, as all that is in the
/// picture: their role makes no difference.
fn receivers_are_in_the_picture<S: BackendScene>(loaded: &S, test_scene: &TestScene) -> Outcome {
    let without = super::lit_box(&super::LIGHTS[1..2], inside(100));
    let as_environment = under_the_spot(Role::Environment);
    for settings in [
        &[("solid_angle", "eq14")][..],
        &[("fidelity", "corrected"), ("samples_per_side", "5")],
        &[("surface", "blinn_phong"), ("mip", "true")],
    ] {
        let received = super::shaded(loaded, test_scene, settings)?;
        let plain = super::shaded(&cpu_scene(&without), &without, settings)?;
        let expected = super::shaded(&cpu_scene(&as_environment), &as_environment, settings)?;
        super::same(&expected, &received, &ROUNDING).map_err(|e| format!("{settings:?}: {e}"))?;
        let (with, without) = (super::total(&received), super::total(&plain));
        ensure!(
            (with / without - 1.0).abs() > 0.05,
            "{settings:?}: the ball makes no difference: {with} and {without}"
        );
    }
    Ok(())
}

const ROUNDING: Tolerance = Tolerance {
    absolute: 1e-6,
    relative: 3e-5,
    cause: "float32 places on a small ball, seen from near, and sums in another order",
};

/// Six pictures of 90° along the axes show what the pictures all around do; one of them shows less. An odd
/// number of texels a cell: a picture may be mirrored.
fn pictures_all_around_add_up<S: BackendScene>(
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    let around = super::lit_box(&super::OFF_EDGES[..1], inside(100));
    let pictured = |direction| {
        let Light::Point {
            position,
            intensity,
            ..
        } = super::OFF_EDGES[0]
        else {
            unreachable!("a point light");
        };
        let light = Light::Point {
            position,
            intensity,
            picture: Some(LightPicture::towards(direction, 90.0)),
        };
        super::lit_box(&[light], inside(100))
    };
    for formula in [("solid_angle", "eq14"), ("fidelity", "corrected")] {
        let settings = |pictures| [formula, ("map_resolution", "15"), ("pictures", pictures)];
        let one = |scene: &TestScene| super::shaded(&loaded(scene)?, scene, &settings("one"));
        let all = super::shaded(&loaded(&around)?, &around, &settings("surround"))?;
        let mut sum = Estimate::new(all.len());
        for axis in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z] {
            let estimate = one(&pictured(axis))?;
            for i in 0..sum.len() {
                sum.set(i, sum.get(i) + estimate.get(i));
            }
        }
        super::same(&all, &sum, &ROUNDING).map_err(|e| format!("{formula:?}: {e}"))?;
        // By itself a light looks towards the middle of the scene: through one face of a cube around it.
        let share = super::total(&one(&around)?) / super::total(&all);
        println!(
            "{formula:?}: one picture has {:.0} % of the light",
            100.0 * share
        );
        ensure!((0.02..0.5).contains(&share), "{formula:?}: {share}");
    }
    Ok(())
}
