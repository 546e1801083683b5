//! The `interreflect` command.

use interreflect::{CountingAllocator, memory, restart_without_driver_chatter};
use interreflect_estimators::Registry;
use std::alloc::System;
use std::process::ExitCode;

/// Counts what the program's host memory holds.
#[global_allocator]
static HEAP: CountingAllocator = CountingAllocator::new(System, usize::MAX);

fn main() -> ExitCode {
    restart_without_driver_chatter();
    memory::count_with(&HEAP);
    interreflect::run(Registry::builtin())
}
