//! Leaf functions: every `pub fn` of a math.rs gives, on the device, in float32, alone and in lanes, and
//! in float64 the same for one table of inputs as the WGSL function of its name.

use crate::ensure;
use crate::variants::{Outcome, on_gpu};
use interreflect_conformance::verify::parity::{leaf_on_device, leaf_on_host};
use interreflect_estimators::Registry;
use interreflect_estimators::leaves::{self, Leaves};
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};

/// The leaf functions of every folder.
fn folders() -> Vec<&'static Leaves> {
    let registry = Registry::builtin();
    let of_methods = registry.entries().iter().map(|entry| entry.leaves());
    let with_leaves = of_methods.filter(|leaves| !leaves.functions.is_empty());
    leaves::shared().into_iter().chain(with_leaves).collect()
}

pub(crate) fn trials() -> Vec<Trial> {
    let mut trials = vec![Trial::test("leaf_parity/complete", complete)];
    for folder in folders() {
        for leaf in folder.functions {
            let name = format!("leaf_parity/{}/{}", folder.folder, leaf.name);
            if leaf.calls.f32.is_some() {
                trials.push(Trial::test(format!("{name}/cpu"), move || {
                    Ok(leaf_on_host(leaf)?)
                }));
            }
            trials.push(on_gpu(format!("{name}/gpu"), move |context| {
                Ok(leaf_on_device(context, folder, leaf)??)
            }));
        }
    }
    trials
}

/// The folder of the estimators' sources.
fn sources() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../estimators/src"))
}

fn read(path: &Path) -> Result<String, Failed> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()).into())
}

/// Names of the functions of a source that begin a line with `start`.
fn functions(source: &str, start: &str) -> Vec<String> {
    let rest = source.lines().filter_map(|line| line.strip_prefix(start));
    rest.map(|rest| {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        rest[..end.unwrap_or(rest.len())].to_owned()
    })
    .collect()
}

/// Each function of a math.rs has a WGSL twin and is in its folder's list, or is listed as the host's
/// alone; each function of a math.wgsl has its original.
fn complete() -> Outcome {
    let folders = folders();
    let mut known = 0;
    for entry in std::fs::read_dir(sources())? {
        let folder = entry?.path();
        if !folder.join("math.rs").exists() {
            continue;
        }
        let name = folder.file_name().unwrap_or_default().to_string_lossy();
        let listed = folders.iter().find(|leaves| leaves.folder == name);
        let listed = listed.ok_or_else(|| format!("{name}: no list of leaf functions"))?;
        let rust = functions(&read(&folder.join("math.rs"))?, "pub fn ");
        let wgsl = functions(&read(&folder.join("math.wgsl"))?, "fn ");
        for function in &rust {
            let host_only = listed.host_only.contains(&function.as_str());
            let tried = listed.functions.iter().any(|leaf| leaf.name == function);
            ensure!(
                wgsl.contains(function) != host_only,
                "{name}: `{function}` has to have a WGSL twin or to be listed as the host's alone"
            );
            ensure!(
                tried != host_only,
                "{name}: `{function}` has no table of inputs"
            );
        }
        for function in &wgsl {
            ensure!(
                rust.contains(function),
                "{name}: WGSL's `{function}` has no original"
            );
        }
        ensure!(
            listed.functions.len() + listed.host_only.len() == rust.len(),
            "{name}: the list has functions that are not there any more"
        );
        known += 1;
    }
    let lane = 1;
    ensure!(
        known + lane == folders.len(),
        "a list belongs to no folder with a math.rs"
    );
    Ok(())
}
