//! `verify` as others call it: the words of its JSON, exit codes, and what it leaves behind.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde_json::Value;
use std::process::{Command, Output};

fn verify(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_interreflect"))
        .arg("verify")
        .args(words)
        .output()
        .unwrap()
}

fn json(output: &Output) -> Value {
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    serde_json::from_slice(&output.stdout).unwrap()
}

const CONSTANT: [&str; 4] = ["--estimator", "constant_ambient", "--backend", "cpu"];

#[test]
fn every_check_is_told_with_verdict_value_and_bound() {
    let json = json(&verify(
        &[&CONSTANT[..], &["--cases", "2", "--json"]].concat(),
    ));
    let checks = json["checks"].as_array().unwrap();
    let mut names: Vec<&str> = checks
        .iter()
        .map(|c| c["check"].as_str().unwrap())
        .collect();
    names.sort_unstable();
    names.dedup();
    assert!(names.len() >= 30, "{names:?}");
    let mut passed = 0;
    for check in checks {
        assert_eq!(check["estimator"], "constant_ambient");
        assert_eq!(check["backend"], "cpu");
        let [value, bound] = ["value", "bound"].map(|key| check[key].as_f64());
        match check["verdict"].as_str().unwrap() {
            "passed" => {
                assert!(value.unwrap() <= bound.unwrap(), "{check}");
                assert!(check["cases"].as_u64().unwrap() > 0, "{check}");
                passed += 1;
            }
            "unclaimed" => assert!(value.unwrap() <= bound.unwrap(), "{check}"),
            "unclaimed_falsified" => assert!(value.unwrap() > bound.unwrap(), "{check}"),
            "not_applicable" => assert_ne!(check["note"], "", "{check}"),
            other => panic!("{other}: {check}"),
        }
    }
    assert!(passed >= 30, "{passed} passed");
}

#[test]
fn what_can_not_be_asked_is_one_line_and_exit_code_2() {
    for (words, hint) in [
        (&["--check", "linnear"][..], "linear"),
        (&["--estimator", "classic_envmapp"], "did you mean"),
        (&["--case", "{}"], "half"),
        (&["--extremes", "--check", "linear"], "--check"),
        (&["--set", "resolution=4"], "several estimators run"),
    ] {
        let output = verify(words);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {complaint}");
        assert_eq!(complaint.trim_end().lines().count(), 1, "{complaint}");
        assert!(complaint.contains(hint), "{words:?}: {complaint}");
    }
}

#[test]
fn extremes_leave_a_table_and_a_plot() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let json = json(&verify(
        &[&CONSTANT[..], &["--extremes", "--json", "--out", out]].concat(),
    ));
    let rows = json["extremes"].as_array().unwrap();
    let on = |axis: &str| -> Vec<&Value> { rows.iter().filter(|r| r["axis"] == axis).collect() };
    // Seven sizes from a micrometre to a thousand kilometres, for irradiance and glossy radiance.
    assert_eq!(on("scale").len(), 14);
    for row in on("scale") {
        // float32 sums of an estimate that is a mean.
        assert!(row["relative_error"].as_f64().unwrap() < 1e-5, "{row}");
    }
    for row in on("no_number").into_iter().chain(on("normal_length")) {
        assert!(row["relative_error"].is_null(), "{row}");
    }
    let csv = std::fs::read_to_string(folder.path().join("extremes.csv")).unwrap();
    assert_eq!(csv.lines().count(), rows.len() + 1);
    let svg = std::fs::read_to_string(folder.path().join("extremes.svg")).unwrap();
    assert!(svg.contains("<svg") && svg.contains("scale") && svg.contains("constant_ambient"));
}
