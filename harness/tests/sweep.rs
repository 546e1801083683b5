//! Sweeps that are killed, run in parts, and asked.
//!
//! The trial with GNU parallel is shown as ignored where that is not installed;
//! INTERREFLECT_REQUIRE_PARALLEL=1 makes that a failure.
//!
//! Longer than most: all trials are of one small sweep.
#![allow(clippy::unwrap_used, reason = "tests")]

use libtest_mimic::{Arguments, Failed, Trial};
use serde_json::{Map, Value};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// Two methods, each with its own resolutions, on few points and small captures.
const SWEEP: &str = "sweep colored-room --vary polygon_form_factor.resolution=2..8:log2 \
     --vary localized_cubemap.resolution=2..4:log2 --set polygon_form_factor.capture_resolution=16 \
     --set localized_cubemap.capture_resolution=16 --backend cpu --points 60 --samples 32 --repeat 1 --json";

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let parallel = Command::new("parallel")
        .arg("--version")
        .stdout(Stdio::null())
        .status();
    let required = std::env::var_os("INTERREFLECT_REQUIRE_PARALLEL").is_some();
    let missing = parallel.is_err() && !required;
    if missing {
        eprintln!("GNU parallel is not installed: a sweep in parts is not tried with it");
    }
    let trials = vec![
        Trial::test("a_sweep_prints_records_fronts_and_floors", printed),
        Trial::test("killed_twenty_times_it_loses_and_doubles_nothing", killed),
        Trial::test("parts_merge_to_the_whole", parts),
        Trial::test("a_file_says_the_same_as_the_command_line", file),
        Trial::test("axes_of_scene_and_run_multiply", axes),
        Trial::test("budgets_are_answered", budgets),
        Trial::test("slips_end_with_one_line_and_code_2", slips),
        Trial::test("parts_run_under_gnu_parallel", in_parallel).with_ignored_flag(missing),
    ];
    libtest_mimic::run(&arguments, trials).exit_code()
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_interreflect"))
}

/// The JSON of a command that succeeds.
fn json(words: &str, out: &Path) -> Result<Value, Failed> {
    let output = program()
        .args(words.split_whitespace())
        .arg("--out")
        .arg(out)
        .output()?;
    let complaint = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("{}: {complaint}", output.status).into());
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

/// Without what is measured and not computed: times, and what follows from them.
fn untimed(mut json: Value) -> Value {
    for name in [
        "pareto",
        "fronts",
        "equal_time",
        "equal_error",
        "floors",
        "advice",
    ] {
        json.as_object_mut().unwrap().remove(name);
    }
    for kind in ["runs", "baselines"] {
        for run in json[kind].as_array_mut().unwrap() {
            let run = run.as_object_mut().unwrap();
            for name in ["phases_ms", "slowed"] {
                run.remove(name);
            }
        }
    }
    json
}

/// Where two values differ first.
fn difference(a: &Value, b: &Value) -> Option<String> {
    let at = |name: &str, a, b| difference(a, b).map(|d| format!("{name}.{d}"));
    match (a, b) {
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let mut pairs = a.iter().zip(b).enumerate();
            pairs.find_map(|(i, (a, b))| at(&i.to_string(), a, b))
        }
        (Value::Array(a), Value::Array(b)) => {
            Some(format!(": {} entries are not {}", a.len(), b.len()))
        }
        (Value::Object(a), Value::Object(b)) => {
            let of = |all, name| Map::get(all, name).unwrap_or(&Value::Null);
            let mut names = a.keys().chain(b.keys());
            names.find_map(|name| at(name, of(a, name), of(b, name)))
        }
        _ => (a != b).then(|| format!(": {a} is not {b}")),
    }
}

/// The same in everything but times.
fn same(found: &Value, wanted: &Value) -> Result<(), Failed> {
    match difference(&untimed(found.clone()), &untimed(wanted.clone())) {
        None => Ok(()),
        Some(difference) => Err(difference.into()),
    }
}

fn records(json: &Value) -> &Vec<Value> {
    json["runs"].as_array().unwrap()
}

