//! A single object that moves rigidly keeps its visibility (P5, §6): no depth map is rendered, and the
//! estimate is, up to what the directions resolve, that of an evaluation from nothing.

use super::{AO, VERTICES, evaluations_of, small, studio};
use crate::ensure;
use crate::test_scenes::{TestScene, same_bits};
use crate::variants::{CPU, Outcome, Variant, configured, cpu_scene, gpu_scene, on_gpu};
use glam::{Quat, Vec3};
use interreflect::frames::{Frame, Frames};
use interreflect::view::View;
use interreflect_cpu::scene::CpuScene;
use interreflect_estimators::directional_ao::DIRECTIONS;
use interreflect_estimators::execution::{BackendScene, Executor, Suspended};
use interreflect_estimators::{Changed, Quantity};
use interreflect_scene::motion::{Deformation, DeformationKind, Pose, Track};
use interreflect_scene::{Estimate, Motion, PointLayout, Points, Scene};
use libtest_mimic::{Failed, Trial};
use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

const LEVEL: usize = 2;

pub(super) fn trials() -> Vec<Trial> {
    let name = "visibility/rigid_motion";
    let mut trials = vec![
        Trial::test(format!("{name}/cpu"), || rigid_motion(|s| Ok(cpu_scene(s)))),
        on_gpu(format!("{name}/gpu"), |context| {
            rigid_motion(|s| gpu_scene(context, s))
        }),
    ];
    for (what, set_in_motion) in OTHERS {
        let name = format!("visibility/computed_anew/{what}");
        trials.extend([
            Trial::test(format!("{name}/cpu"), move || {
                computed_anew(set_in_motion, |s| Ok(cpu_scene(s)))
            }),
            on_gpu(format!("{name}/gpu"), move |context| {
                computed_anew(set_in_motion, |s| gpu_scene(context, s))
            }),
        ]);
    }
    trials
}

/// At rest, moved, a quarter turned, and turned by some angle about some axis, a second each.
fn poses() -> Track<Pose> {
    let some_axis = Vec3::new(0.48, 0.6, 0.64);
    let turns = [
        Quat::IDENTITY,
        Quat::IDENTITY,
        Quat::from_rotation_y(FRAC_PI_2),
        Quat::from_axis_angle(some_axis, 0.7),
    ];
    let pose = |(i, rotate)| {
        let i: u8 = i;
        let translate = Vec3::new(0.3, -0.2, 0.1) * f32::from(i);
        let pose = Pose {
            translate,
            rotate,
            ..Pose::REST
        };
        (f32::from(i), pose)
    };
    Track {
        keys: (0..).zip(turns).map(pose).collect(),
    }
}

fn rigidly(scene: &mut Scene) {
    scene.objects[0].motion = Some(Motion {
        poses: poses(),
        ..Motion::default()
    });
}

type SetInMotion = fn(&mut Scene);

/// Motions that change what occludes what.
const OTHERS: [(&str, SetInMotion); 2] = [
    ("deforming", |scene| {
        rigidly(scene);
        let motion = scene.objects[0].motion.as_mut();
        motion.expect("it moves").deformation = Some(Deformation {
            // At whole seconds it would be at rest.
            period_s: 3.7,
            ..Deformation::new(DeformationKind::Wave)
        });
    }),
    ("two_objects", |scene| {
        let mut other = scene.objects[0].clone();
        let aside = Vec3::X * 1.2;
        other.mesh.positions.iter_mut().for_each(|p| *p += aside);
        rigidly(scene);
        scene.objects.push(other);
    }),
];

/// A frame of a moving scene, shaded at the vertices.
struct Moment {
    scene: Scene,
    test_scene: TestScene,
    view: View,
    points: Points,
}

/// The studio, its object set in motion, at 0 s, 1 s, 2 s and 3 s.
fn moments(set_in_motion: SetInMotion, layout: PointLayout) -> Result<Vec<Moment>, Failed> {
    let mut rest = studio().cpu.scene().clone();
    set_in_motion(&mut rest);
    let moment = |time_s| {
        let scene = rest.at(time_s);
        let test_scene = studio().with_scene(Arc::new(CpuScene::new(&scene)?));
        let view = CPU.install(|| View::new(&test_scene.cpu, &small(scene.camera), VERTICES))?;
        let points = view.points(layout);
        Ok(Moment {
            scene,
            test_scene,
            view,
            points,
        })
    };
    [0.0, 1.0, 2.0, 3.0].into_iter().map(moment).collect()
}

/// What a frame of a session gave.
struct Shown {
    estimate: Estimate,
    /// Points evaluated so far.
    evaluations: u64,
    /// Whether depth maps were asked for.
    looked: bool,
}

