//! Times of recorded work, by the GPU's own clock where it has one.

use crate::{GpuContext, GpuError};
use std::sync::{Mutex, PoisonError};

/// How long recorded work took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GpuTime {
    /// Milliseconds by the host's clock, from the start of recording to completion: includes the
    /// overhead of recording, submitting and waiting.
    pub wall_ms: f64,
    /// Milliseconds by the GPU's clock, from the start of the first submission to the end of the last,
    /// or why there are none.
    pub device_ms: Result<f64, Mistimed>,
}

impl GpuTime {
    /// Milliseconds by the better clock that there is.
    pub fn ms(&self) -> f64 {
        self.device_ms.unwrap_or(self.wall_ms)
    }
}

/// Why the GPU's clock did not time some work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
pub enum Mistimed {
    /// The device has none.
    #[error("the device has no timestamps")]
    NoClock,
    /// The end lies before the start.
    #[error("the device's clock went backwards")]
    Backwards,
    /// Passes ran, and no time passed.
    #[error("the device's clock stood still while work ran")]
    Still,
    /// Longer than the host waited for it.
    #[error("the device's clock counted more time than passed on the host")]
    TooLong,
}

/// Judges the ticks of a start and an end: `worked` if passes ran between them, within `wall_ms`.
fn device_ms(
    start: u64,
    end: u64,
    tick_ms: f64,
    worked: bool,
    wall_ms: f64,
) -> Result<f64, Mistimed> {
    let ticks = end.checked_sub(start).ok_or(Mistimed::Backwards)?;
    let ms = ticks as f64 * tick_ms;
    match ms {
        0.0 if worked => Err(Mistimed::Still),
        ms if ms > wall_ms => Err(Mistimed::TooLong),
        ms => Ok(ms),
    }
}

/// Milliseconds of a tick of `period_ns`; `None` where the device has no timestamps.
fn tick_ms(features: wgpu::Features, period_ns: f32) -> Option<f64> {
    let needed = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS;
    (features.contains(needed) && period_ns > 0.0).then(|| f64::from(period_ns) * 1e-6)
}

/// A start and an end, and where they are resolved to.
pub(crate) struct Timestamps {
    queries: wgpu::QuerySet,
    resolved: wgpu::Buffer,
}

/// Pairs of timestamps, one for each recording that is open at the same time.
pub(crate) struct TimestampPool {
    /// Milliseconds of a tick; `None` where the device has no timestamps.
    tick_ms: Option<f64>,
    free: Mutex<Vec<Timestamps>>,
}

/// Queries of a pair.
const START: u32 = 0;
const END: u32 = 1;

/// Bytes between the resolved start and the resolved end.
const STRIDE: u64 = wgpu::QUERY_RESOLVE_BUFFER_ALIGNMENT;

impl TimestampPool {
    pub(crate) fn new(device: &wgpu::Device, queue: &wgpu::Queue) -> Self {
        Self {
            tick_ms: tick_ms(device.features(), queue.get_timestamp_period()),
            free: Mutex::default(),
        }
    }

    /// A free pair, or a new one; `None` where the device has no timestamps.
    pub(crate) fn take(&self, device: &wgpu::Device) -> Option<Timestamps> {
        self.tick_ms?;
        let free = self
            .free
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .pop();
        Some(free.unwrap_or_else(|| Timestamps::new(device)))
    }

    pub(crate) fn give_back(&self, timestamps: Timestamps) {
        self.free
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(timestamps);
    }
}

impl Timestamps {
    fn new(device: &wgpu::Device) -> Self {
        Self {
            queries: device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: 2 * STRIDE,
                usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
                mapped_at_creation: false,
            }),
        }
    }

    pub(crate) fn start(&self, encoder: &mut wgpu::CommandEncoder) {
        self.stamp(encoder, START);
    }

    pub(crate) fn end(&self, encoder: &mut wgpu::CommandEncoder) {
        self.stamp(encoder, END);
    }

    /// Writes a timestamp and resolves it before anything else runs. Each by itself, for a software
    /// rasteriser may put a timestamp off like a triangle, until its tiles are drawn: after a
    /// capture, lavapipe took a start that was resolved with the end only when the compute work
    /// between them was done, and 600 ms of work were reported as 0.02 ms.
    fn stamp(&self, encoder: &mut wgpu::CommandEncoder, query: u32) {
        encoder.write_timestamp(&self.queries, query);
        let offset = u64::from(query) * STRIDE;
        encoder.resolve_query_set(&self.queries, query..query + 1, &self.resolved, offset);
    }

    /// Milliseconds between start and end, once both have run.
    pub(crate) fn read(
        &self,
        context: &GpuContext,
        worked: bool,
        wall_ms: f64,
    ) -> Result<Result<f64, Mistimed>, GpuError> {
        let words: Vec<u64> = context.read_buffer(&self.resolved)?;
        let ticks = |query: u32| words.get((u64::from(query) * STRIDE / 8) as usize);
        Ok(
            match (context.timestamps.tick_ms, ticks(START), ticks(END)) {
                (Some(tick_ms), Some(&start), Some(&end)) => {
                    device_ms(start, end, tick_ms, worked, wall_ms)
                }
                _ => Err(Mistimed::NoClock),
            },
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn impossible_times_are_refused() {
        assert_eq!(device_ms(100, 350, 0.01, true, 3.0), Ok(2.5));
        assert_eq!(
            device_ms(350, 100, 0.01, true, 3.0),
            Err(Mistimed::Backwards)
        );
        assert_eq!(device_ms(100, 100, 0.01, true, 3.0), Err(Mistimed::Still));
        assert_eq!(device_ms(100, 100, 0.01, false, 3.0), Ok(0.0));
        assert_eq!(device_ms(0, 350, 0.01, true, 3.0), Err(Mistimed::TooLong));
    }

    /// Software drivers count nanoseconds; others, say, 52.08 ns (19.2 MHz) or 10 ns a tick.
    #[test]
    fn a_tick_lasts_as_long_as_the_device_says() {
        let all = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS;
        for (period_ns, ms_of_a_million) in [(1.0, 1.0), (10.0, 10.0), (52.083_332, 52.083_332)] {
            let tick = tick_ms(all, period_ns).expect("timestamps");
            let ms = device_ms(500, 1_000_500, tick, true, 1e3).expect("a time");
            assert!(
                (ms - ms_of_a_million).abs() < 1e-6,
                "{period_ns} ns: {ms} ms"
            );
        }
        assert_eq!(tick_ms(all, 0.0), None);
        assert_eq!(tick_ms(wgpu::Features::TIMESTAMP_QUERY, 1.0), None);
        assert_eq!(tick_ms(wgpu::Features::empty(), 1.0), None);
    }
}
