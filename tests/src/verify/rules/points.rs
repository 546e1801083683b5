//! What points and channels have to do with each other: nothing.

use super::{Broken, Outcome, Rule, Where, same_bits};
use crate::verify::{BoxScene, Lighting, MethodUnderTest, Nothing, TestBackend};
use glam::Vec3;
use interreflect_cpu::tiles::{Arithmetic, CpuCx, InstructionSet};
use interreflect_estimators::Quantity;
use interreflect_scene::params::Choice;
use interreflect_scene::{Estimate, Point, Points, Scene};

pub(super) fn all() -> [Rule; 6] {
    let in_scene = |name, about, broken| Rule {
        name,
        about,
        broken: Where::Scene(broken),
    };
    let in_box_scene = |name, about, broken| Rule {
        name,
        about,
        broken: Where::BoxScene(broken),
    };
    [
        in_scene(
            "point_order",
            "reversed points get reversed estimates, bit by bit",
            point_order,
        ),
        in_scene(
            "points_alone",
            "fewer points get the same estimates, bit by bit",
            points_alone,
        ),
        in_scene(
            "no_surface",
            "points without a surface get zero",
            no_surface,
        ),
        in_scene(
            "threads_and_instructions",
            "the same bits on any number of threads, any instruction set, and one point at a time",
            threads_and_instructions,
        ),
        in_box_scene(
            "channels",
            "colour channels do not affect each other",
            channels,
        ),
        in_box_scene("dark", "a scene without light gives zero", dark),
    ]
}

fn compare(broken: &mut Broken, a: &Estimate, b: impl Iterator<Item = Vec3>, what: &str) {
    for (i, (a, b)) in a.iter().zip(b).enumerate() {
        broken.case(same_bits(a, b), || {
            format!("{what}: point {i} has {a} and {b}")
        });
    }
}

fn point_order(under_test: &MethodUnderTest<'_>, scene: &Scene, points: &Points) -> Outcome {
    let needs = under_test
        .method
        .needs(under_test.quantity, &scene.facts())?;
    if needs.light_transport {
        let why = "samples of light transport are drawn by a point's place in the list";
        return Err(Nothing::NotApplicable(why.into()));
    }
    let mut reversed: Vec<Option<Point>> = points.iter().collect();
    reversed.reverse();
    let lists = [points.clone(), Points::new(points.layout(), reversed)];
    let estimates = under_test.estimates(scene, &lists)?;
    let mut backward: Vec<Vec3> = estimates[1].iter().collect();
    backward.reverse();
    let mut broken = Broken::default();
    compare(&mut broken, &estimates[0], backward.into_iter(), "reversed");
    Ok(broken)
}

/// Shorter lists, which end within a group of lanes, at its end and behind it.
fn points_alone(under_test: &MethodUnderTest<'_>, scene: &Scene, points: &Points) -> Outcome {
    let counts = [points.len(), 1, 17, 63, 64, 65, 129];
    let first = |count| Points::new(points.layout(), points.iter().take(count));
    let lists = counts.map(first);
    let estimates = under_test.estimates(scene, &lists)?;
    let mut broken = Broken::default();
    for fewer in &estimates[1..] {
        let what = format!("{} points", fewer.len());
        compare(&mut broken, &estimates[0], fewer.iter(), &what);
    }
    Ok(broken)
}

fn no_surface(under_test: &MethodUnderTest<'_>, scene: &Scene, points: &Points) -> Outcome {
    let some = points.iter().enumerate();
    let some = some.map(|(i, p)| p.filter(|_| i % 7 != 3));
    let holed = Points::new(points.layout(), some);
    let estimates = under_test.estimates(scene, &[holed])?;
    let mut broken = Broken::default();
    for (i, value) in estimates[0].iter().enumerate() {
        let holds = i % 7 != 3 || value == Vec3::ZERO;
        broken.case(holds, || {
            format!("point {i} has no surface and gets {value}")
        });
    }
    Ok(broken)
}

