//! Runs the stranger's program, and reads what it printed.
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

pub(crate) fn run(words: &[&str]) -> Output {
    Command::new(program()).args(words).output().unwrap()
}

pub(crate) fn json(output: &Output) -> Value {
    let complaint = String::from_utf8_lossy(&output.stderr);
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {complaint}"))
}

pub(crate) fn checks(json: &Value) -> &Vec<Value> {
    json["checks"].as_array().unwrap()
}

/// The checks with a verdict.
pub(crate) fn names<'a>(json: &'a Value, verdict: &str) -> Vec<&'a str> {
    let found = checks(json).iter().filter(|c| c["verdict"] == verdict);
    found.map(|c| c["check"].as_str().unwrap()).collect()
}
