//! What a point gets does not depend on which other points are shaded with it: not on the lobes that their
//! materials bring, nor on their number. Methods keep a table or a filtered map for each exponent of a
//! list; a point that takes its neighbour's shows here, on either backend.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{
    Outcome, Variant, configured, cpu_scene, gpu_scene, ignored, on_gpu, run, variants,
};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::BackendScene;
use interreflect_scene::{Points, SurfaceMaterial};
use libtest_mimic::Trial;
use std::sync::Arc;

/// Exponents of every third point, in no order; far apart, so that one's lobe is not the other's.
const EXPONENTS: [f32; 3] = [40.0, 3.0, 220.0];

pub(crate) fn trials() -> Vec<Trial> {
    let glossy = variants(32).into_iter();
    let mut all: Vec<(Variant, &str)> = glossy
        .filter(|v| v.quantity == Quantity::GlossyRadiance)
        .map(|v| (v, ""))
        .collect();
    for fidelity in ["published", "corrected"] {
        let settings = [
            ("fidelity", fidelity),
            ("reflectivity", "table"),
            ("capture_resolution", "32"),
        ];
        let tables = configured("localized_cubemap", Quantity::GlossyRadiance, &settings);
        all.push((tables.expect("settings of the method"), ".table"));
    }
    let mut trials = Vec::new();
    for (variant, suffix) in all {
        let name = format!("neighbours/{}{suffix}", variant.name());
        let test_scene: &TestScene = match variant.unsupported(&TEST_SCENES[0]) {
            None => &TEST_SCENES[0],
            Some(_) => &TEST_SCENES[2],
        };
        if let Some(why) = variant.unsupported(test_scene) {
            trials.push(ignored(name, &why));
            continue;
        }
        let variant = Arc::new(variant);
        let one = variant.clone();
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            alone(&cpu_scene(test_scene), test_scene, &one)
        }));
        if variant.runs_in(test_scene) {
            trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                alone(&gpu_scene(context, test_scene)?, test_scene, &variant)
            }));
        }
    }
    trials
}

/// Points of three exponents together, then those of each one alone, in their places in the list.
fn alone<S: BackendScene>(loaded: &S, test_scene: &TestScene, variant: &Variant) -> Outcome {
    let original = test_scene.points(variant.quantity.layout());
    let with = |kept: Option<usize>| {
        let points = original.iter().enumerate().map(|(i, point)| {
            let of = i % EXPONENTS.len();
            let point = point.filter(|_| kept.is_none_or(|kept| kept == of))?;
            Some(interreflect_scene::Point {
                material: SurfaceMaterial {
                    shininess: EXPONENTS[of],
                    ..point.material
                },
                ..point
            })
        });
        Points::new(original.layout(), points)
    };
    let together = run(loaded, variant, &with(None))?;
    let mut differ = false;
    for (kept, exponent) in EXPONENTS.iter().enumerate() {
        let points = with(Some(kept));
        let alone = run(loaded, variant, &points)?;
        for (i, point) in points.iter().enumerate() {
            let bits = |v: glam::Vec3| v.to_array().map(f32::to_bits);
            let (a, b) = (alone.get(i), together.get(i));
            ensure!(
                point.is_none() || bits(a) == bits(b),
                "point {i} of exponent {exponent} has {a} alone and {b} in company"
            );
            differ |= point.is_some() && a != glam::Vec3::ZERO;
        }
    }
    ensure!(differ, "all is black");
    Ok(())
}
