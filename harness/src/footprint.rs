//! Bytes that a step of the work leaves behind.

use cap::Cap;
use interreflect_estimators::stage::Stage;
use std::alloc::System;

/// Counts what the program's host memory holds.
#[global_allocator]
static HEAP: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes of a page.
const PAGE: u64 = 4096;

/// Where the work's data lies, and how much of it there was when it was last looked at.
pub(crate) struct Footprint {
    before: u64,
}

impl Footprint {
    /// As it is now.
    pub(crate) fn of<S: Stage>(stage: &S) -> Self {
        Self {
            before: held(stage),
        }
    }

    /// Bytes that came since the last look: on a device what was made, on the host whole pages of what is
    /// kept, since threads keep a little of their own.
    pub(crate) fn more<S: Stage>(&mut self, stage: &S) -> u64 {
        let now = held(stage);
        let more = now.saturating_sub(self.before);
        self.before = now;
        match stage.made_bytes() {
            Some(_) => more,
            None => more.next_multiple_of(PAGE),
        }
    }
}

fn held<S: Stage>(stage: &S) -> u64 {
    stage.made_bytes().unwrap_or(HEAP.allocated() as u64)
}
