//! Estimators from outside are measured and checked as those of the house are.
#![allow(clippy::unwrap_used, reason = "tests")]

mod program;

use program::{checks, json, names, run};
use serde_json::Value;

const VERIFY: [&str; 6] = ["verify", "--backend", "cpu", "--json", "--cases", "4"];

#[test]
fn a_true_claim_passes_every_check_that_it_is_about() {
    let output = run(&[&VERIFY[..], &["--estimator", "hemisphere_ambient"]].concat());
    let json = json(&output);
    assert!(output.status.success(), "{json}");
    assert_eq!(names(&json, "failed"), [""; 0]);
    let passed = names(&json, "passed");
    for name in [
        "non_negative",
        "bounded",
        "linear",
        "furnace_box",
        "point_order",
    ] {
        assert!(passed.contains(&name), "{name}: {passed:?}");
    }
    // It says nothing of other sizes of a scene, and nothing is wrong there.
    assert!(names(&json, "unclaimed").contains(&"scale_invariant"));
}

/// Doubled, the brightest gives more than all walls could, and is no sum; the smallest box in which that
/// shows is told, with the command that shows it.
#[test]
fn a_false_claim_fails_with_a_small_box_scene_and_a_command_that_reproduces_it() {
    let output = run(&[&VERIFY[..], &["--estimator", "boastful"]].concat());
    assert_eq!(output.status.code(), Some(1));
    let json = json(&output);
    let failed = names(&json, "failed");
    for name in ["bounded", "linear", "furnace_box"] {
        assert!(failed.contains(&name), "{failed:?}");
    }
    assert!(!failed.contains(&"non_negative"));
    let bounded = checks(&json).iter().find(|c| c["check"] == "bounded");
    let bounded = bounded.unwrap();
    assert!(bounded["value"].as_f64() > bounded["bound"].as_f64());

    let command = bounded["command"].as_str().unwrap();
    let (words, case) = command.split_once(" --case ").unwrap();
    let case = case.trim_matches('\'');
    let told: Value = serde_json::from_str(case).unwrap();
    assert_eq!(told["points"].as_array().unwrap().len(), 1, "{case}");
    let mut words: Vec<&str> = words.split_whitespace().skip(1).collect();
    words.extend(["--case", case, "--json"]);
    let again = run(&words);
    assert_eq!(again.status.code(), Some(1));
    let again = program::json(&again);
    assert_eq!(checks(&again).len(), 1);
    assert_eq!(checks(&again)[0]["value"], bounded["value"]);
}

/// Its rule depends on where a point is, its own model on nothing that the house has.
#[test]
fn a_rule_and_a_reference_model_of_its_own_are_asked() {
    let output = run(&[&VERIFY[..], &["--estimator", "box_projected"]].concat());
    let json = json(&output);
    assert!(output.status.success(), "{json}");
    assert!(names(&json, "passed").contains(&"at_points"), "{json}");

    let line =
        "bench furnace --estimator box_projected --points 64 --samples 32 --backend cpu --json";
    let output = run(&line.split_whitespace().collect::<Vec<_>>());
    let json = program::json(&output);
    let own = &json["runs"][0]["own_model"];
    assert!(
        own["reference"]
            .as_str()
            .unwrap()
            .contains("along the normal"),
        "{own}"
    );
    assert!(own["relmse"].as_f64().unwrap() < 1e-9, "{own}");
}

#[test]
fn it_is_measured_beside_the_others() {
    let line = "bench studio --estimator hemisphere_ambient --points 64 --samples 32 \
                --backend cpu --json";
    let output = run(&line.split_whitespace().collect::<Vec<_>>());
    let json = json(&output);
    assert!(output.status.success(), "{json}");
    let runs = json["runs"].as_array().unwrap();
    assert_eq!(runs.len(), 1, "{json}");
    assert_eq!(runs[0]["estimator"], "hemisphere_ambient");
    assert_eq!(runs[0]["scene"], "studio");
    assert_eq!(runs[0]["quantity"], "irradiance");
    assert!(runs[0]["truth"]["relmse"].is_number(), "{json}");
}
