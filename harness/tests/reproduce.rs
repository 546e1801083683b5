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
fn the_list_has_every_experiment_with_its_claims() {
    let folder = tempfile::tempdir().unwrap();
    let listed = json(&run(folder.path(), "reproduce --list --json"));
    let listed = listed.as_array().unwrap();
    for paper in [
        "szirmay-kalos.",
        "kautz.",
        "frisvad.",
        "umenhoffer.",
        "sattler.",
    ] {
        let of_paper = |e: &&Value| e["id"].as_str().unwrap().starts_with(paper);
        assert!(listed.iter().any(|e| of_paper(&e)), "{paper}");
    }
    let text = run(folder.path(), "reproduce --list");
    let text = String::from_utf8(text.stdout).unwrap();
    for e in listed {
        let line = format!("  {} ", e["id"].as_str().unwrap());
        let at = text.find(&line).unwrap();
        for claim in e["claims"].as_array().unwrap() {
            let [id, says, rule] = ["id", "says", "rule"].map(|name| claim[name].as_str().unwrap());
            assert!(!rule.is_empty());
            assert!(
                text[at..].contains(id) && text[at..].contains(says),
                "{id} of {line}"
            );
        }
    }
    assert!(
        text.contains("  frisvad.6 ") && text.contains("Figure 6"),
        "{text}"
    );
}

#[test]
fn bad_usage_is_one_line_that_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    for (line, words) in [
        (
            "reproduce kautz.seam",
            ["did you mean `kautz.seams`?", "reproduce --list"],
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
    let line = "reproduce kautz.seams --quick --backend cpu --out out";
    let output = run(folder.path(), line);
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{complaint}");
    let lines: Vec<&str> = told.lines().collect();
    assert!(lines[0].starts_with("kautz.seams C1 ") && lines[0].contains(" holds "));
    assert!(lines[1].starts_with("kautz.seams C2 ") && lines[1].contains(" holds "));

    let out = folder.path().join("out");
    let results = std::fs::read_to_string(out.join("reproduce.json")).unwrap();
    let results: Value = serde_json::from_str(&results).unwrap();
    assert_eq!(results["quick"], true);
    let [experiment] = &results["experiments"].as_array().unwrap()[..] else {
        panic!("not one experiment: {results}");
    };
    assert_eq!(experiment["id"], "kautz.seams");
    assert_eq!(
        experiment["command"],
        "interreflect reproduce kautz.seams --quick --backend cpu"
    );
    // The seams are what the paper shows, and the fidelities are there to show them.
    let claims = experiment["claims"].as_array().unwrap();
    assert_eq!(claims.len(), 2);
    for (claim, id) in claims.iter().zip(["C1", "C2"]) {
        assert_eq!(
            (claim["id"].as_str(), claim["verdict"].as_str()),
            (Some(id), Some("holds"))
        );
        let trials = claim["trials"].as_array().unwrap();
        assert!(!trials.is_empty() && trials.iter().all(|t| t["backend"] == "cpu"));
    }
    assert!(experiment.get("verdict").is_none());
    let notes = experiment["notes"].to_string();
    assert!(
        notes.contains("bunny.obj not found, `blob` is used instead"),
        "{notes}"
    );
    let measured = experiment["measured"].as_array().unwrap();
    assert!(!measured.is_empty() && measured.iter().all(|m| m["value"].as_f64().is_some()));
    assert!(
        experiment["runs"]
            .as_array()
            .unwrap()
            .iter()
            .all(|r| r["estimator"] == "sh_mip_envmap")
    );

    let page = std::fs::read_to_string(out.join("reproduce.html")).unwrap();
    for word in [
        "kautz.seams",
        "data:image/png;base64,",
        "prefers-color-scheme",
        "C1: Levels that are filtered face by face",
        "C2: Filtering across a border",
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
    let pictures: Vec<_> = std::fs::read_dir(out.join("kautz.seams"))
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
