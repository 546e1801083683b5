//! Estimators from outside are measured and checked as those of the house are.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Output};

/// `cargo test` builds examples beside the folder of the tests.
fn program() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let profile = test.parent().unwrap().parent().unwrap();
    let name = format!("stranger{}", std::env::consts::EXE_SUFFIX);
    let program = profile.join("examples").join(name);
    assert!(
        program.exists(),
        "{} is missing; `cargo build --examples` makes it",
        program.display()
    );
    program
}

fn run(words: &[&str]) -> Output {
    Command::new(program()).args(words).output().unwrap()
}

fn json(output: &Output) -> Value {
    let complaint = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {complaint}"))
}

fn checks(json: &Value) -> &Vec<Value> {
    json["checks"].as_array().unwrap()
}

fn with<'a>(json: &'a Value, verdict: &str) -> Vec<&'a Value> {
    let checks = checks(json).iter();
    checks.filter(|c| c["verdict"] == verdict).collect()
}

const VERIFY: [&str; 6] = ["verify", "--backend", "cpu", "--json", "--cases", "4"];

#[test]
fn a_true_word_passes_every_check_that_it_is_about() {
    let output = run(&[&VERIFY[..], &["--estimator", "hemisphere_ambient"]].concat());
    let json = json(&output);
    assert!(output.status.success(), "{json}");
    assert_eq!(with(&json, "failed").len(), 0);
    let names = |verdict| -> Vec<&str> {
        let found = with(&json, verdict);
        found.iter().map(|c| c["check"].as_str().unwrap()).collect()
    };
    let passed = names("passed");
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
    assert!(names("unclaimed").contains(&"scale_invariant"));
}

/// Doubled, the brightest gives more than all walls could, and is no sum; the smallest box in which that
/// shows is told, with the command that shows it.
#[test]
fn a_false_word_fails_with_a_small_world_and_a_command_that_shows_it() {
    let output = run(&[&VERIFY[..], &["--estimator", "boastful"]].concat());
    assert_eq!(output.status.code(), Some(1));
    let json = json(&output);
    let failed = with(&json, "failed");
    let names: Vec<&str> = failed
        .iter()
        .map(|c| c["check"].as_str().unwrap())
        .collect();
    for name in ["bounded", "linear", "furnace_box"] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert!(!names.contains(&"non_negative"));
    let bounded = failed.iter().find(|c| c["check"] == "bounded").unwrap();
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
    let again = self::json(&again);
    assert_eq!(checks(&again).len(), 1);
    assert_eq!(checks(&again)[0]["value"], bounded["value"]);
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
