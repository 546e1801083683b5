//! The program as others call it: words of its JSON, exit codes, and what it leaves behind.
//! Long because it is mostly one table of bad usages.
#![allow(clippy::unwrap_used, reason = "tests")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder with what the commands read.
struct Folder(tempfile::TempDir);

/// A triangle above two points, one of them with a direction to the viewer.
const TRIANGLE: &str = "v -1 1 -1\nv 1 1 -1\nv 0 1 1\nf 1 2 3\n";
const POINTS: &str =
    "x,y,z,nx,ny,nz,vx,vy,vz,note\n0,0,0,0,1,0,0,1,0,here\n.5,0,0,0,2,0,0,1,1,there\n";

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        folder.write("triangle.obj", TRIANGLE);
        folder.write("points.csv", POINTS);
        folder
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path().join(name), text).unwrap();
    }

    /// Runs a command line in the folder.
    fn run(&self, line: &str) -> Output {
        Command::new(env!("CARGO_BIN_EXE_interreflect"))
            .args(line.split_whitespace())
            .current_dir(self.path())
            .output()
            .unwrap()
    }

    /// Standard output as JSON, after success.
    fn json(&self, line: &str) -> Value {
        let output = self.run(line);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "`{line}`: {complaint}");
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// Everything below a folder, sorted.
    fn files(&self, below: &str) -> Vec<PathBuf> {
        let mut found = Vec::new();
        let mut folders = vec![self.path().join(below)];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(&folder).into_iter().flatten() {
                let path = entry.unwrap().path();
                match path.is_dir() {
                    true => folders.push(path),
                    false => found.push(path.strip_prefix(self.path()).unwrap().to_owned()),
                }
            }
        }
        found.sort();
        found
    }
}

fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<_> = value
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    keys.sort_unstable();
    keys
}

#[test]
fn probe_prints_one_value_a_point() {
    let folder = Folder::new();
    for (options, quantity) in [
        ("", "irradiance"),
        ("--quantity irradiance", "irradiance"),
        (
            "--quantity glossy_radiance --material .5,.5,5",
            "glossy_radiance",
        ),
    ] {
        let line = format!(
            "probe furnace --reference-point .2,-.1,.3 --estimator constant_ambient \
             --set capture_resolution=8 --backend cpu --points points.csv --json {options}"
        );
        let probed = folder.json(&line);
        assert_eq!(
            keys(&probed),
            ["backend", "estimator", "quantity", "values"]
        );
        assert_eq!(probed["estimator"], "constant_ambient");
        assert_eq!(probed["backend"], "cpu");
        assert_eq!(probed["quantity"], quantity);
        let values = probed["values"].as_array().unwrap();
        assert_eq!(values.len(), 2);
        for value in values {
            assert_eq!(value.as_array().unwrap().len(), 3);
            let expected = if quantity == "irradiance" {
                std::f64::consts::PI
            } else {
                1.0
            };
            // Float32, and a mean of 384 equal numbers.
            assert!(
                (value[0].as_f64().unwrap() / expected - 1.0).abs() < 1e-6,
                "{value}"
            );
        }
    }
}

#[test]
fn probe_runs_where_there_are_only_surfaces() {
    let folder = Folder::new();
    folder.write("glowing.mtl", "newmtl glowing\nKe 1 2 3\n");
    folder.write(
        "glowing.obj",
        "mtllib glowing.mtl\nusemtl glowing\nv -1 1 -1\nv 1 1 -1\nv 0 1 1\nf 1 2 3\n",
    );
    let line = "probe glowing.obj --reference-point 0,0,0 --estimator localized_cubemap \
                --set capture_resolution=8 --points points.csv --json";
    let probed = folder.json(line);
    let values = probed["values"].as_array().unwrap();
    assert_eq!(values.len(), 2);
    for value in values {
        let [r, g, b] = [0, 1, 2].map(|c| value[c].as_f64().unwrap());
        assert!(
            0.0 < r && r < g && g < b && b < 3.0 * std::f64::consts::PI,
            "{value}"
        );
    }
}

/// Scene and methods so small that a run takes no time; the patience is for machines that are busy
/// with something else.
const BENCH: &str = "bench furnace --estimator constant_ambient --estimator localized_cubemap \
                     --set constant_ambient.capture_resolution=8 \
                     --set localized_cubemap.capture_resolution=8 \
                     --set localized_cubemap.resolution=2 \
                     --points 64 --samples 32 --repeat 2 --patience 600000 --backend cpu";