fn printed() -> Result<(), Failed> {
    let out = TempDir::new()?;
    let json = json(SWEEP, out.path())?;
    // Polygons: three resolutions in two fidelities, irradiance alone; the cube map: two, and two quantities.
    assert_eq!(records(&json).len(), 3 * 2 + 2 * 2 * 2);
    let indices = json["pareto"].as_array().unwrap();
    assert!(!indices.is_empty());
    for index in indices {
        let member = &records(&json)[index.as_u64().unwrap() as usize];
        let beaten = |other: &&Value| {
            let (time, error) = (
                frame_ms(other) - frame_ms(member),
                relmse(other) - relmse(member),
            );
            let alike =
                (&other["scene"], &other["quantity"]) == (&member["scene"], &member["quantity"]);
            alike && time <= 0.0 && error <= 0.0 && (time < 0.0 || error < 0.0)
        };
        assert!(records(&json).iter().find(beaten).is_none(), "{member}");
    }
    let floors = json["bias_floor"].as_object().unwrap();
    let floor = &floors["colored-room/irradiance/polygon_form_factor"];
    assert!(floor["relmse"].as_f64().unwrap() > 0.01, "{floor}");
    // What the steps add up to is what the estimate is off by.
    for split in json["splits"].as_array().unwrap() {
        let parts = split["parts"].as_array().unwrap().iter();
        let sum: f64 = parts.map(|p| p["mean"].as_f64().unwrap()).sum();
        let same = |r: &&Value| {
            ["estimator", "fidelity", "quantity", "params"]
                .iter()
                .all(|n| r[*n] == split[*n])
        };
        let run = records(&json).iter().find(same).unwrap();
        let energy = run["truth"]["energy_ratio"].as_f64().unwrap();
        assert!((1.0 + sum - energy).abs() < 1e-5, "{sum} {energy}");
    }
    for file in [
        "results.json",
        "results.csv",
        "report.html",
        "journal.jsonl",
    ] {
        assert!(out.path().join(file).is_file(), "{file}");
    }
    Ok(())
}

fn frame_ms(run: &Value) -> f64 {
    let median = |phase: &str| run["phases_ms"][phase]["median"].as_f64().unwrap_or(0.0);
    median("capture") + median("prepare") + median("shade")
}

fn relmse(run: &Value) -> f64 {
    run["truth"]["relmse"].as_f64().unwrap()
}

/// Whole lines of the journal in a folder; none before it is there.
fn journalled(folder: &Path) -> usize {
    let text = std::fs::read(folder.join("journal.jsonl")).unwrap_or_default();
    text.iter().filter(|byte| **byte == b'\n').count()
}

