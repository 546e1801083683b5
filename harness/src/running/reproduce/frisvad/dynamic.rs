//! A light that moves through a large scene: frame by frame, and each frame anew.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::super::{measured_run::amount_of, pictures::Row};
use super::bleeding;
use super::bleeding::NEARER;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use crate::running::view::lambertian;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::motion::Moves;
use interreflect_scene::{Camera, Estimate, Light, PointLayout, Scene, SpotShape};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.motion",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "a light that moves through a large scene",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Every frame is complete by itself.",
            rule: "A trial is a backend: over all frames a session that goes on from frame to frame \
                estimates what a new one does, within a thousandth of the mean.",
        },
        Claim { id: "C2", ..NEARER },
    ],
};

/// Largest difference over the mean that passes for the same estimate.
const SAME: f64 = 1e-3;

/// What moves from frame to frame.
const MOVES: Moves = Moves {
    geometry: false,
    camera: false,
    lights: true,
    environment: false,
};

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let scene = large(context, &mut finding)?;
    let count = context.pick(6, 24);
    for backend in context.backends() {
        frames(context, &scene, (backend, count), &mut finding)?;
    }
    let loaded = context.set_up(&moved(&scene, 0.5))?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let references = context.references(&loaded, Quantity::Irradiance, &points);
    let what = ("C2", "middle of the sequence", &view, references);
    bleeding::compare(context, &loaded, what, &mut finding)?;
    Ok(finding)
}

fn frames(
    context: &ExperimentContext<'_>,
    scene: &Scene,
    (backend, count): (Backend, u32),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let quantity = Quantity::Irradiance;
    let map = context.method("direct_radiance_map", &[])?;
    let (mut running, mut worst, mut times) = (Sequence::default(), 0.0_f64, Vec::new());
    let mut row = Row::plain(format!("frames of the sequence, {backend}"));
    for index in 0..count {
        let t = f64::from(index) / f64::from(count - 1);
        let loaded = context.set_up(&moved(scene, t as f32))?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let seen = (&points, view.visible(), MOVES);
        let on = context.frame(&loaded, (&mut running, backend), &*map, quantity, seen)?;
        let anew = context.frame(
            &loaded,
            (&mut Sequence::default(), backend),
            &*map,
            quantity,
            seen,
        )?;
        worst = worst.max(difference(&on.estimate, &anew.estimate));
        if index > 0 {
            times.push(on.ms);
        }
        if index % count.div_ceil(4) == 0 {
            let direct = context.direct_light(&loaded, backend, &view)?;
            let materials = view.points(PointLayout::Material);
            let reflected = lambertian(&materials, &on.estimate);
            row.add(format!("frame {index}"), view.lit(&reflected, &direct));
        }
    }
    let triangles = scene
        .objects
        .iter()
        .map(|o| o.mesh.triangles.len())
        .sum::<usize>();
    finding.measure(
        ("sequence", "triangles"),
        backend,
        Amount::exact(triangles as f64),
        "",
    );
    finding.measure(
        ("sequence", "largest difference / mean"),
        backend,
        Amount::exact(worst),
        "",
    );
    let unit = ("ms", context.software(backend));
    finding.time(("sequence", "frame"), backend, amount_of(&times), unit);
    finding.judge("C1", [same(backend, worst)]);
    finding.pictures.push(row);
    Ok(())
}

/// The largest difference of two estimates over the mean of the second.
fn difference(a: &Estimate, b: &Estimate) -> f64 {
    let pairs = || a.iter().zip(b.iter());
    let difference = pairs()
        .map(|(a, b)| (a - b).abs().max_element())
        .fold(0.0, f32::max);
    let mean = pairs().map(|(_, b)| b.element_sum()).sum::<f32>() / (3 * b.len()) as f32;
    f64::from(difference / mean)
}

/// That a session which goes on estimates what a new one does.
fn same(backend: Backend, worst: f64) -> Trial {
    let what = "sequence: largest difference from a new session, over the mean";
    Trial::less_by(what, backend, (worst, SAME), 0.0)
}

/// Sponza with a camera in its nave, or the cave in its place.
fn large(context: &ExperimentContext<'_>, finding: &mut Finding) -> Result<Scene, RunError> {
    let Some(path) = context.assets().scene("sponza_34k") else {
        finding.note("sponza_34k.obj not found: the cave in its place");
        return context.scene(&ExperimentScene::of("cave"), finding);
    };
    let mut scene = context.scene(&ExperimentScene::of(path.to_string_lossy()), finding)?;
    let bounds = scene.objects.iter().filter_map(|o| o.mesh.bounds());
    let (low, high) = bounds
        .reduce(|(a, b), (c, d)| (a.min(c), b.max(d)))
        .unwrap_or_default();
    let (middle, extent) = (0.5 * (low + high), high - low);
    let at = |x: f32, y: f32, z: f32| {
        Vec3::new(
            middle.x + x * extent.x,
            low.y + y * extent.y,
            middle.z + z * extent.z,
        )
    };
    scene.camera = Camera {
        eye: at(-0.33, 0.12, 0.0),
        target: at(0.4, 0.17, 0.0),
        up: Vec3::Y,
        vfov_deg: 60.0,
        resolution: [640, 480],
    };
    scene.lights = vec![Light::Spot {
        position: at(-0.1, 0.25, 0.0),
        direction: Vec3::X,
        up: Vec3::Y,
        shape: SpotShape::Square,
        angle_deg: 100.0,
        intensity: Vec3::new(1.0, 0.9, 0.75) * extent.x * extent.x,
    }];
    Ok(scene)
}

/// The scene with its first light turned about +y, from t = 0 to 1, by 150° and carried along.
fn moved(scene: &Scene, t: f32) -> Scene {
    let mut scene = scene.clone();
    let turn = glam::Quat::from_rotation_y((75.0 - 150.0 * t).to_radians());
    if let Some(Light::Spot { direction, up, .. }) = scene.lights.first_mut() {
        (*direction, *up) = (turn * *direction, turn * *up);
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{of, signs};
    use super::*;

    #[test]
    fn a_session_that_goes_on_differs_by_less_than_a_thousandth() {
        let signs = |worst| signs([&same(Backend::Cpu, worst)]);
        assert_eq!((signs(0.9e-3), signs(1.1e-3)), ("+".into(), "-".into()));
        let (a, b) = (of(&[1.0, 2.0, 3.0]), of(&[1.0, 2.5, 2.5]));
        assert!((difference(&a, &b) - 0.25).abs() < 1e-6);
    }

    /// From 75° to −75° about +y: +x turns to −z at first.
    #[test]
    fn the_light_turns_by_150_degrees() {
        let mut scene = interreflect_scene::open(&interreflect_scene::SceneRequest::new("cave"))
            .expect("a built-in scene");
        scene.lights = vec![Light::Spot {
            position: Vec3::ZERO,
            direction: Vec3::X,
            up: Vec3::Y,
            shape: SpotShape::Square,
            angle_deg: 90.0,
            intensity: Vec3::ONE,
        }];
        let towards = |t: f32| match moved(&scene, t).lights[0] {
            Light::Spot { direction, .. } => direction,
            _ => Vec3::ZERO,
        };
        let (sin, cos) = 75_f32.to_radians().sin_cos();
        assert!(towards(0.0).distance(Vec3::new(cos, 0.0, -sin)) < 1e-6);
        assert!(towards(0.5).distance(Vec3::X) < 1e-6);
        assert!(towards(1.0).distance(Vec3::new(cos, 0.0, sin)) < 1e-6);
    }
}
