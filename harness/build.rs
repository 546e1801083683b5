//! Hands the compiler's and wgpu's versions to the program, which records them with every result.

use std::{env, fs, path::Path, process::Command};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../Cargo.lock");
    println!("cargo::rustc-env=INTERREFLECT_RUSTC={}", rustc_version());
    println!(
        "cargo::rustc-env=INTERREFLECT_WGPU={}",
        locked_version("wgpu")
    );
}

fn rustc_version() -> String {
    let output =
        env::var_os("RUSTC").and_then(|rustc| Command::new(rustc).arg("--version").output().ok());
    let text = output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned());
    text.unwrap_or_else(|| "unknown".into())
}

/// Version of a package in the workspace's lock file, whose entries start with name and version.
fn locked_version(package: &str) -> String {
    let manifest = env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    let lock = fs::read_to_string(Path::new(&manifest).join("../Cargo.lock")).unwrap_or_default();
    let mut lines = lock.lines();
    let name = format!("name = \"{package}\"");
    let found = lines.find(|l| *l == name).and_then(|_| lines.next());
    let version = found.and_then(|l| l.split('"').nth(1));
    version.unwrap_or("unknown").into()
}
