//! Bytes that a step of the work leaves behind.

use cap::Cap;
use interreflect_estimators::execution::BackendScene;
use std::alloc::System;

/// Counts what the program's host memory holds.
#[global_allocator]
static HEAP: Cap<System> = Cap::new(System, usize::MAX);

/// How much was made on a device when it was last looked at.
pub(crate) struct Footprint {
    before: Option<u64>,
}

impl Footprint {
    /// As it is now.
    pub(crate) fn of<S: BackendScene>(scene: &S) -> Self {
        Self {
            before: scene.made_bytes(),
        }
    }

    /// Bytes that were made on the device since the last look; 0 where all is on the host.
    pub(crate) fn more<S: BackendScene>(&mut self, scene: &S) -> u64 {
        let now = scene.made_bytes();
        let more = self.before.zip(now).map_or(0, |(before, now)| now - before);
        self.before = now;
        more
    }
}

/// Bytes of the host's memory that become free with a value. Counted when it goes, not when it comes: then
/// no other thread is at work, and the count is the same each time.
pub(crate) fn freed<T>(value: T) -> u64 {
    let before = HEAP.allocated();
    drop(value);
    before.saturating_sub(HEAP.allocated()) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_goes_is_counted() {
        // Other tests take and return memory beside this one, but not in each of these moments.
        let found: Vec<u64> = (0..1000).map(|_| freed(vec![0_u64; 1 << 20])).collect();
        assert!(found.contains(&(8 << 20)), "{:?}", &found[..20]);
    }
}
