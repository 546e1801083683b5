use super::*;

fn sweep() -> Vec<Run> {
    let resolution = |ms, error, r| with(run("maps", ms, error), "resolution", ParamValue::U32(r));
    let fine = with(resolution(4.0, 0.10, 8), "clamp", ParamValue::F32(0.5));
    let rough = with(resolution(1.0, 0.30, 2), "clamp", ParamValue::F32(0.5));
    vec![rough, fine, run("constant", 0.5, 0.5)]
}

fn ask(runs: &[Run], ms: Option<f64>, max_error: Option<f64>) -> Answer {
    let budget = Budget {
        ms,
        max_error,
        ..Budget::default()
    };
    let mut advice = advise(runs, budget);
    assert_eq!(advice.len(), 1);
    advice.remove(0).answer
}

/// Index of the chosen run, and of those like it.
fn chosen(answer: Answer) -> (usize, Vec<usize>) {
    match answer {
        Answer::Use { choice, alike, .. } => (choice.run, alike.iter().map(|c| c.run).collect()),
        Answer::Nothing { .. } => panic!("{answer:?}"),
    }
}

fn misses(answer: Answer) -> (usize, usize) {
    match answer {
        Answer::Nothing { by_time, by_error } => (by_time.run, by_error.run),
        Answer::Use { .. } => panic!("{answer:?}"),
    }
}

#[test]
fn a_time_gets_the_most_accurate_and_an_error_the_fastest() {
    let runs = sweep();
    assert_eq!(chosen(ask(&runs, Some(2.0), None)), (0, vec![]));
    assert_eq!(chosen(ask(&runs, Some(1.0), None)), (0, vec![]));
    assert_eq!(chosen(ask(&runs, None, Some(0.4))), (0, vec![]));
    assert_eq!(chosen(ask(&runs, None, Some(0.9))), (2, vec![]));
    assert_eq!(chosen(ask(&runs, Some(5.0), Some(0.4))), (1, vec![]));
    assert_eq!(chosen(ask(&runs, None, None)), (1, vec![]));
}

#[test]
fn where_nothing_does_the_nearest_misses_are_named() {
    let runs = sweep();
    // Within 2 ms the rough map is the best; up to .2 the fine one is the fastest.
    assert_eq!(misses(ask(&runs, Some(2.0), Some(0.2))), (0, 1));
    assert_eq!(misses(ask(&runs, Some(0.1), None)), (2, 2));
    assert_eq!(misses(ask(&runs, None, Some(0.01))), (1, 1));
    // Neither limit is met by anything: the fastest, and the most accurate.
    assert_eq!(misses(ask(&runs, Some(0.1), Some(0.01))), (2, 1));
}

#[test]
fn alternatives_inside_the_noise_are_named_and_near_limits_are_not_sure() {
    let runs = [
        noisy("a", (1.0, 0.2), (0.100, 0.01)),
        noisy("b", (1.1, 0.2), (0.115, 0.01)),
        noisy("c", (2.0, 0.2), (0.105, 0.01)),
        noisy("d", (1.0, 0.2), (0.200, 0.01)),
    ];
    assert_eq!(chosen(ask(&runs, Some(1.5), None)), (0, vec![1]));
    assert_eq!(chosen(ask(&runs, None, Some(0.15))), (0, vec![1]));
    let sure = |ms, error| match ask(&runs, ms, error) {
        Answer::Use { sure, .. } => sure,
        Answer::Nothing { .. } => panic!("nothing"),
    };
    assert!(sure(Some(1.5), None) && !sure(Some(1.1), None));
    assert!(sure(None, Some(0.12)) && !sure(None, Some(0.105)));
}

#[test]
fn backends_scenes_and_quantities_have_their_own_advice() {
    let on_gpu = Run {
        backend: Backend::Gpu,
        software: true,
        ..run("maps", 0.1, 0.1)
    };
    let elsewhere = Run {
        scene: "hall".into(),
        ..run("maps", 9.0, 0.9)
    };
    let mut runs = sweep();
    runs.extend([on_gpu, elsewhere]);
    let advice = advise(&runs, Budget::default());
    let of: Vec<_> = advice
        .iter()
        .map(|a| (a.problem.scene.as_str(), a.software))
        .collect();
    assert_eq!(of, [("room", false), ("room", true), ("hall", false)]);
    assert_eq!(advise(&[], Budget::default()), []);
}

/// What is shown is what varies; what runs it again is everything.
#[test]
fn an_answer_can_be_run_again() {
    let Answer::Use { choice, .. } = ask(&sweep(), Some(2.0), None) else {
        panic!("nothing");
    };
    assert_eq!(choice.label(), "maps, resolution=2");
    let options = "--estimator maps --set maps.resolution=2 --set maps.clamp=0.5";
    assert_eq!(choice.options, options);
}