fn threads_and_instructions(
    under_test: &MethodUnderTest<'_>,
    scene: &Scene,
    points: &Points,
) -> Outcome {
    if matches!(under_test.backend, TestBackend::Gpu(..)) {
        return Err(Nothing::NotApplicable(
            "GPUs have neither threads nor instruction sets to vary".into(),
        ));
    }
    let lists = std::slice::from_ref(points);
    let first = under_test.estimates(scene, lists)?;
    let mut broken = Broken::default();
    let available = InstructionSet::all().into_iter();
    for (name, set) in available.filter(|(_, s)| s.available()) {
        for threads in [1, 2] {
            let cx = CpuCx::new(Some(threads), Some(set));
            let cx = cx.map_err(|e| Nothing::NotApplicable(e.to_string()))?;
            let of = MethodUnderTest {
                backend: TestBackend::Cpu(&cx),
                case: None,
                ..*under_test
            };
            let again = of.estimates(scene, lists)?;
            let what = format!("{threads} threads, {name}");
            compare(&mut broken, &first[0], again[0].iter(), &what);
        }
    }
    if let TestBackend::Cpu(cx) = under_test.backend {
        let scalar = cx.with_arithmetic(Arithmetic::Scalar);
        let of = MethodUnderTest {
            backend: TestBackend::Cpu(&scalar),
            case: None,
            ..*under_test
        };
        let again = of.estimates(scene, lists)?;
        compare(&mut broken, &first[0], again[0].iter(), "one at a time");
    }
    Ok(broken)
}

/// Walls of three colours against three runs with grey ones.
fn channels(under_test: &MethodUnderTest<'_>, mut box_scene: BoxScene) -> Outcome {
    if box_scene.lighting == Lighting::Sky {
        return Err(Nothing::NotApplicable("its walls have no colour".into()));
    }
    let grey = box_scene.walls.map(|w| w.x);
    let colours = [0, 1, 2].map(|c| {
        let mut walls = grey;
        walls.rotate_left(c);
        walls
    });
    let alone = colours.map(|walls| {
        under_test.estimate(&BoxScene {
            walls: walls.map(Vec3::splat),
            ..box_scene.clone()
        })
    });
    let [r, g, b] = alone;
    let (r, g, b) = (r?, g?, b?);
    let wall = |i: usize| Vec3::from(colours.map(|walls| walls[i]));
    box_scene.walls = std::array::from_fn(wall);
    let coloured = under_test.estimate(&box_scene)?;
    let mut broken = Broken::default();
    for (i, value) in coloured.iter().enumerate() {
        let grey = Vec3::new(r.get(i).x, g.get(i).y, b.get(i).z);
        // Sampling may follow the brightest channel: the same up to rounding, not bit by bit.
        let near = (value - grey).abs().max_element() <= 1e-5 * value.max_element().max(1e-3);
        broken.case(near, || format!("point {i} has {value}, alone {grey}"));
    }
    Ok(broken)
}

fn dark(under_test: &MethodUnderTest<'_>, box_scene: BoxScene) -> Outcome {
    if under_test.quantity == Quantity::AmbientOcclusion {
        return Err(Nothing::NotApplicable(
            "openness does not depend on light".into(),
        ));
    }
    let mut scene = box_scene.scene();
    for material in &mut scene.materials {
        (material.emission, material.albedo) = (Vec3::ZERO, Vec3::ZERO);
    }
    if let Some(environment) = &mut scene.environment {
        environment.scale = 0.0;
    }
    let estimates =
        under_test.estimates(&scene, &[box_scene.placed_points(under_test.quantity)])?;
    let mut broken = Broken::default();
    for (i, value) in estimates[0].iter().enumerate() {
        broken.case(value == Vec3::ZERO, || format!("point {i} gets {value}"));
    }
    Ok(broken)
}
