use super::*;

/// Names of the methods, cheap and rough to dear and fine, on one scene.
fn sweep() -> Vec<Run> {
    let resolution = |ms, error, r| with(run("maps", ms, error), "resolution", ParamValue::U32(r));
    let mut corrected = resolution(3.0, 0.02, 8);
    corrected.fidelity = Some("corrected".into());
    vec![
        resolution(1.0, 0.30, 2),
        resolution(4.0, 0.10, 4),
        resolution(16.0, 0.08, 8),
        corrected,
        run("constant", 0.5, 0.5),
    ]
}

fn names(table: &Table) -> Vec<&str> {
    table.contestants.iter().map(|c| c.name.as_str()).collect()
}

fn limits(table: &Table) -> Vec<f64> {
    table.rows.iter().map(|r| r.limit).collect()
}

/// Index of the run in each cell of a contestant's row.
fn runs_of(table: &Table, contestant: usize) -> Vec<Option<usize>> {
    let run = |row: &Row| match &row.cells[contestant] {
        Cell::Run(choice) => Some(choice.run),
        _ => None,
    };
    table.rows.iter().map(run).collect()
}

#[test]
fn each_time_has_the_least_error_within_it() {
    let tables = equal_time(&sweep(), &[], Metric::Truth);
    let [table] = tables.as_slice() else {
        panic!("{} tables", tables.len());
    };
    assert_eq!(names(table), ["maps", "maps, corrected", "constant"]);
    assert_eq!(limits(table), [0.5, 1.0, 2.0, 5.0, 10.0, 20.0]);
    let maps = [None, Some(0), Some(0), Some(1), Some(1), Some(2)];
    assert_eq!(runs_of(table, 0), maps);
    assert_eq!(runs_of(table, 1)[2..], [None, Some(3), Some(3), Some(3)]);
    let winners: Vec<Option<usize>> = table.rows.iter().map(|r| r.winner).collect();
    assert_eq!(
        winners,
        [Some(2), Some(0), Some(0), Some(1), Some(1), Some(1)]
    );
    let Cell::Run(choice) = &table.rows[3].cells[0] else {
        panic!("no run");
    };
    assert_eq!(choice.label(), "maps, resolution=4");
}

#[test]
fn each_error_has_the_least_time_to_it() {
    let table = &equal_error(&sweep(), &[], Metric::Truth)[0];
    assert_eq!(limits(table), [0.02, 0.05, 0.1, 0.2, 0.5]);
    let maps = [None, None, Some(1), Some(1), Some(0)];
    assert_eq!(runs_of(table, 0), maps);
    assert_eq!(runs_of(table, 2)[3..], [None, Some(4)]);
    let winners: Vec<Option<usize>> = table.rows.iter().map(|r| r.winner).collect();
    assert_eq!(winners, [Some(1), Some(1), Some(1), Some(1), Some(2)]);
}

#[test]
fn what_cannot_be_told_apart_from_the_winner_is_said() {
    let runs = [
        noisy("a", (1.0, 0.2), (0.100, 0.01)),
        noisy("b", (1.1, 0.2), (0.115, 0.01)),
        noisy("c", (2.0, 0.2), (0.200, 0.01)),
    ];
    let row = |tables: Vec<Table>| tables[0].rows.last().cloned().unwrap();
    let at_two = row(equal_time(&runs, &[], Metric::Truth));
    assert_eq!((at_two.winner, at_two.alike), (Some(0), vec![1]));
    let at_error = row(equal_error(&runs, &[], Metric::Truth));
    assert_eq!((at_error.winner, at_error.alike), (Some(0), vec![1]));
}

#[test]
fn backends_have_their_own_tables_with_the_same_limits() {
    let on_gpu = Run {
        backend: Backend::Gpu,
        software: true,
        ..run("maps", 40.0, 0.1)
    };
    let mut runs = sweep();
    runs.push(on_gpu);
    let tables = equal_time(&runs, &[], Metric::Truth);
    let on: Vec<_> = tables.iter().map(|t| (t.backend, t.software)).collect();
    assert_eq!(on, [(Backend::Cpu, false), (Backend::Gpu, true)]);
    assert_eq!(limits(&tables[0]), limits(&tables[1]));
    assert_eq!(tables[1].rows[0].winner, None);
}

