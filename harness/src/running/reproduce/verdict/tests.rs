use super::*;
use Backend::{Cpu, Gpu};

fn trial(backend: Backend, a: f64, b: f64, noise: f64) -> Trial {
    Trial::less_by("this below that", backend, (a, b), noise)
}

#[test]
fn differences_within_the_noise_decide_nothing() {
    for (a, b, noise, outcome) in [
        (1.0, 2.0, 0.5, Outcome::Holds),
        (2.0, 1.0, 0.5, Outcome::Fails),
        (1.0, 1.4, 0.5, Outcome::Undecided),
        (1.4, 1.0, 0.5, Outcome::Undecided),
        (1.0, 1.0, 0.0, Outcome::Undecided),
        (f64::NAN, 1.0, 0.0, Outcome::Undecided),
        (1.0, 2.0, f64::NAN, Outcome::Undecided),
    ] {
        assert_eq!(trial(Cpu, a, b, noise).outcome, outcome, "{a} {b} {noise}");
    }
    let (a, b) = (
        Amount {
            value: 1.0,
            spread: 0.3,
        },
        Amount {
            value: 1.45,
            spread: 0.4,
        },
    );
    assert_eq!(Trial::less("", Cpu, a, b).outcome, Outcome::Undecided);
    let b = Amount { value: 1.6, ..b };
    assert_eq!(Trial::less("", Cpu, a, b).outcome, Outcome::Holds);
}

#[test]
fn verdicts_follow_from_trials() {
    let (yes, no) = (trial(Cpu, 1.0, 2.0, 0.1), trial(Gpu, 3.0, 2.0, 0.1));
    let open = trial(Cpu, 1.0, 1.0, 0.1);
    for (trials, verdict) in [
        (vec![yes.clone()], Verdict::Holds),
        (vec![no.clone()], Verdict::DoesNotHold),
        (vec![yes.clone(), no.clone()], Verdict::HoldsInPart),
        (vec![yes.clone(), open.clone()], Verdict::HoldsInPart),
        (vec![no.clone(), open.clone()], Verdict::DoesNotHold),
    ] {
        let all: Vec<&Trial> = trials.iter().collect();
        assert_eq!(conclude(&all).0, verdict, "{trials:?}");
    }
    assert_eq!(conclude(&[&open]).0, Verdict::Inconclusive);
    assert!(matches!(conclude(&[]).0, Verdict::NotRun(_)));
}

#[test]
fn the_sentence_tells_the_worst_trial_and_where_backends_differ() {
    let trials = [
        trial(Cpu, 1.0, 2.0, 0.1),
        trial(Gpu, 3.0, 2.0, 0.1),
        Trial::less_by("other", Cpu, (9.0, 1.0), 0.0),
        Trial::less_by("other", Gpu, (9.0, 1.0), 0.0),
    ];
    assert_eq!(
        conclude(&trials.each_ref()).1,
        "1 of 4 trials hold (1 of 2 on cpu, 0 of 2 on gpu); not: other on cpu, 9.00 > 1.00"
    );
    let alike = [trial(Cpu, 1.0, 2.0, 0.1), trial(Gpu, 1.0, 1.5, 0.1)];
    assert_eq!(
        conclude(&alike.each_ref()).1,
        "2 of 2 trials hold; closest: this below that on gpu, 1.00 < 1.50"
    );
}

#[test]
fn quotients_carry_their_spreads() {
    let a = Amount {
        value: 6.0,
        spread: 0.6,
    };
    let b = Amount {
        value: 2.0,
        spread: 0.0,
    };
    let q = a.over(b);
    assert!((q.value - 3.0).abs() < 1e-12 && (q.spread - 0.3).abs() < 1e-12);
    let sum = a.plus(Amount { spread: 0.8, ..b });
    assert!((sum.value - 8.0).abs() < 1e-12 && (sum.spread - 1.0).abs() < 1e-12);
    assert_eq!(Amount::exact(3.0).times(2.0), Amount::exact(6.0));
}
