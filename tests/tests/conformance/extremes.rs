//! Where numbers are extreme: finite and inside the claimed bound, or an error that names the input.

use crate::ensure;
use crate::variants::{CPU, Outcome, Variant, ignored, on_gpu, variants};
use interreflect_conformance::verify::{Extreme, MethodUnderTest, TestBackend, Verdict, extremes};
use libtest_mimic::Trial;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(64) {
        let name = format!("extremes/{}", variant.name());
        let one = variant.copy();
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            survives(TestBackend::Cpu(&CPU), &one)
        }));
        let name = format!("{name}/gpu");
        trials.push(match variant.gpu() {
            Err(why) => ignored(name, why),
            Ok(()) => on_gpu(name, move |context| {
                survives(TestBackend::Gpu(&CPU, context), &variant)
            }),
        });
    }
    trials
}

fn survives(backend: TestBackend<'_>, variant: &Variant) -> Outcome {
    let found = extremes(&MethodUnderTest {
        backend,
        method: &*variant.method,
        quantity: variant.quantity,
        cases: 1,
        seed: 1,
        case: None,
    });
    for extreme in &found {
        ensure!(extreme.verdict != Verdict::Failed, "{extreme:?}");
    }
    // Most axes touch every method, and what is no number is refused.
    let count = |holds: fn(&Extreme) -> bool| found.iter().filter(|e| holds(e)).count();
    let finite = count(|e| e.largest.is_some());
    let refused = count(|e| e.verdict == Verdict::Passed && e.largest.is_none());
    ensure!(finite >= 25, "only {finite} places had an estimate");
    ensure!(refused >= 9, "only {refused} inputs were refused");
    Ok(())
}
