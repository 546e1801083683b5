//! A stranger's program: the whole command line, with two more estimators.
//!
//! `cargo run --example stranger -- verify --estimator hemisphere_ambient --estimator boastful`

use interreflect_estimators::{Entry, Registry};
use interreflect_stranger::{Boastful, HemisphereAmbient};
use std::process::ExitCode;

fn main() -> ExitCode {
    let registry = Registry::builtin()
        .with(Entry::cpu_only::<HemisphereAmbient>())
        .with(Entry::cpu_only::<Boastful>());
    interreflect::run(registry)
}
