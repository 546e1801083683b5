//! What a campaign's results depend on, from outside: its keys and its references, its random numbers, and
//! how it ends when something fails.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// One method with one setting, and all that a sweep concludes from.
const SWEEP: &str = "sweep colored-room --vary constant_ambient.capture_resolution=8 \
     --quantity irradiance --backend cpu --points 40 --samples 4 --repeat 1 --json";

fn run(words: &str, out: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_interreflect"))
        .args(words.split_whitespace())
        .arg("--out")
        .arg(out)
        .output()
        .unwrap()
}

fn json(words: &str, out: &Path) -> Value {
    let output = run(words, out);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "`{words}`: {complaint}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The runs of a bench or a sweep.
fn runs(json: &Value) -> &Vec<Value> {
    let found = ["runs", "records"].iter().find_map(|name| json.get(name));
    found.unwrap().as_array().unwrap()
}

/// Finished tasks in a folder's journal.
fn tasks(folder: &Path) -> usize {
    let journal = std::fs::read_to_string(folder.join("journal.jsonl")).unwrap();
    let lines = journal.lines();
    lines.filter(|line| line.contains("\"key\"")).count()
}

/// References that are kept in a folder.
fn references(folder: &Path) -> usize {
    std::fs::read_dir(folder.join("references"))
        .unwrap()
        .count()
}

/// A sweep that is given again with anything changed does all of its tasks anew, and none if nothing is; its
/// references are those of before only if they do not depend on the change.
#[test]
fn a_result_is_taken_for_another_s_only_if_nothing_differs() {
    let folder = TempDir::new().unwrap();
    let out = folder.path();
    let first = json(SWEEP, out);
    let all = tasks(out);
    assert!(all > 8, "a run, baselines, a floor and a split: {all}");
    let again = json(SWEEP, out);
    assert_eq!(tasks(out), all, "the same sweep");
    assert_eq!(runs(&again), runs(&first));
    for (change, of_references) in [
        ("--seed 2", true),
        ("--samples 5", true),
        ("--error .9", true),
        ("--seconds 1000", true),
        ("--points 300", true),
        ("--threads 1", false),
        ("--set scene.glow=.5", true),
        ("--set scene.receiver.diffuse=.5", true),
        ("--reference-point .1,.2,.3", true),
    ] {
        let (tasks_before, references_before) = (tasks(out), references(out));
        let changed = format!("{SWEEP} {change}");
        let found = json(&changed, out);
        assert_eq!(tasks(out), tasks_before + all, "{change}");
        assert_eq!(runs(&found).len(), runs(&first).len(), "{change}");
        let new = references(out) - references_before;
        assert_eq!(new > 0, of_references, "{change}: {new} references");
        let after = tasks(out);
        assert_eq!(json(&changed, out), found, "{change}, again");
        assert_eq!(tasks(out), after, "{change}, again");
    }
    // Other words of the sweep itself.
    for (from, to) in [
        ("colored-room", "cornell-box"),
        ("irradiance", "glossy_radiance"),
        ("capture_resolution=8", "capture_resolution=16"),
        ("--repeat", "--set constant_ambient.bounces=1 --repeat"),
    ] {
        let before = tasks(out);
        json(&SWEEP.replace(from, to), out);
        // Baselines do not depend on the method beside them.
        assert!(tasks(out) > before, "{to}");
    }
    // What lies in the folder by now belongs to other sweeps: the first is found among it, and its references,
    // without the journal, are its own.
    let back = json(SWEEP, out);
    assert_eq!(runs(&back), runs(&first));
    std::fs::remove_file(out.join("journal.jsonl")).unwrap();
    let anew = json(SWEEP, out);
    for (anew, first) in runs(&anew).iter().zip(runs(&first)) {
        assert_eq!(anew["truth"], first["truth"]);
        assert_eq!(anew["own_model"], first["own_model"]);
    }
}

/// An estimate by as many paths of the same tracer errs as the truth does: by itself each would show the
/// noise floor, together twice that. With one stream of random numbers for both, it would be zero.
#[test]
fn the_truth_draws_random_numbers_of_its_own() {
    let folder = TempDir::new().unwrap();
    for seed in [1, 5] {
        let words = format!(
            "bench colored-room --estimator path_reference --set path_reference.samples=64 \
             --set path_reference.seed={seed} --seed {seed} --samples 64 --points 3000 \
             --quantity irradiance --backend cpu --repeat 1 --json"
        );
        let json = json(&words, folder.path());
        let truth = &runs(&json)[0]["truth"];
        let [found, floor] = ["relmse", "noise_floor"].map(|n| truth[n].as_f64().unwrap());
        // Thousands of points; standard errors of 64 samples are themselves a tenth off.
        let ratio = found / floor;
        assert!((1.5..2.7).contains(&ratio), "seed {seed}: {ratio}");
        let words = truth["reference"].as_str().unwrap();
        assert!(words.contains("64 samples"), "{words}");
    }
}

fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, ending, found);
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
}

/// A folder lies where one of two estimates' images belongs: its run fails, the other one's results are
/// there, and the program ends with 1 and says so.
#[test]
fn failed_runs_end_with_code_1_and_the_rest_is_there() {
    for command in [
        "bench colored-room --estimator constant_ambient --estimator path_reference \
         --set constant_ambient.capture_resolution=8 --set path_reference.samples=4",
        "sweep colored-room --vary constant_ambient.capture_resolution=8 \
         --vary path_reference.samples=4",
    ] {
        let folder = TempDir::new().unwrap();
        let out = folder.path();
        let words = format!(
            "{command} --quantity irradiance --backend cpu --points 40 --samples 4 --repeat 1 --json"
        );
        assert_eq!(runs(&json(&words, out)).len(), 2);
        let mut images = Vec::new();
        files(&out.join("images"), ".exr", &mut images);
        let name = |p: &Path| p.file_name().unwrap().to_string_lossy().into_owned();
        let image = images
            .iter()
            .find(|p| name(p).starts_with("path_reference"));
        let image = image.unwrap();
        std::fs::remove_file(image).unwrap();
        std::fs::create_dir(image).unwrap();
        std::fs::write(image.join("full"), "").unwrap();
        std::fs::remove_file(out.join("journal.jsonl")).ok();
        let output = run(&words, out);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{command}: {complaint}");
        assert!(
            complaint.contains("1 of 2 runs failed") && complaint.contains(&name(image)),
            "{complaint}"
        );
        let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(runs(&printed).len(), 2);
        assert!(out.join("results.json").is_file());
    }
}
