//! Bytes that a step of the work leaves behind.

use cap::Cap;
use interreflect_estimators::execution::BackendScene;
use std::alloc::System;
use std::sync::OnceLock;

/// An allocator that counts what the program's host memory holds: a program's `#[global_allocator]`, if it
/// wants memory on the host to be known.
pub type CountingAllocator = Cap<System>;

/// The program's allocator, if it counts.
static HEAP: OnceLock<&CountingAllocator> = OnceLock::new();

/// Has memory on the host counted by the program's allocator; without it, that memory is unknown. The first
/// call holds.
pub fn count_with(allocator: &'static CountingAllocator) {
    // One that holds nothing is not the program's.
    if allocator.allocated() > 0 {
        HEAP.get_or_init(|| allocator);
    }
}

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

/// Bytes of the host's memory that become free with a value; `None` where nobody counts. Counted when it
/// goes, not when it comes: then no other thread is at work, and the count is the same each time.
pub(crate) fn freed<T>(value: T) -> Option<u64> {
    let heap = HEAP.get()?;
    let before = heap.allocated();
    drop(value);
    Some(before.saturating_sub(heap.allocated()) as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[global_allocator]
    static COUNTING: CountingAllocator = CountingAllocator::new(System, usize::MAX);

    static IDLE: CountingAllocator = CountingAllocator::new(System, usize::MAX);

    #[test]
    fn what_goes_is_counted_by_the_program_s_allocator_alone() {
        count_with(&IDLE);
        assert_eq!(freed(vec![0_u64; 1 << 20]), None);
        count_with(&COUNTING);
        let bytes = freed(vec![0_u64; 1 << 20]);
        // Other tests run beside this one.
        assert!(
            bytes.is_some_and(|b| (7 << 20..9 << 20).contains(&b)),
            "{bytes:?}"
        );
    }
}
