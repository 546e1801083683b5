#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::domain::analysis::samples::{comparison, noisy, run, traced, with};
use crate::domain::analysis::{Budget, Conclusions, Metric, advise};
use crate::domain::record::{Backend, ParamValue, Run, Verdict};

fn sample() -> (Vec<Run>, Vec<Run>) {
    let resolution = |ms, error, r| {
        let run = noisy("localized_cubemap", (ms, 0.1 * ms), (error, 0.01));
        with(run, "resolution", ParamValue::U32(r))
    };
    let mut runs = vec![
        resolution(1.0, 0.30, 2),
        resolution(4.0, 0.10, 4),
        resolution(160.0, 0.09, 8),
        noisy("polygon_form_factor", (3.0, 0.1), (0.11, 0.01)),
        run("constant_ambient", 0.05, 0.5),
        Run {
            backend: Backend::Gpu,
            software: true,
            ..run("constant_ambient", 0.2, 0.5)
        },
    ];
    runs[2].truth = Some(comparison(0.09, 0.06, Verdict::Inconclusive));
    let baselines = [1, 4, 16].into_iter();
    let both = baselines.flat_map(|n| [traced(n, 0, 2.0, 3.0), traced(n, 1, 1.0, 2.0)]);
    (runs, both.collect())
}

#[test]
fn conclusions_fit_the_width_and_say_it_all() {
    let (runs, baselines) = sample();
    let conclusions = Conclusions::of(&runs, &baselines, Metric::Truth);
    for width in [100, 120, 140] {
        let text = conclusions.text(Some(width));
        println!("{text}");
        let widest = text.lines().map(|l| l.chars().count()).max().unwrap();
        assert!(widest <= usize::from(width), "{widest} of {width}:\n{text}");
        for words in [
            "room: irradiance, 64 points: front of relMSE against the truth",
            "localized_cubemap, resolution=2",
            "path tracing on cpu",
            "n-ray gathering",
            "n<1",
            "n>16",
            "< 0.1",
            "gpu sw",
            "software adapter",
            "≲ 0.0900",
            "least relMSE against the truth of each method",
            "nothing is extrapolated",
            "≈ 0.110",
            "within noise of polygon_form_factor",
            "≈: not distinguishable",
        ] {
            assert!(text.contains(words), "no {words} at {width}:\n{text}");
        }
    }
}

#[test]
fn advice_says_how_to_run_it_again() {
    let (runs, _) = sample();
    let ask = |ms, max_error| {
        let budget = Budget {
            ms,
            max_error,
            ..Budget::default()
        };
        advice_in_text(&advise(&runs, budget))
    };
    let text = ask(Some(10.0), None) + &ask(Some(0.1), Some(0.2));
    println!("{text}");
    for words in [
        "room: irradiance, 64 points on cpu, at most 10.0 ms",
        "localized_cubemap, resolution=4: 4.00 (3.60–4.40) ms, relMSE against the truth 0.100",
        "--estimator localized_cubemap --set localized_cubemap.resolution=4",
        "at most 0.100 ms, error at most 0.200",
        "no run is within the limits; nearest: constant_ambient",
        "on gpu sw",
        "software adapter",
    ] {
        assert!(text.contains(words), "no {words}:\n{text}");
    }
}

#[test]
fn conclusions_are_json() {
    let (runs, baselines) = sample();
    let conclusions = Conclusions::of(&runs, &baselines, Metric::Truth);
    let json = serde_json::to_value(&conclusions).unwrap();
    assert_eq!(json["metric"], "truth");
    assert_eq!(json["fronts"][0]["scene"], "room");
    assert_eq!(json["fronts"][0]["members"][0]["choice"]["run"], 4);
    let table = &json["equal_time"][0];
    assert_eq!(table["question"], "equal_time");
    assert_eq!(table["contestants"][3]["baseline"], "path_tracing");
    assert_eq!(table["rows"][0]["cells"][0]["kind"], "missed");
    assert_eq!(table["rows"][0]["cells"][2]["kind"], "run");
    assert_eq!(table["rows"][0]["cells"][3]["kind"], "outside");
    assert_eq!(table["rows"][0]["cells"][3]["samples"], 1.0);
    let advice = serde_json::to_value(advise(&runs, Budget::default())).unwrap();
    assert_eq!(advice[0]["answer"]["kind"], "use");
}

#[test]
fn nothing_gives_no_words() {
    let nothing = Conclusions::of(&[], &[], Metric::Flip);
    assert_eq!(nothing.text(Some(100)), "");
    assert_eq!(advice_in_text(&[]), "");
}
