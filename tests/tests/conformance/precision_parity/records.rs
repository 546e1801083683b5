//! What `prepare` makes on the CPU and on the device of the same captures, record by record.

use super::CAPTURED;
use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{CPU, Outcome, Variant, cpu_scene, ignored, on_gpu, switched, variants};
use interreflect_conformance::verify::parity::record_parity;
use interreflect_conformance::verify::{MethodUnderTest, TestBackend};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_gpu::GpuContext;
use libtest_mimic::Trial;
use std::sync::Arc;

/// Each method on both backends, in each fidelity and with each of its switches set otherwise.
pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    let all = variants(CAPTURED)
        .into_iter()
        .map(|v| (v, String::new()))
        .chain(
            switched(CAPTURED)
                .into_iter()
                .map(|(v, s)| (v, format!("/{s}"))),
        );
    for (variant, setting) in all {
        // Records are of captures, whatever is estimated from them: the quantity that needs most.
        let offered = variant.method.quantities();
        let most = match offered.contains(&Quantity::GlossyRadiance) {
            true => Quantity::GlossyRadiance,
            false => offered[0],
        };
        if variant.quantity != most || variant.gpu().is_err() {
            continue;
        }
        let fidelity = variant.method.fidelity().map(|f| format!(".{f}"));
        let id = variant.method.info().id;
        let name = format!(
            "precision_parity/records/{id}{}{setting}",
            fidelity.unwrap_or_default()
        );
        match TEST_SCENES.iter().find(|s| why_not(&variant, s).is_none()) {
            Some(test_scene) => {
                trials.push(on_gpu(name, move |context| {
                    compare(context, test_scene, &variant)
                }));
            }
            None => trials.push(ignored(name, "no test scene on both backends")),
        }
    }
    trials
}

/// Why a method's records can't be compared in a scene: it does not run there on both backends, or it
/// makes depth maps while it prepares, each backend its own.
fn why_not(variant: &Variant, test_scene: &TestScene) -> Option<String> {
    let facts = test_scene.cpu.scene().facts();
    let own_maps = match variant.method.needs(variant.quantity, &facts) {
        Ok(needs) => (!needs.directional_depths.is_empty()).then(|| "depth maps".to_owned()),
        Err(_) => None,
    };
    own_maps
        .or_else(|| variant.unsupported(test_scene))
        .or_else(|| variant.unsupported_on_gpu(test_scene))
}

fn compare(
    context: &Arc<GpuContext>,
    test_scene: &'static TestScene,
    variant: &Variant,
) -> Outcome {
    let of = MethodUnderTest {
        backend: TestBackend::Gpu(&CPU, context),
        method: &*variant.method,
        quantity: variant.quantity,
        cases: 1,
        seed: 1,
        case: None,
    };
    let loaded = LoadedScene::of(cpu_scene(test_scene)).with_gpu(context)?;
    let points = test_scene.points(variant.quantity.layout());
    let apart = record_parity(&of, context, &loaded, &points)?;
    println!(
        "{}: {:.2} of what it may be, {}",
        variant.name(),
        apart.of_bound,
        apart.place
    );
    ensure!(apart.cases > 0, "nothing was prepared");
    ensure!(apart.of_bound <= 1.0, "{}", apart.place);
    Ok(())
}
