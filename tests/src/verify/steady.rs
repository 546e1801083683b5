//! No resolution stands out: in the small scenes of the library, an estimate of more texels is not suddenly far
//! worse than with a few more or a few less.
//!
//! Errors go up and down with where the texels' edges happen to lie; an error of many times its neighbours'
//! means that single texels count for too much.

use super::{Asked, Finding, Found, MethodUnderTest, Nothing, OnBackend, TestBackend, VerifyError};
use crate::own_model::{ModelValues, evaluate};
use glam::Vec3;
use interreflect_cpu::path_tracer::Stop;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::BackendScene;
use interreflect_estimators::{Claim, Configured, EstimatorError, OwnModel, Quantity};
use interreflect_scene::library::{LibraryScene, library};
use interreflect_scene::{Bounds, Estimate, Point, Points, Role, SceneRequest, open};

pub(super) const NAME: &str = "steady";
pub(super) const ABOUT: &str =
    "no resolution from 1 to 64 is far worse than its neighbours, in the library's small scenes";

/// The parameter that is swept, where a method has it.
const PARAMETER: &str = "resolution";

/// Its values; a method leaves out what it does not take.
const VALUES: [u32; 24] = [
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 20, 24, 28, 32, 40, 48, 56, 64,
];

/// Neighbours on each side whose mean an error is compared with.
const NEIGHBOURS: usize = 2;

/// How many times that an error may be, on the side of the larger one: where errors fall fast, the values before
/// are as large.
const OUTLIER: f64 = 3.0;

/// Mean squared errors over the squared mean below this are all the same: 3 % rms. An edge of the scene
/// along a row of the capture, of 64 texels, moves as much of a face's light as 1/64 of it.
const FLOOR: f64 = 1e-3;

/// What reference points are moved by, in lengths of the scene: the library has some of them in the plane
/// of a surface or on an axis of symmetry, where rays through the middle of a face meet edges exactly.
const OFF_SYMMETRY: Vec3 = Vec3::new(0.0037, -0.0029, 0.0043);

/// Rays along each side of the camera's image.
const RAYS: u32 = 20;

pub(super) fn run(under_test: &MethodUnderTest<'_>) -> (Asked, Found) {
    let claims = under_test.claims();
    let asked = match claims.iter().any(|c| matches!(c, Claim::Steady)) {
        true => Asked::Claimed,
        false => Asked::Tried,
    };
    (asked, found(under_test))
}

fn found(under_test: &MethodUnderTest<'_>) -> Found {
    let methods: Vec<_> = VALUES
        .iter()
        .filter_map(|value| {
            let mut method = under_test.method.boxed_clone();
            let set = method.set(PARAMETER, &value.to_string());
            set.is_ok().then_some((*value, method))
        })
        .collect();
    if methods.len() <= NEIGHBOURS {
        return Err(Nothing::NotApplicable(format!(
            "it has no parameter {PARAMETER} to sweep"
        )));
    }
    if matches!(under_test.model(), OwnModel::LightTransport(_)) {
        let why = "its own model is path traced: noise would hide what stands out";
        return Err(Nothing::NotApplicable(why.into()));
    }
    let (mut worst, mut why) = (None, None);
    let mut cases = 0;
    for scene in library().iter().filter(|scene| scene.benched) {
        match errors(under_test, scene, &methods) {
            Ok(errors) => {
                cases += errors.len();
                // The first and the last have neighbours on one side alone.
                let inner = errors
                    .iter()
                    .enumerate()
                    .skip(1)
                    .take(errors.len().saturating_sub(2));
                for (i, &(value, error)) in inner {
                    let ratio = error.max(FLOOR) / beside(&errors, i).max(FLOOR);
                    if worst.as_ref().is_none_or(|(w, _)| ratio > *w) {
                        let place =
                            format!("{PARAMETER}={value} in {}, error {error:.5}", scene.name);
                        worst = Some((ratio, place));
                    }
                }
            }
            Err(VerifyError::Unsupported(reason)) => why = Some(reason),
            Err(error) => return Err(error.into()),
        }
    }
    match (worst, why) {
        (Some((value, place)), _) => Ok(Finding {
            value,
            bound: OUTLIER,
            cases,
            note: format!(
                "mean squared error over that of {NEIGHBOURS} neighbours on either side; worst: {place}"
            ),
            counterexample: None,
        }),
        (None, Some(why)) => Err(why.into()),
        (None, None) => Err(Nothing::NotApplicable("no scene to try it in".into())),
    }
}

