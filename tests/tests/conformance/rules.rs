//! What every estimator must keep to, in two scenes of the library and in the open; `verify` tries it in
//! a box.

use crate::ensure;
use crate::test_scenes::{TEST_SCENES, TestScene};
use crate::variants::{CPU, Outcome, Variant, ignored, on_gpu, variants};
use interreflect_conformance::verify::{self, TestBackend, Verdict, rules_in};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        for test_scene in [&TEST_SCENES[1], &TEST_SCENES[2], &TEST_SCENES[4]] {
            let name = format!("rules/{}/{}", test_scene.name, variant.name());
            if let Some(why) = variant.unsupported(test_scene) {
                trials.push(ignored(name, &why));
                continue;
            }
            let one = variant.copy();
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                kept(TestBackend::Cpu(&CPU), test_scene, &one)
            }));
            let (name, one) = (format!("{name}/gpu"), variant.copy());
            trials.push(match variant.unsupported_on_gpu(test_scene) {
                Some(why) => ignored(name, &why),
                None => on_gpu(name, move |context| {
                    kept(TestBackend::Gpu(&CPU, context), test_scene, &one)
                }),
            });
        }
    }
    trials
}

fn kept(backend: TestBackend<'_>, test_scene: &TestScene, variant: &Variant) -> Outcome {
    let of = verify::MethodUnderTest {
        backend,
        method: &*variant.method,
        quantity: variant.quantity,
        cases: 1,
        seed: 1,
        case: None,
    };
    let points = test_scene.points(variant.quantity.layout());
    let mut passed = 0;
    for (rule, checked) in rules_in(&of, test_scene.cpu.scene(), &points) {
        ensure!(
            checked.verdict != Verdict::Failed,
            "{rule}: {} {:?}",
            checked.reason,
            checked.finding
        );
        passed += usize::from(checked.verdict == Verdict::Passed);
    }
    // Some rules ask nothing of a sampled method, or of a device.
    ensure!(passed >= 5, "only {passed} rules were asked");
    Ok(())
}