/// SIGKILL at twenty moments all over the work, each a little after the journal has come so far, then to
/// the end.
fn killed() -> Result<(), Failed> {
    const KILLS: usize = 20;
    let (whole, out) = (TempDir::new()?, TempDir::new()?);
    let undisturbed = json(SWEEP, whole.path())?;
    let lines = journalled(whole.path());
    let mut random = fastrand::Rng::with_seed(20);
    let mut interrupted = 0;
    for kill in 0..KILLS {
        let mut child = program()
            .args(SWEEP.split_whitespace())
            .arg("--out")
            .arg(out.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()?;
        // By what is done, not by the clock: a machine may be busier now than it was before.
        while journalled(out.path()) < lines * kill / KILLS && child.try_wait()?.is_none() {
            std::thread::sleep(Duration::from_millis(1));
        }
        std::thread::sleep(Duration::from_micros(random.u64(0..20_000)));
        interrupted += usize::from(child.try_wait()?.is_none());
        child.kill()?;
        child.wait()?;
    }
    // The last ones may have been quicker than the signal.
    assert!(interrupted >= KILLS / 2, "only {interrupted} were at work");
    let resumed = json(SWEEP, out.path())?;
    same(&resumed, &undisturbed)?;
    let journal = std::fs::read_to_string(out.path().join("journal.jsonl"))?;
    let keys = journal.lines().filter_map(|line| {
        let line: Value = serde_json::from_str(line).ok()?;
        Some(line["task"]["key"].as_str()?.to_owned())
    });
    let mut keys: Vec<String> = keys.collect();
    let all = keys.len();
    keys.sort();
    keys.dedup();
    assert_eq!(keys.len(), all, "a task was done twice");
    Ok(())
}

fn parts() -> Result<(), Failed> {
    let folder = TempDir::new()?;
    let at = |name: &str| folder.path().join(name);
    let whole = json(SWEEP, &at("whole"))?;
    for part in 1..=3 {
        json(
            &format!("{SWEEP} --shard {part}/3"),
            &at(&format!("part{part}")),
        )?;
    }
    merged_is(&whole, folder.path())
}

fn merged_is(whole: &Value, folder: &Path) -> Result<(), Failed> {
    let part = |n: u32| folder.join(format!("part{n}")).display().to_string();
    let merge = format!("merge {} {} {} --json", part(3), part(1), part(2));
    let merged = json(&merge, &folder.join("all"))?;
    same(&merged, whole)?;
    assert!(folder.join("all/report.html").is_file());
    Ok(())
}

fn in_parallel() -> Result<(), Failed> {
    let folder = TempDir::new()?;
    let whole = json(SWEEP, &folder.path().join("whole"))?;
    let status = Command::new("parallel")
        .args(["--will-cite", "-j2", env!("CARGO_BIN_EXE_interreflect")])
        .args(SWEEP.split_whitespace())
        .args(["--shard", "{}/3", "--out", "part{}", ":::", "1", "2", "3"])
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .status()?;
    assert!(status.success());
    merged_is(&whole, folder.path())
}

fn file() -> Result<(), Failed> {
    let folder = TempDir::new()?;
    let study = folder.path().join("study.toml");
    std::fs::write(
        &study,
        "scenes = [\"colored-room\"]\nbackend = \"cpu\"\npoints = 60\nsamples = 32\nrepeat = 9\n\
         [vary]\n\"polygon_form_factor.resolution\" = \"2..8:log2\"\n\
         \"localized_cubemap.resolution\" = [2, 4]\n\
         [set]\n\"polygon_form_factor.capture_resolution\" = 16\n\
         \"localized_cubemap.capture_resolution\" = 16\n",
    )?;
    let by_file = format!("sweep {} --repeat 1 --json", study.display());
    let by_file = json(&by_file, &folder.path().join("file"))?;
    let by_words = json(SWEEP, &folder.path().join("words"))?;
    // The file's order is its own: by name.
    let (by_file, by_words) = (untimed(by_file), untimed(by_words));
    assert_eq!(records(&by_file).len(), records(&by_words).len());
    for record in records(&by_words) {
        let alike = |other: &&Value| {
            ["estimator", "fidelity", "quantity", "params"]
                .iter()
                .all(|name| record[name] == other[name])
        };
        let found: Vec<_> = records(&by_file).iter().filter(alike).collect();
        assert_eq!(found.len(), 1, "runs like {record}");
        if let Some(difference) = difference(found[0], record) {
            return Err(difference.into());
        }
    }
    Ok(())
}

fn axes() -> Result<(), Failed> {
    let out = TempDir::new()?;
    let words = "sweep colored-room --estimator classic_envmap --set classic_envmap.capture_resolution=16 \
         --quantity irradiance --vary scene.receiver.gap=.2,.05 --set scene.receiver.place=wall \
         --vary run.points=30..60:log2 --vary run.threads=1,2 --backend cpu --samples 32 --repeat 1 --json";
    let json = json(words, out.path())?;
    let names: Vec<&str> = records(&json)
        .iter()
        .map(|r| r["scene"].as_str().unwrap())
        .collect();
    assert_eq!(names.len(), 8, "{names:?}");
    assert_eq!(
        names[0],
        "colored-room+receiver.gap=.2+run.points=30+run.threads=1"
    );
    let settings = &records(&json)[7]["settings"];
    assert_eq!(settings["run.points"], 60);
    assert_eq!(settings["run.threads"], 2);
    assert!((settings["scene.receiver.gap"].as_f64().unwrap() - 0.05).abs() < 1e-6);
    // The same scene on one thread and on two: another time, the same estimate.
    assert_eq!(
        records(&json)[0]["truth"]["relmse"],
        records(&json)[1]["truth"]["relmse"]
    );
    Ok(())
}

fn budgets() -> Result<(), Failed> {
    let out = TempDir::new()?;
    let answers = |limits: &str| -> Result<Vec<Value>, Failed> {
        let json = json(&format!("{SWEEP} {limits}"), out.path())?;
        Ok(json["advice"].as_array().unwrap().clone())
    };
    for answer in answers("--budget-ms 100000")? {
        assert_eq!(answer["answer"]["kind"], "use", "{answer}");
        assert!(
            answer["answer"]["choice"]["options"]
                .as_str()
                .unwrap()
                .contains("--set")
        );
    }
    for answer in answers("--max-error 1e-12")? {
        assert_eq!(answer["answer"]["kind"], "nothing", "{answer}");
    }
    Ok(())
}

fn slips() -> Result<(), Failed> {
    let out = TempDir::new()?;
    let refused = |words: &str, told: &str| -> Result<(), Failed> {
        let output = program()
            .args(words.split_whitespace())
            .arg("--out")
            .arg(out.path())
            .output()?;
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{words}: {complaint}");
        assert!(
            complaint.contains(told) && complaint.trim_end().lines().count() == 1,
            "{words}: {complaint}"
        );
        Ok(())
    };
    let room = "sweep colored-room --backend cpu --json --vary";
    refused(
        &format!("{room} localized_cubemap.resolutoin=2"),
        "resolution",
    )?;
    refused(
        &format!("{room} localised_cubemap.resolution=2"),
        "localized_cubemap",
    )?;
    refused(&format!("{room} localized_cubemap.resolution=8..2"), "2..8")?;
    refused(
        &format!("{room} localized_cubemap.resolution=2..4000:log2"),
        "use 1 to 64",
    )?;
    refused(&format!("{room} scene.recever.gap=.1"), "receiver.gap")?;
    refused(&format!("{room} run.point=8"), "points")?;
    refused(
        &format!("{room} localized_cubemap.resolution=2 --shard 3/2"),
        "i/n",
    )?;
    refused(
        "sweep nowhere --backend cpu --json --vary localized_cubemap.resolution=2",
        "nowhere",
    )?;
    refused("merge /nowhere/part1 --json", "/nowhere/part1")
}