/// The error at each value, over the squared mean of the own model.
fn errors(
    under_test: &MethodUnderTest<'_>,
    scene: &LibraryScene,
    methods: &[(u32, Box<dyn Configured>)],
) -> Result<Vec<(u32, f64)>, VerifyError> {
    let mut scene = open(&SceneRequest::new(scene.name)).expect("a library scene");
    scene.reference_point += OFF_SYMMETRY * Bounds::of_captured(&scene).diagonal();
    let (TestBackend::Cpu(cx) | TestBackend::Gpu(cx, _)) = under_test.backend;
    let cpu = cx.install(|| CpuScene::new(&scene))?;
    let points = Points::new(under_test.quantity.layout(), seen(&cpu));
    let estimates = under_test.backend.with(
        &scene,
        Sweep {
            methods,
            quantity: under_test.quantity,
            points: &points,
        },
    )??;
    let model = model(cx, under_test, &cpu, &points);
    let compared = methods.iter().zip(&estimates);
    Ok(compared
        .map(|((value, _), estimate)| (*value, mean_squared(estimate, &model.values)))
        .collect())
}

fn model(
    cx: &CpuCx,
    under_test: &MethodUnderTest<'_>,
    scene: &CpuScene,
    points: &Points,
) -> ModelValues {
    let (model, quantity) = (under_test.model(), under_test.quantity);
    evaluate(
        cx,
        model,
        quantity,
        scene,
        points,
        &Stop::default(),
        under_test.seed,
    )
}

/// What a grid of the camera's rays meets: receivers where there are any, else everything.
fn seen(scene: &CpuScene) -> Vec<Option<Point>> {
    let camera = scene.scene().camera;
    let only_receivers = scene.scene().objects_of(Role::Receiver).next().is_some();
    let geometry = scene.all_objects();
    let [width, height] = camera.resolution.map(|pixels| pixels as f32 / RAYS as f32);
    let at = |i: u32| {
        let (x, y) = ((i % RAYS) as f32 + 0.5, (i / RAYS) as f32 + 0.5);
        let direction = camera.ray(x * width, y * height);
        let start = geometry.ray_start();
        let hit = scene.closest(geometry, camera.eye.as_dvec3(), direction, start)?;
        let shown = !hit.material.mirror && (!only_receivers || hit.role == Role::Receiver);
        shown.then(|| hit.point(direction))
    };
    (0..RAYS * RAYS).map(at).collect()
}

struct Sweep<'a> {
    methods: &'a [(u32, Box<dyn Configured>)],
    quantity: Quantity,
    points: &'a Points,
}

impl OnBackend for Sweep<'_> {
    type Output = Result<Vec<Estimate>, EstimatorError>;

    fn run<S: BackendScene>(self, scene: &S) -> Self::Output {
        let estimate = |(_, method): &(u32, Box<dyn Configured>)| {
            let mut executor = scene.executor(&**method, self.quantity, self.points)?;
            executor.estimate()
        };
        self.methods.iter().map(estimate).collect()
    }
}

fn mean_squared(estimate: &Estimate, model: &Estimate) -> f64 {
    let (mut errors, mut sum) = (0.0, 0.0);
    for (a, b) in estimate.iter().zip(model.iter()) {
        errors += (a.as_dvec3() - b.as_dvec3()).length_squared();
        sum += b.as_dvec3().element_sum();
    }
    // Both over three channels of all points.
    let count = 3.0 * model.len().max(1) as f64;
    (errors / count) / (sum / count).powi(2).max(f64::MIN_POSITIVE)
}

/// Mean of the errors before one of them, or after it, whichever is larger.
fn beside(errors: &[(u32, f64)], i: usize) -> f64 {
    let mean = |near: &[(u32, f64)]| {
        let sum: f64 = near.iter().map(|(_, error)| error).sum();
        sum / near.len().max(1) as f64
    };
    let before = mean(&errors[i.saturating_sub(NEIGHBOURS)..i]);
    let after = mean(&errors[i + 1..(i + 1 + NEIGHBOURS).min(errors.len())]);
    before.max(after)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outlier_stands_out_from_both_sides() {
        let errors: Vec<_> = (0..).zip([0.9, 0.2, 2.0, 0.1, 0.05, 0.01]).collect();
        assert!((beside(&errors, 2) - 0.55).abs() < 1e-12);
        // Beside it, the outlier raises the mean of a side.
        assert!((beside(&errors, 1) - 1.05).abs() < 1e-12);
        let stands_out = |&i: &usize| errors[i].1 > OUTLIER * beside(&errors, i);
        assert_eq!((1..5).filter(stands_out).collect::<Vec<_>>(), [2]);
    }
}
