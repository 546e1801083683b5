//! The corrected form converges to the method's own model, in a box with shiny walls and a mirror.

use crate::ensure;
use crate::test_scenes::{TestScene, inside};
use crate::variants::{CPU, Outcome, configured, cpu_scene, run};
use glam::{DVec3, Vec3};
use interreflect_conformance::own_model::{ModelValues, evaluate};
use interreflect_cpu::path_tracer::Stop;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Light, Material};
use libtest_mimic::Trial;

pub(super) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for surface in ["lambertian", "blinn_phong"] {
        for quantity in [Quantity::Irradiance, Quantity::GlossyRadiance] {
            let name = quantity.name();
            trials.push(Trial::test(
                format!("radiance_maps/converges_to_its_model/{surface}/{name}"),
                move || converges(surface, quantity),
            ));
        }
    }
    trials
}

const NO_SAMPLES: Stop = Stop {
    samples: Some(1),
    relative_error: None,
    seconds: None,
};

/// The open box with walls that shine, its −x wall a mirror, and these lights.
fn shiny_box(lights: &[Light]) -> TestScene {
    let plain = super::lit_box(lights, inside(100));
    let mut scene = plain.cpu.scene().clone();
    for material in &mut scene.materials {
        material.albedo *= 0.6;
        material.specular = Vec3::splat(0.3);
        material.shininess = 10.0;
    }
    scene.materials[1] = Material {
        mirror: true,
        specular: Vec3::splat(0.9),
        ..Material::diffuse(Vec3::ZERO)
    };
    TestScene::new("shiny-box", &scene, inside(100))
}

/// Root mean square of a difference, relative to the model's.
fn apart(model: &Estimate, other: impl Iterator<Item = Vec3>) -> f64 {
    let squared = |v: Vec3| DVec3::from(v).length_squared();
    let differences = model.iter().zip(other).map(|(a, b)| squared(a - b));
    (differences.sum::<f64>() / model.iter().map(squared).sum::<f64>()).sqrt()
}

/// The rms error falls as samples grow: 12, 1.2, 0.2 %. The model's own patches are cut by the box's
/// edges, which is what it is sure to.
fn converges(surface: &str, quantity: Quantity) -> Outcome {
    let test_scene = shiny_box(&super::LIGHTS);
    let points = test_scene.points(quantity.layout());
    let mut errors = Vec::new();
    for n in ["4", "16", "64"] {
        let settings = [
            ("fidelity", "corrected"),
            ("pictures", "surround"),
            ("surface", surface),
            ("samples_per_side", n),
            ("map_resolution", n),
        ];
        let variant = configured("direct_radiance_map", quantity, &settings)?;
        let ModelValues { values, error, .. } = evaluate(
            &CPU,
            variant.method.model(quantity),
            quantity,
            &test_scene.cpu,
            &points,
            &NO_SAMPLES,
            0,
        );
        let sure = apart(&values, values.iter().zip(error.iter()).map(|(v, e)| v + e));
        let estimate = run(&cpu_scene(&test_scene), &variant, &points)?;
        let found = apart(&values, estimate.iter());
        println!("N = {n}: {found:.4} from the model, which is sure to {sure:.4}");
        ensure!(sure < 0.01, "the model is sure to {sure} only");
        errors.push(found);
    }
    ensure!(
        errors.is_sorted_by(|a, b| a > b) && errors[2] < 0.005,
        "errors at N = 4, 16, 64: {errors:?}"
    );
    Ok(())
}