/// n samples take n·2 ms and leave an error of .8/n: between the measured counts the straight line is that
/// very law.
#[test]
fn baselines_meet_the_law_between_their_measured_counts() {
    let baselines = [1, 4, 16, 64].map(|n| traced(n, 0, 2.0, 0.8));
    let runs = [run("a", 1.0, 0.5), run("b", 200.0, 0.001)];
    let table = &equal_time(&runs, &baselines, Metric::Truth)[0];
    assert_eq!(names(table)[2], "path tracing");
    for row in &table.rows {
        match (&row.cells[2], row.limit) {
            (Cell::Outside(end), ms) => assert!(end.samples == 1.0 && ms < 2.0),
            (Cell::Bound(end), ms) => assert!(end.samples == 64.0 && ms > 128.0),
            (Cell::Interpolated(at), ms) => {
                close(at.samples, ms / 2.0);
                close(at.error.value, 0.8 * 2.0 / ms);
                close(at.frame.ms, ms);
            }
            (other, ms) => panic!("{other:?} at {ms} ms"),
        }
    }
    let count = |kind: fn(&Cell) -> bool| table.rows.iter().filter(|r| kind(&r.cells[2])).count();
    // 1; 2 to 100; 200.
    assert_eq!(count(|c| matches!(c, Cell::Outside(_))), 1);
    assert_eq!(count(|c| matches!(c, Cell::Interpolated(_))), 6);
    assert_eq!(count(|c| matches!(c, Cell::Bound(_))), 1);
    let table = &equal_error(&runs, &baselines, Metric::Truth)[0];
    for row in &table.rows {
        match (&row.cells[2], row.limit) {
            (Cell::Outside(end), error) => assert!(end.samples == 64.0 && error < 0.8 / 64.0),
            (Cell::Interpolated(at), error) => {
                close(at.frame.ms, 2.0 * 0.8 / error);
                close(at.error.value, error);
            }
            (other, error) => panic!("{other:?} at {error}"),
        }
    }
}

/// Beyond what was measured a baseline counts with what it surely reaches, and might do better.
#[test]
fn the_ends_of_a_baseline_are_bounds() {
    let baselines = [traced(4, 1, 1.0, 0.8), traced(8, 1, 1.0, 0.8)];
    let last = |tables: Vec<Table>| tables[0].rows.last().cloned().unwrap();
    let outcome = |row: Row| (row.winner, row.open);
    let at_time = |ms, error| {
        last(equal_time(
            &[run("a", ms, error)],
            &baselines,
            Metric::Truth,
        ))
    };
    // In 20 ms there is room for eight samples and more: .1, or less.
    assert_eq!(outcome(at_time(20.0, 0.5)), (Some(1), vec![]));
    assert_eq!(outcome(at_time(20.0, 0.05)), (Some(0), vec![1]));
    // In 2 ms, with less than four samples, the error is above .2.
    assert_eq!(outcome(at_time(2.0, 0.5)), (Some(0), vec![1]));
    assert_eq!(outcome(at_time(2.0, 0.1)), (Some(0), vec![]));
    let at_error = |ms, error| {
        last(equal_error(
            &[run("a", ms, error)],
            &baselines,
            Metric::Truth,
        ))
    };
    // Up to .5, four samples do, in 4 ms or less.
    assert_eq!(outcome(at_error(9.0, 0.5)), (Some(1), vec![]));
    assert_eq!(outcome(at_error(3.0, 0.5)), (Some(0), vec![1]));
    // Up to .05 more than eight samples are needed, and so more than 8 ms.
    assert_eq!(outcome(at_error(9.0, 0.05)), (Some(0), vec![1]));
    assert_eq!(outcome(at_error(7.0, 0.05)), (Some(0), vec![]));
    // One sample is the least there is: nothing is open.
    let one = [traced(1, 0, 4.0, 0.8)];
    let row = last(equal_time(&[run("a", 2.0, 0.9)], &one, Metric::Truth));
    assert_eq!(outcome(row), (Some(0), vec![]));
    let row = last(equal_error(&[run("a", 2.0, 0.9)], &one, Metric::Truth));
    assert_eq!(outcome(row), (Some(0), vec![]));
}

#[test]
fn a_baseline_can_win() {
    let baselines = [traced(1, 0, 1.0, 0.1), traced(64, 0, 1.0, 0.1)];
    let table = &equal_time(&[run("a", 9.0, 0.5)], &baselines, Metric::Truth)[0];
    assert_eq!((table.rows[0].limit, table.rows[0].winner), (10.0, Some(1)));
}

