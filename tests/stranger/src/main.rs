//! A stranger's program: the whole command line, with three more estimators.
//!
//! `cargo run --example stranger -- verify --estimator hemisphere_ambient --estimator boastful`

use interreflect::{CountingAllocator, Entry, Registry, memory, restart_without_driver_chatter};
use interreflect_stranger::{Boastful, BoxProjected, HemisphereAmbient};
use std::alloc::System;
use std::process::ExitCode;

/// Counts memory on the host, which is unknown with any other allocator.
#[global_allocator]
static HEAP: CountingAllocator = CountingAllocator::new(System, usize::MAX);

fn main() -> ExitCode {
    restart_without_driver_chatter();
    memory::count_with(&HEAP);
    let registry = Registry::builtin()
        .with(Entry::both::<HemisphereAmbient>())
        .with(Entry::cpu_only::<BoxProjected>())
        .with(Entry::cpu_only::<Boastful>());
    interreflect::run(registry)
}
