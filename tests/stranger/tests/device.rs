//! A method from outside is put to the same checks on a device, those between backends among them. Without an
//! adapter the test shows as ignored, with the reason; with `INTERREFLECT_REQUIRE_GPU=1` it then fails.

mod program;

use interreflect::prelude::GpuContext;
use libtest_mimic::{Arguments, Failed, Trial};

/// What `verify` compares with the same method on the CPU.
const PARITY: [&str; 4] = [
    "shaders_valid",
    "leaf_parity",
    "record_parity",
    "estimate_parity",
];

fn main() {
    let name = "the_backends_agree";
    let required = std::env::var_os("INTERREFLECT_REQUIRE_GPU").is_some_and(|v| v == "1");
    let trial = match GpuContext::new(None) {
        Ok(_) => Trial::test(name, the_backends_agree),
        Err(reason) if required => Trial::test(name, move || Err(reason.into())),
        Err(_) => Trial::test(name, || Ok(()))
            .with_ignored_flag(true)
            .with_kind("no Vulkan adapter"),
    };
    libtest_mimic::run(&Arguments::from_args(), vec![trial]).exit();
}

fn the_backends_agree() -> Result<(), Failed> {
    let line = "verify --backend gpu --json --cases 4 --estimator hemisphere_ambient";
    let output = program::run(&line.split_whitespace().collect::<Vec<_>>());
    let json = program::json(&output);
    let passed = program::names(&json, "passed");
    let missing = PARITY.iter().find(|name| !passed.contains(name));
    match missing {
        None if output.status.success() => Ok(()),
        None => Err(format!("failed: {:?}", program::names(&json, "failed")).into()),
        Some(name) => Err(format!("{name} did not pass: {json}").into()),
    }
}
