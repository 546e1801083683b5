//! The `interreflect` command.

use interreflect_estimators::Registry;
use std::process::ExitCode;

fn main() -> ExitCode {
    interreflect::run(Registry::builtin())
}
