//! `reproduce` as others call it: its list, what it refuses, and what an experiment leaves behind.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

/// Runs a command line in a folder without models.
fn run(folder: &Path, line: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_interreflect"))
        .args(line.split_whitespace())
        .current_dir(folder)
        .env("INTERREFLECT_ASSETS", folder.join("nothing"))
        .output()
        .unwrap()
}

fn json(output: &Output) -> Value {
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_list_has_every_experiment_with_its_claim_and_rule() {
    let folder = tempfile::tempdir().unwrap();
    let listed = json(&run(folder.path(), "reproduce --list --json"));
    let listed = listed.as_array().unwrap();
    let of = |paper: &str| {
        let ids = listed.iter().map(|e| e["id"].as_str().unwrap());
        ids.filter(|id| id.starts_with(paper)).count()
    };
    let counts = [
        "szirmay-kalos.",
        "kautz.",
        "frisvad.",
        "umenhoffer.",
        "sattler.",
    ]
    .map(of);
    assert_eq!(counts, [5, 4, 9, 3, 8]);
    let figures = listed
        .iter()
        .filter(|e| !e["item"].as_str().unwrap().starts_with('§'));
    assert_eq!(figures.count(), 26);
    for e in listed {
        assert!(
            !e["claim"].as_str().unwrap().is_empty() && !e["rule"].as_str().unwrap().is_empty()
        );
    }
    let text = run(folder.path(), "reproduce --list");
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(
        text.contains("frisvad.table1") && text.contains("Table 1"),
        "{text}"
    );
}

#[test]
fn bad_usage_is_one_line_that_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    for (line, words) in [
        (
            "reproduce kautz.44",
            ["did you mean `kautz.4`?", "reproduce --list"],
        ),
        (
            "reproduce satler",
            ["did you mean `sattler`?", "reproduce --list"],
        ),
        ("reproduce", ["required", "--help"]),
        (
            "reproduce all --out /dev/null/folder",
            ["/dev/null/folder", "--out"],
        ),
    ] {
        let output = run(folder.path(), line);
        let complaint = String::from_utf8(output.stderr).unwrap();
        let code = if line.contains("--out") { 1 } else { 2 };
        assert_eq!(output.status.code(), Some(code), "`{line}`: {complaint}");
        assert_eq!(
            complaint.trim_end().lines().count(),
            1,
            "`{line}`: {complaint}"
        );
        for word in words {
            assert!(complaint.contains(word), "`{line}`: {complaint}");
        }
    }
    assert!(!folder.path().join("results").exists());
}

/// Cheap: no path tracing, and a model that is not there.
#[test]
fn an_experiment_leaves_its_numbers_page_and_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let line = "reproduce kautz.4 --quick --backend cpu --out out";
    let output = run(folder.path(), line);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    assert!(told.starts_with("kautz.4"), "{told}");

    let out = folder.path().join("out");
    let results = std::fs::read_to_string(out.join("reproduce.json")).unwrap();
    let results: Value = serde_json::from_str(&results).unwrap();
    assert_eq!(results["quick"], true);
    let [experiment] = &results["experiments"].as_array().unwrap()[..] else {
        panic!("not one experiment: {results}");
    };
    assert_eq!(experiment["id"], "kautz.4");
    assert_eq!(
        experiment["command"],
        "interreflect reproduce kautz.4 --quick --backend cpu"
    );
    // The seams are what the paper shows, and the fidelities are there to show them.
    assert_eq!(experiment["verdict"], "holds");
    let notes = experiment["notes"].to_string();
    assert!(
        notes.contains("bunny.obj not found, `blob` is used instead"),
        "{notes}"
    );
    let measured = experiment["measured"].as_array().unwrap();
    assert!(!measured.is_empty() && measured.iter().all(|m| m["value"].as_f64().is_some()));
    let trials = experiment["trials"].as_array().unwrap();
    assert!(trials.iter().all(|t| t["backend"] == "cpu"), "{trials:?}");
    assert!(
        experiment["runs"]
            .as_array()
            .unwrap()
            .iter()
            .all(|r| r["estimator"] == "sh_mip_envmap")
    );

    let page = std::fs::read_to_string(out.join("reproduce.html")).unwrap();
    for word in [
        "kautz.4",
        "data:image/png;base64,",
        "prefers-color-scheme",
        "holds",
    ] {
        assert!(page.contains(word), "the page has no {word}");
    }
    for outside in ["src=\"http", "<script", "<link"] {
        assert!(
            !page.contains(outside),
            "the page is not self-contained: {outside}"
        );
    }
    let pictures: Vec<_> = std::fs::read_dir(out.join("kautz.4"))
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    for ending in [".exr", ".png", "overview.png"] {
        assert!(
            pictures.iter().any(|p| p.ends_with(ending)),
            "no {ending} in {pictures:?}"
        );
    }
}
