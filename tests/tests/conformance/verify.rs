//! Every check, on every method, fidelity, quantity and backend: what `verify` runs.

use crate::ensure;
use crate::variants::{CPU, Outcome, Variant, ignored, on_gpu, variants};
use interreflect_conformance::verify::{MethodUnderTest, TestBackend, Verdict, checks};
use interreflect_estimators::Claim;
use libtest_mimic::Trial;

/// Random box scenes for each claim: the command tries twice as many.
const CASES: u32 = 4;

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = Vec::new();
    for variant in variants(64) {
        let name = format!("verify/{}", variant.name());
        let one = variant.copy();
        trials.push(Trial::test(format!("{name}/cpu"), move || {
            checked(TestBackend::Cpu(&CPU), &one)
        }));
        let name = format!("{name}/gpu");
        trials.push(match variant.gpu() {
            Err(why) => ignored(name, why),
            Ok(()) => on_gpu(name, move |context| {
                checked(TestBackend::Gpu(&CPU, context), &variant)
            }),
        });
    }
    trials.push(Trial::test("verify/different_checks", different_checks));
    trials
}

fn checked(backend: TestBackend<'_>, variant: &Variant) -> Outcome {
    let under_test = MethodUnderTest {
        backend,
        method: &*variant.method,
        quantity: variant.quantity,
        cases: CASES,
        seed: 1,
        case: None,
    };
    let mut passed = Vec::new();
    for check in checks() {
        let checked = check.run(&under_test);
        let name = check.name;
        println!(
            "{name}: {} {:?} {}",
            checked.verdict.name(),
            checked.finding,
            checked.reason
        );
        ensure!(
            checked.verdict != Verdict::Failed,
            "{name}: {} {:?}",
            checked.reason,
            checked.finding
        );
        if checked.verdict == Verdict::Passed {
            passed.push(name);
        }
    }
    // A claim that no check asks about is no claim: each must have been tried, those of kernels on
    // the host.
    let claims = under_test.claims();
    let asked = claims
        .iter()
        .filter(|claim| !matches!(claim, Claim::FormFactor { .. }) || backend.name() == "cpu");
    for claim in asked {
        let tried = checks().any(|check| check.asks(claim) && passed.contains(&check.name));
        ensure!(tried, "no check asked about {claim:?}");
    }
    Ok(())
}

/// Names are said once, and there are as many as the project promises.
fn different_checks() -> Outcome {
    let mut names: Vec<_> = checks().map(|check| check.name).collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    ensure!(names.len() == count, "two checks have one name");
    ensure!(count >= 30, "{count} checks");
    Ok(())
}
