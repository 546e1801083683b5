//! Where and with which build a result came about.

use interreflect_scene::digest;
use serde::{Deserialize, Serialize};
use std::{path::Path, process::Command};

/// Provenance of a set of results.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's own name for itself.
    pub cpu: String,
    /// Worker threads of the CPU backend.
    pub threads: usize,
    /// Instruction set of the CPU kernels.
    pub instruction_set: String,
    /// Name of the Vulkan adapter; `None` if none was used.
    pub adapter: Option<String>,
    /// Name and version of the adapter's driver.
    pub driver: Option<String>,
    /// Whether the adapter runs on the CPU.
    pub software: Option<bool>,
    /// Commit of the checkout that the binary was built in, as it is when the program runs, or
    /// `unknown`.
    pub commit: String,
    /// Whether that source differs from the commit; `None` if unknown.
    pub dirty: Option<bool>,
    /// Operating system and processor architecture.
    pub platform: String,
    /// Versions of what matters for the results.
    pub versions: Versions,
}

/// Versions, as of the build.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Versions {
    /// This program.
    pub interreflect: String,
    /// The compiler.
    pub rustc: String,
    /// The GPU library.
    pub wgpu: String,
    /// `release` or `dev`: times of a dev build mean nothing.
    pub profile: String,
}

impl Versions {
    /// Versions of this build.
    pub fn current() -> Self {
        Self {
            interreflect: env!("CARGO_PKG_VERSION").into(),
            rustc: env!("INTERREFLECT_RUSTC").into(),
            wgpu: env!("INTERREFLECT_WGPU").into(),
            profile: if cfg!(debug_assertions) {
                "dev"
            } else {
                "release"
            }
            .into(),
        }
    }
}

/// What is known of a Vulkan adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adapter {
    /// Name of the device.
    pub name: String,
    /// Name and version of the driver.
    pub driver: String,
    /// Whether it runs on the CPU.
    pub software: bool,
}

impl Machine {
    /// Looks at this machine; what the CPU and GPU backends know of themselves is handed in.
    pub fn detect(threads: usize, instruction_set: &str, adapter: Option<&Adapter>) -> Self {
        let source = Source::of(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
        Self {
            cpu: cpu_model(),
            threads,
            instruction_set: instruction_set.into(),
            adapter: adapter.map(|a| a.name.clone()),
            driver: adapter.map(|a| a.driver.clone()),
            software: adapter.map(|a| a.software),
            commit: source.commit,
            dirty: source.dirty,
            platform: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            versions: Versions::current(),
        }
    }

    /// A short name for the machine, adapter and threads that times are of.
    pub fn id(&self) -> String {
        let of = (
            &self.cpu,
            self.threads,
            &self.instruction_set,
            &self.adapter,
            &self.driver,
        );
        digest(&(of, &self.platform, &self.versions))[..8].to_owned()
    }

    /// The adapter with its driver, and a plain word where it runs on the CPU.
    pub fn adapter_label(&self) -> String {
        let Some(adapter) = &self.adapter else {
            return "none".into();
        };
        let driver = self.driver.as_deref().unwrap_or("unknown driver");
        match self.software {
            Some(true) => format!("{adapter}, {driver} (SOFTWARE: runs on the CPU)"),
            _ => format!("{adapter}, {driver}"),
        }
    }

    /// The first twelve digits of the commit, with `-dirty` where the source differs from it.
    pub fn commit_label(&self) -> String {
        let short = self.commit.get(..12).unwrap_or(&self.commit);
        let suffix = if self.dirty == Some(true) {
            "-dirty"
        } else {
            ""
        };
        format!("{short}{suffix}")
    }
}

/// State of the source tree that this binary was built from, looked up when the program runs.
///
/// The tree is the workspace folder that the compiler saw. Where it is gone, is no checkout or git
/// is not installed, the commit is `unknown`: a copied binary never claims another commit's name.
/// A tree that was changed after the build is reported as it is now.
struct Source {
    commit: String,
    dirty: Option<bool>,
}

impl Source {
    fn of(tree: &Path) -> Self {
        Self {
            commit: git(tree, &["rev-parse", "HEAD"]).unwrap_or_else(|| "unknown".into()),
            dirty: git(tree, &["status", "--porcelain"]).map(|changes| !changes.is_empty()),
        }
    }
}

/// Standard output of a git command without the final line break; `None` if it failed.
fn git(tree: &Path, arguments: &[&str]) -> Option<String> {
    let mut command = Command::new("git");
    command.env_remove("GIT_DIR").env_remove("GIT_WORK_TREE");
    let output = command.arg("-C").arg(tree).args(arguments).output();
    let output = output.ok().filter(|o| o.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim_end().into())
}

fn cpu_model() -> String {
    let named = std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| model_name(&text));
    named.unwrap_or_else(|| format!("unknown {}", std::env::consts::ARCH))
}

/// The first `model name` of a Linux `/proc/cpuinfo`.
fn model_name(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|l| l.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().into())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;

    #[test]
    fn the_model_name_is_read_from_cpuinfo() {
        let text = "processor\t: 0\nmodel name\t: Some CPU @ 2.0GHz\nflags\t: a b\n";
        assert_eq!(model_name(text).unwrap(), "Some CPU @ 2.0GHz");
        assert_eq!(model_name("Processor: x"), None);
    }

    #[test]
    fn a_folder_outside_any_checkout_has_no_commit() {
        let folder = tempfile::tempdir().unwrap();
        // Where the folder for temporary files lies in a checkout, git looks no further than here.
        std::fs::write(folder.path().join(".git"), "").unwrap();
        let source = Source::of(folder.path());
        assert_eq!((source.commit.as_str(), source.dirty), ("unknown", None));
    }

    #[test]
    fn a_changed_checkout_is_dirty() {
        let folder = tempfile::tempdir().unwrap();
        let run = |arguments: &[&str]| git(folder.path(), arguments);
        if run(&["init", "-q"]).is_none() {
            eprintln!("skipped: git is not installed");
            return;
        }
        let own = [
            "user.name=a",
            "user.email=a@b.invalid",
            "commit.gpgsign=false",
        ];
        let own = own.map(|setting| ["-c", setting]).concat();
        let commit = [&own[..], &["commit", "-q", "--allow-empty", "-m", "x"]].concat();
        run(&commit).unwrap();
        let clean = Source::of(folder.path());
        assert_eq!((clean.commit.len(), clean.dirty), (40, Some(false)));
        std::fs::write(folder.path().join("new"), "x").unwrap();
        assert_eq!(Source::of(folder.path()).dirty, Some(true));
    }

    #[test]
    fn software_adapters_are_named_so() {
        let adapter = Adapter {
            name: "llvmpipe".into(),
            driver: "Mesa 22.3.6".into(),
            software: true,
        };
        let machine = Machine::detect(2, "avx2", Some(&adapter));
        assert!(machine.adapter_label().contains("SOFTWARE"));
        assert_eq!(machine.threads, 2);
        assert_eq!(Machine::detect(2, "avx2", None).adapter_label(), "none");
    }
}