/// Times that fell by chance, and an error of nothing: no logarithm, no number out of thin air.
#[test]
fn odd_baselines_give_numbers_that_were_measured() {
    let mut faster = traced(2, 0, 1.0, 0.8);
    faster.phases_ms.shade = timing(0.9, 0.0);
    let mut exact = traced(4, 0, 1.0, 0.8);
    exact.truth.as_mut().unwrap().relmse = Some(0.0);
    let baselines = [traced(1, 0, 1.0, 0.8), faster, exact];
    let runs = [run("a", 0.95, 0.5), run("b", 2.0, 0.1)];
    let at = |tables: Vec<Table>| -> Vec<(f64, f64)> {
        let numbers = |row: &Row| {
            let (frame, error) = row.cells[2].numbers()?;
            Some((frame.ms, error.value))
        };
        tables[0].rows.iter().filter_map(numbers).collect()
    };
    for (ms, error) in at(equal_time(&runs, &baselines, Metric::Truth)) {
        assert!(ms.is_finite() && error == 0.4, "{error} at {ms}");
    }
    // .1, .2: only the exact one is known to do. .5: between one sample and two.
    let found = at(equal_error(&runs, &baselines, Metric::Truth));
    assert_eq!(found[..2], [(4.0, 0.0), (4.0, 0.0)]);
    // Two samples took less time than any number that would do by the line.
    assert_eq!(found[2], (0.9, 0.4));
}

/// The error came to its floor and went on by chance: the fewer samples are the better answer.
#[test]
fn what_was_measured_counts_where_it_beats_the_line() {
    let mut floor = [1, 4, 16].map(|n| traced(n, 1, 1.0, 0.8));
    floor[2].truth.as_mut().unwrap().relmse = Some(0.3);
    let runs = [run("a", 10.0, 0.5), run("b", 20.0, 0.5)];
    let table = &equal_time(&runs, &floor, Metric::Truth)[0];
    let found: Vec<_> = table
        .rows
        .iter()
        .map(|r| r.cells[2].numbers().unwrap())
        .collect();
    let numbers: Vec<_> = found.iter().map(|(f, e)| (f.ms, e.value)).collect();
    assert_eq!(numbers, [(4.0, 0.2), (4.0, 0.2)]);
    assert!(matches!(table.rows[1].cells[2], Cell::Bound(_)));
}

#[test]
fn only_plain_path_tracing_is_a_baseline() {
    let of = |run: &Run| Baseline::of(run);
    let plain = traced(4, 0, 1.0, 1.0);
    assert_eq!(of(&plain), Some(Baseline::PathTracing));
    assert_eq!(of(&traced(4, 1, 1.0, 1.0)), Some(Baseline::NRayGathering));
    assert_eq!(of(&traced(4, 2, 1.0, 1.0)), None);
    assert_eq!(of(&run("maps", 1.0, 1.0)), None);
    let usual = with(plain.clone(), "self_shadowing", ParamValue::Bool(true));
    assert_eq!(of(&usual), Some(Baseline::PathTracing));
    let without = with(plain.clone(), "self_shadowing", ParamValue::Bool(false));
    assert_eq!(of(&without), None);
    assert_eq!(
        of(&with(plain, "seed", ParamValue::U32(7))),
        Some(Baseline::PathTracing)
    );
}

#[test]
fn baselines_elsewhere_do_not_count() {
    let elsewhere = Run {
        scene: "hall".into(),
        ..traced(1, 0, 1.0, 1.0)
    };
    let of_more_points = Run {
        points: 65,
        ..traced(1, 0, 1.0, 1.0)
    };
    let baselines = [elsewhere, of_more_points];
    let table = &equal_time(&sweep(), &baselines, Metric::Truth)[0];
    assert_eq!(table.contestants.len(), 3);
}

#[test]
fn a_floor_is_where_more_time_buys_nothing() {
    let runs = [
        noisy("a", (1.0, 0.1), (0.30, 0.01)),
        noisy("a", (2.0, 0.1), (0.11, 0.01)),
        noisy("a", (8.0, 0.1), (0.10, 0.01)),
        noisy("b", (1.0, 0.1), (0.30, 0.01)),
        noisy("b", (2.0, 0.1), (0.10, 0.01)),
    ];
    let floors = floors(&runs, Metric::Truth);
    let found = |f: &Floor| (f.least.run, f.soonest.run, f.reached);
    let found: Vec<_> = floors.iter().map(found).collect();
    assert_eq!(found, [(2, 1, true), (4, 4, false)]);
}