#[test]
fn bench_prints_machine_and_runs() {
    let folder = Folder::new();
    let results = folder.json(&format!("{BENCH} --json"));
    assert_eq!(
        keys(&results),
        ["command", "invocation", "machine", "runs", "seed"]
    );
    for word in [
        "cpu",
        "threads",
        "instruction_set",
        "adapter",
        "driver",
        "software",
        "commit",
        "dirty",
        "versions",
    ] {
        assert!(results["machine"].get(word).is_some(), "machine.{word}");
    }
    let runs = results["runs"].as_array().unwrap();
    // One fidelity of the first, two of the second, two quantities.
    assert_eq!(runs.len(), 6);
    for run in runs {
        bench_run(run);
    }
    let fidelities: Vec<_> = runs.iter().map(|r| &r["fidelity"]).collect();
    assert!(fidelities.contains(&&Value::Null));
    assert!(fidelities.contains(&&"published".into()));
    assert!(fidelities.contains(&&"corrected".into()));
    assert_eq!(
        folder.files("").len(),
        2,
        "nothing is written without --out"
    );
}

fn bench_run(run: &Value) {
    for word in ["scene", "estimator", "backend", "quantity"] {
        assert!(run[word].is_string(), "{word} in {run}");
    }
    assert!(run.get("fidelity").is_some() && run["params"].is_object());
    assert_eq!(run["params"]["capture_resolution"], 8);
    assert!(run["points"].as_u64().unwrap() > 0);
    let phases = &run["phases_ms"];
    assert_eq!(
        keys(phases),
        ["capture", "compile", "prepare", "readback", "shade"]
    );
    for phase in ["capture", "prepare", "shade"] {
        for word in ["high", "low", "mad", "median", "n", "settled", "source"] {
            assert!(phases[phase].get(word).is_some(), "{word} of {phase}");
        }
        assert!(phases[phase]["median"].as_f64().unwrap() >= 0.0);
        assert_eq!(phases[phase]["n"], 2);
    }
    // The CPU compiles nothing and reads nothing back.
    assert!(phases["compile"].is_null() && phases["readback"].is_null());
    for model in ["own_model", "truth"] {
        for word in [
            "relmse",
            "rmse",
            "energy_ratio",
            "p999",
            "max",
            "noise_floor",
        ] {
            assert!(run[model][word].is_number(), "{model}.{word} in {run}");
        }
        let verdict = run[model]["verdict"].as_str().unwrap();
        assert!(
            ["conclusive", "inconclusive"].contains(&verdict),
            "{verdict}"
        );
    }
}

#[test]
fn bench_leaves_whole_files_under_their_names() {
    let folder = Folder::new();
    let output = folder.run(&format!("{BENCH} --quantity irradiance --out made/here"));
    assert!(output.status.success());
    let table = String::from_utf8(output.stdout).unwrap();
    assert!(
        table.contains("constant_ambient") && table.contains("report.html"),
        "{table}"
    );
    assert!(!table.contains('\u{1b}'), "colours in a pipe");
    let files = folder.files("made");
    for name in ["results.json", "results.csv", "report.html"] {
        assert!(
            files.contains(&Path::new("made/here").join(name)),
            "{files:?}"
        );
    }
    for file in &files {
        let name = file.file_name().unwrap().to_string_lossy();
        let whole = ["json", "csv", "html", "png", "exr"]
            .iter()
            .any(|e| name.ends_with(e));
        assert!(whole && !name.starts_with('.'), "{file:?} is left behind");
    }
    let read = |name: &str| std::fs::read_to_string(folder.path().join("made/here").join(name));
    let results: Value = serde_json::from_str(&read("results.json").unwrap()).unwrap();
    assert_eq!(results["runs"].as_array().unwrap().len(), 3);
    let report = read("report.html").unwrap();
    assert!(
        report.trim_end().ends_with("</html>"),
        "the report is cut off"
    );
    let elsewhere = ["src=\"http", "href=\"http", "url(http"];
    assert!(
        elsewhere.iter().all(|w| !report.contains(w)),
        "the report needs the network"
    );
}

