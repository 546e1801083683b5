//! What every estimator must keep to, in two scenes of the library and in the open; `verify` tries it in
//! a box.

use crate::ensure;
use crate::subjects::{SUBJECTS, Subject};
use crate::world::{CPU, Outcome, Variant, ignored, on_gpu, variants};
use interreflect_conformance::verify::{self, TestBackend, Verdict, rules_in};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(32) {
        for subject in [&SUBJECTS[1], &SUBJECTS[2], &SUBJECTS[4]] {
            let name = format!("rules/{}/{}", subject.name, variant.name());
            if let Some(why) = variant.unsupported(subject) {
                trials.push(ignored(name, &why));
                continue;
            }
            let one = variant.copy();
            trials.push(Trial::test(format!("{name}/cpu"), move || {
                kept(TestBackend::Cpu(&CPU), subject, &one)
            }));
            let (name, one) = (format!("{name}/gpu"), variant.copy());
            trials.push(match variant.unsupported_on_gpu(subject) {
                Some(why) => ignored(name, &why),
                None => on_gpu(name, move |context| {
                    kept(TestBackend::Gpu(&CPU, context), subject, &one)
                }),
            });
        }
    }
    trials
}

fn kept(backend: TestBackend<'_>, subject: &Subject, variant: &Variant) -> Outcome {
    let of = verify::MethodUnderTest {
        backend,
        method: &*variant.method,
        quantity: variant.quantity,
        cases: 1,
        seed: 1,
        case: None,
    };
    let points = subject.points(variant.quantity.layout());
    let mut passed = 0;
    for (rule, checked) in rules_in(&of, subject.cpu.scene(), &points) {
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
