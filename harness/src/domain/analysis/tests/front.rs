use super::*;
use proptest::prelude::*;

#[test]
fn what_is_beaten_in_both_is_not_on_the_front() {
    let runs = [
        run("slow", 9.0, 0.1),
        run("beaten", 9.0, 0.2),
        run("fast", 1.0, 0.5),
        run("worst", 10.0, 0.6),
        run("middle", 3.0, 0.3),
    ];
    assert_eq!(fronts(&runs), [0, 2, 4]);
    let front = &pareto(&runs, Metric::Truth)[0];
    let order: Vec<usize> = front.members.iter().map(|m| m.choice.run).collect();
    assert_eq!(order, [2, 4, 0]);
    assert!(front.members.iter().all(Standing::certain));
    assert_eq!(front.contenders, []);
}

#[test]
fn ties_stay_and_one_equal_number_does_not_save() {
    let tied = [run("a", 1.0, 0.5), run("b", 1.0, 0.5), run("c", 1.0, 0.6)];
    assert_eq!(fronts(&tied), [0, 1]);
    assert!(
        pareto(&tied, Metric::Truth)[0]
            .members
            .iter()
            .all(Standing::certain)
    );
}

#[test]
fn what_is_not_the_same_is_apart() {
    let other_scene = Run {
        scene: "hall".into(),
        ..run("a", 9.0, 0.9)
    };
    let other_quantity = Run {
        quantity: "glossy_radiance".into(),
        ..run("a", 9.0, 0.9)
    };
    let more_points = Run {
        points: 65,
        ..run("a", 9.0, 0.9)
    };
    let changed = Run {
        scene_hash: Some("5ce9e".into()),
        ..run("a", 9.0, 0.9)
    };
    let runs = [
        run("a", 1.0, 0.1),
        other_scene,
        other_quantity,
        more_points,
        changed,
    ];
    assert_eq!(fronts(&runs), [0, 1, 2, 3, 4]);
    assert_eq!(pareto(&runs, Metric::Truth).len(), 5);
}

#[test]
fn runs_without_numbers_do_not_belong() {
    let skipped = Run {
        skipped: Some("no adapter".into()),
        ..run("skipped", 0.1, 0.0)
    };
    let untimed = Run {
        phases_ms: Phases::default(),
        ..run("untimed", 0.1, 0.0)
    };
    let unjudged = Run {
        truth: None,
        ..run("unjudged", 0.1, 0.0)
    };
    let mut black = run("black", 0.1, 0.0);
    black.truth.as_mut().unwrap().relmse = None;
    let runs = [skipped, untimed, unjudged, black, run("a", 1.0, 0.5)];
    assert_eq!(fronts(&runs), [4]);
    assert_eq!(fronts(&runs[..4]), [0; 0]);
}

/// `a` is on the front by the numbers. `b` is a little slower, by less than the intervals, and a little
/// worse, by less than the noise: it could displace it, and so could belong itself.
#[test]
fn rivals_inside_the_noise_are_named() {
    let a = noisy("a", (1.0, 0.1), (0.50, 0.01));
    let b = noisy("b", (1.1, 0.1), (0.51, 0.01));
    let far = noisy("far", (2.0, 0.1), (0.9, 0.01));
    let front = &pareto(&[a.clone(), b.clone(), far], Metric::Truth)[0];
    let names = |s: &[Standing]| -> Vec<(usize, Vec<usize>)> {
        s.iter().map(|s| (s.choice.run, s.rivals.clone())).collect()
    };
    assert_eq!(names(&front.members), [(0, vec![1])]);
    assert_eq!(names(&front.contenders), [(1, vec![0])]);
    // Told apart in one of the two, both are where they are beyond doubt …
    let slower = noisy("b", (1.3, 0.05), (0.51, 0.01));
    let front = &pareto(&[a.clone(), slower], Metric::Truth)[0];
    assert!(front.members[0].certain());
    // … but for the error the slower one could still be the better.
    assert_eq!(names(&front.contenders), [(1, vec![0])]);
    let worse = noisy("b", (1.3, 0.05), (0.6, 0.01));
    let front = &pareto(&[a, worse], Metric::Truth)[0];
    assert!(front.members[0].certain() && front.contenders.is_empty());
}

/// Few different numbers, so that ties come up; some runs lack one.
fn some_run() -> impl Strategy<Value = Run> {
    let (scene, ms, error) = (0..2_u8, 1..6_u8, 0..6_u8);
    let noise = (0..3_u8, 0..3_u8);
    (scene, ms, error, noise, 0..8_u8).prop_map(|(scene, ms, error, noise, missing)| {
        let spread = (f64::from(ms), 0.4 * f64::from(noise.0));
        let mut run = noisy("a", spread, (f64::from(error), 0.4 * f64::from(noise.1)));
        run.scene = format!("scene {scene}");
        match missing {
            0 => run.truth = None,
            1 => run.skipped = Some("refused".into()),
            _ => {}
        }
        run
    })
}

fn numbers(run: &Run) -> Option<(f64, f64)> {
    let ran = run.skipped.is_none();
    let numbers = (run.phases_ms.frame_ms()?, run.truth.as_ref()?.relmse?);
    ran.then_some(numbers)
}

fn dominates(a: &Run, b: &Run) -> bool {
    let (Some(x), Some(y)) = (numbers(a), numbers(b)) else {
        return false;
    };
    a.scene == b.scene && x.0 <= y.0 && x.1 <= y.1 && x != y
}

proptest! {
    #[test]
    fn members_are_undominated_and_all_others_dominated_by_one(
        runs in prop::collection::vec(some_run(), 0..24),
    ) {
        let front = fronts(&runs);
        prop_assert!(front.is_sorted());
        for (i, run) in runs.iter().enumerate() {
            let member = front.contains(&i);
            let beaten = front.iter().any(|&m| dominates(&runs[m], run));
            prop_assert_eq!(member, numbers(run).is_some() && !beaten, "run {}", i);
            prop_assert!(!member || !runs.iter().any(|other| dominates(other, run)));
        }
    }

    #[test]
    fn the_order_of_the_runs_does_not_matter(
        (runs, order) in prop::collection::vec(some_run(), 0..16).prop_flat_map(|runs| {
            let order: Vec<usize> = (0..runs.len()).collect();
            (Just(runs), Just(order).prop_shuffle())
        }),
    ) {
        let shuffled: Vec<Run> = order.iter().map(|&i| runs[i].clone()).collect();
        let mut back: Vec<usize> = fronts(&shuffled).iter().map(|&i| order[i]).collect();
        back.sort_unstable();
        prop_assert_eq!(back, fronts(&runs));
    }

    /// Certain members stay, and nothing but contenders can join, wherever in its interval each time lies.
    #[test]
    fn certainty_survives_times_inside_their_intervals(
        runs in prop::collection::vec(some_run(), 1..16),
        places in prop::collection::vec(-1..=1_i8, 16),
    ) {
        let moved: Vec<Run> = runs.iter().zip(places).map(|(run, place)| {
            let mut moved = run.clone();
            let shade = moved.phases_ms.shade.as_mut().unwrap();
            shade.median += f64::from(place) * (shade.high - shade.median);
            moved
        }).collect();
        let after = fronts(&moved);
        let before = pareto(&runs, Metric::Truth);
        for front in &before {
            for member in front.members.iter().filter(|m| m.certain()) {
                prop_assert!(after.contains(&member.choice.run));
            }
        }
        let could = |i: &usize| before.iter().any(|f| {
            f.members.iter().chain(&f.contenders).any(|s| s.choice.run == *i)
        });
        prop_assert!(after.iter().all(could));
    }
}