/// What is refused, with words that the one line on standard error must have.
const REFUSED: &[(&str, &[&str])] = &[
    ("", &["subcommand"]),
    ("probe", &["--estimator", "--points"]),
    ("bench cornel-box", &["cornel-box", "cornell-box"]),
    ("bench missing.toml", &["missing.toml"]),
    (
        "bench furnace --estimator localised_cubemap",
        &["localised_cubemap", "localized_cubemap"],
    ),
    (
        "bench furnace --set resolution=8",
        &["resolution=8", "constant_ambient.resolution"],
    ),
    (
        "bench furnace --set path_reference.sample=8",
        &["path_reference", "sample", "samples"],
    ),
    ("bench furnace --set scene.albedo=2", &["albedo", "2"]),
    ("bench furnace --set scene.albedp=.2", &["albedp", "albedo"]),
    ("bench furnace --threads 0", &["--threads"]),
    ("bench furnace --backend cuda", &["cuda", "cpu"]),
    (
        "bench furnace --receiver missing.obj --backend cpu",
        &["missing.obj"],
    ),
    (
        "bench furnace --environment missing.hdr --backend cpu",
        &["missing.hdr"],
    ),
    ("compare a.exr b.exr", &["a.exr"]),
    ("report missing", &["missing", "bench --out"]),
    (
        "bench furnace --backend cpu --tev=localhost:1",
        &["localhost:1", "--tev"],
    ),
    ("render furnace --estimator nothing", &["nothing"]),
    (
        "reference furnace --set samples=0 --samples 32",
        &["samples", "0"],
    ),
    (
        "probe furnace --estimator constant_ambient --points missing.csv",
        &["missing.csv"],
    ),
    (
        "probe furnace --estimator constant_ambient --points short.csv",
        &["short.csv:3", "header"],
    ),
    (
        "probe furnace --estimator constant_ambient --points word.csv",
        &["word.csv:2", "up"],
    ),
    (
        "probe furnace --estimator constant_ambient --points zero.csv",
        &["zero.csv:2"],
    ),
    (
        "probe furnace --estimator constant_ambient --points header.csv",
        &["header.csv", "point"],
    ),
    (
        "probe furnace --estimator constant_ambient --points columns.csv",
        &["columns.csv:1", "nz"],
    ),
    (
        "probe furnace --estimator constant_ambient --points points.csv --set x=1",
        &["`x`"],
    ),
    (
        "probe furnace --estimator localized_cubemap --points points.csv --set resolution=0",
        &["resolution", "0", "64"],
    ),
    (
        "probe furnace --estimator localized_cubemap --points points.csv --set fidelity=true",
        &["fidelity", "published", "corrected"],
    ),
    (
        "probe furnace --estimator constant_ambient --points points.csv --quantity glossy_radiance",
        &["--material"],
    ),
    (
        "probe furnace --estimator constant_ambient --points plain.csv --quantity glossy_radiance \
         --material .5,.5,5",
        &["plain.csv", "vx,vy,vz"],
    ),
    (
        "probe furnace --estimator constant_ambient --points points.csv --quantity \
         ambient_occlusion",
        &["ambient_occlusion", "irradiance"],
    ),
    (
        "probe broken.obj --estimator constant_ambient --points points.csv",
        &["broken.obj:4"],
    ),
    (
        "probe broken.toml --estimator constant_ambient --points points.csv",
        &["broken.toml"],
    ),
];

#[test]
fn bad_usage_and_input_are_one_line_and_code_2() {
    let folder = Folder::new();
    folder.write("short.csv", "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n0,0,0\n");
    folder.write("word.csv", "x,y,z,nx,ny,nz\n0,0,0,0,up,0\n");
    folder.write("zero.csv", "x,y,z,nx,ny,nz\n0,0,0,0,0,0\n");
    folder.write("header.csv", "x,y,z,nx,ny,nz\n");
    folder.write("columns.csv", "x,y,z,nx,ny\n0,0,0,0,1\n");
    folder.write("plain.csv", "x,y,z,nx,ny,nz\n0,0,0,0,1,0\n");
    folder.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    folder.write("broken.toml", "name = \"broken\"\nnothing = 1\n");
    let before = folder.files("");
    for (line, words) in REFUSED {
        refused(&folder, line, words);
    }
    assert_eq!(folder.files(""), before, "a refused command left files");
}

fn refused(folder: &Folder, line: &str, words: &[&str]) {
    let output = folder.run(line);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "`{line}`: {complaint}");
    assert!(output.stdout.is_empty(), "`{line}` printed something");
    assert_eq!(complaint.lines().count(), 1, "`{line}`: {complaint}");
    for word in words {
        assert!(
            complaint.contains(word),
            "`{line}`: no `{word}` in: {complaint}"
        );
    }
}

/// With an adapter the name is unknown; without one the message says how to get one.
#[test]
fn an_unknown_adapter_is_refused() {
    let folder = Folder::new();
    let line = "probe furnace --estimator constant_ambient --points points.csv --backend gpu \
                --adapter abacus";
    let output = folder.run(line);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(complaint.lines().count(), 1, "{complaint}");
    match output.status.code() {
        Some(2) => assert!(complaint.contains("abacus"), "{complaint}"),
        code => assert!(
            code == Some(1) && complaint.contains("apt-get"),
            "{complaint}"
        ),
    }
}

/// Without an adapter the device is what is missing first.
#[test]
fn a_method_without_a_gpu_says_so() {
    let folder = Folder::new();
    let line = "probe furnace --estimator path_reference --points points.csv --backend gpu";
    let output = folder.run(line);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert_eq!(complaint.lines().count(), 1, "{complaint}");
    match output.status.code() {
        Some(2) => assert!(complaint.contains("path_reference"), "{complaint}"),
        code => assert!(
            code == Some(1) && complaint.contains("apt-get"),
            "{complaint}"
        ),
    }
}
