//! Whether the processor is as fast as it was: a fixed piece of work, timed again and again.

use std::hint::black_box;
use std::time::Instant;

/// Multiplications of the fixed work: about a millisecond.
const WORK: u32 = 1 << 19;

/// Times of which the least counts: what else runs can only add.
const TIMES: usize = 3;

/// How much slower than at its best the processor may be before it is remarked.
const SLOWER: f64 = 1.15;

/// The processor's speed over a session, by the same work each time.
#[derive(Clone, Copy, Debug)]
pub struct Throttle {
    best_ms: f64,
}

impl Throttle {
    /// Begins with the speed as it is now.
    pub fn new() -> Self {
        Self { best_ms: work_ms() }
    }

    /// How many times longer than at best the work takes now, if that is worth a remark: the processor
    /// is throttled, or shared.
    pub fn slowed(&mut self) -> Option<f64> {
        let now_ms = work_ms();
        self.best_ms = self.best_ms.min(now_ms);
        let slower = now_ms / self.best_ms;
        (slower > SLOWER).then_some(slower)
    }
}

impl Default for Throttle {
    fn default() -> Self {
        Self::new()
    }
}

/// The least of some times of the fixed work, in milliseconds.
fn work_ms() -> f64 {
    let once = || {
        let start = Instant::now();
        // Each product waits for the one before: neither lanes nor memory matter.
        let mut state = black_box(1_u64);
        for _ in 0..WORK {
            state = state.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (state >> 7);
        }
        black_box(state);
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..TIMES).map(|_| once()).fold(f64::INFINITY, f64::min)
}