/// A session over all moments: it is told of rigid motion, or not.
fn session<S: BackendScene>(
    variant: &Variant,
    moments: &[Moment],
    told: bool,
    loaded: &impl Fn(&TestScene) -> Result<S, Failed>,
) -> Result<Vec<Shown>, Failed> {
    let (method, quantity) = (&*variant.method, variant.quantity);
    let mut last: Option<Suspended<S::Backend>> = None;
    let mut shown = Vec::new();
    for moment in moments {
        let scene = loaded(&moment.test_scene)?;
        let points = &moment.points;
        let (mut executor, changed) = match last.take() {
            None => (variant.executor(&scene, points)?, Changed::ALL),
            Some(session) => (
                Executor::resume(&scene, method, quantity, points, session.without_captures())?,
                Changed::SCENE | Changed::POINTS,
            ),
        };
        executor.set_visible(moment.view.visible());
        executor.set_rigid_rotation(moment.scene.rigid_rotation().filter(|_| told));
        executor.prepare(changed)?;
        executor.shade()?;
        shown.push(Shown {
            estimate: executor.read_back()?.0,
            evaluations: evaluations_of(&executor.records()?)?,
            looked: executor.unread().directional_depths.is_empty(),
        });
        last = Some(executor.suspend());
    }
    Ok(shown)
}

/// Root mean square of a quantity's differences, over its root mean square.
fn difference(a: &Estimate, b: &Estimate) -> f64 {
    let square = |v: Vec3| f64::from(v.length_squared());
    let differences: f64 = a.iter().zip(b.iter()).map(|(a, b)| square(a - b)).sum();
    (differences / b.iter().map(square).sum::<f64>()).sqrt()
}

/// Openness and irradiance of an object that moves, turns by a symmetry of the octahedron, and turns by
/// some angle, beside evaluations from nothing.
///
/// Causes of the bounds. An answer counts 4/k times its cosine, whose mean square is ⅓. Moved: places
/// differ by rounding, so that a point at the border of a texel falls into the next, a thousandth of
/// the k/2 answers of a hemisphere. Turned by a quarter: the same directions, but the texels of their
/// maps lie otherwise, and one answer of a hundred differs (`visibility/ways_agree`). Turned by some
/// angle: other directions. The border between open and occluded cuts ½√(πk) cells, each wrong like a
/// number cut evenly, its square 1/12 (as in `openness/closed_forms`), once kept and once anew.
fn rigid_motion<S: BackendScene>(loaded: impl Fn(&TestScene) -> Result<S, Failed>) -> Outcome {
    let k = f64::from(DIRECTIONS[LEVEL]);
    let wrong = |answers: f64| (4.0 / k) * (answers / 3.0).sqrt();
    let border = 0.5 * (std::f64::consts::PI * k).sqrt() / 12.0;
    let bounds = [
        0.0,
        wrong(1e-3 * 0.5 * k),
        wrong(1e-2 * 0.5 * k),
        wrong(2.0 * border),
    ];
    let level = LEVEL.to_string();
    let settings = [
        ("level", &*level),
        ("map_resolution", "256"),
        ("fidelity", "corrected"),
    ];
    for quantity in [AO, Quantity::Irradiance] {
        let variant = configured("directional_ao", quantity, &settings)?;
        let moments = moments(rigidly, quantity.layout())?;
        let kept = session(&variant, &moments, true, &loaded)?;
        let anew = session(&variant, &moments, false, &loaded)?;
        let mut frames = Frames::<S::Backend>::default();
        let count = moments[0].points.len() as u64;
        let pairs = kept.iter().zip(&anew).zip(&moments);
        for (i, (((kept, anew), moment), bound)) in pairs.zip(bounds).enumerate() {
            let [told, untold] = [kept, anew].map(|shown| (shown.looked, shown.evaluations));
            ensure!(
                told == (i == 0, count) && untold == (true, (i as u64 + 1) * count),
                "at {i} s: depth maps read and points evaluated: {told:?} where kept, {untold:?} anew"
            );
            let apart = difference(&kept.estimate, &anew.estimate);
            println!(
                "{} at {i} s: {apart:.2e} apart, bound {bound:.2e}",
                quantity.name()
            );
            ensure!(
                apart <= bound,
                "at {i} s: {apart:.2e} apart, bound {bound:.2e}"
            );
            let frame = Frame {
                scene: &moment.scene,
                moves: moment.scene.moves(),
                points: &moment.points,
                visible: moment.view.visible(),
            };
            let scene = loaded(&moment.test_scene)?;
            let shaded = frames.next(&scene, &*variant.method, quantity, &frame)?;
            same_bits(&kept.estimate, shaded.estimate.iter())
                .map_err(|e| format!("a sequence of frames at {i} s: {e}"))?;
        }
        ensure!(
            kept[3].estimate != anew[3].estimate,
            "the directions do not turn with the object"
        );
    }
    Ok(())
}

/// Where an object deforms, or another stands beside it, each frame is what a session of its own gives,
/// and all of its points are evaluated.
fn computed_anew<S: BackendScene>(
    set_in_motion: SetInMotion,
    loaded: impl Fn(&TestScene) -> Result<S, Failed>,
) -> Outcome {
    let settings = [("level", "1"), ("map_resolution", "128")];
    let variant = configured("directional_ao", AO, &settings)?;
    let moments = moments(set_in_motion, AO.layout())?;
    let living = session(&variant, &moments, true, &loaded)?;
    for (i, (living, moment)) in living.iter().zip(&moments).enumerate() {
        let own = session(&variant, std::slice::from_ref(moment), true, &loaded)?;
        same_bits(&own[0].estimate, living.estimate.iter())
            .map_err(|e| format!("at {i} s: {e}"))?;
        let all = (i + 1) * moment.points.len();
        ensure!(
            living.looked && living.evaluations == all as u64,
            "at {i} s: {} of {all} evaluations",
            living.evaluations
        );
    }
    Ok(())
}
