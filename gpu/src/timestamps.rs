//! Times of recorded work, by the GPU's own clock where it has one.

use crate::{GpuContext, GpuError};
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// How long recorded work took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GpuTime {
    /// Milliseconds from the start of the first submission to the end of the last.
    pub ms: f64,
    /// The clock.
    pub source: TimeSource,
}

/// The clock that measured a [`GpuTime`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TimeSource {
    /// Timestamps of the GPU: the work alone.
    Timestamp,
    /// The host's clock from submission to completion, where the GPU has no timestamps or they
    /// contradict it: includes the overhead of recording, submitting and waiting.
    WallClock,
}

impl fmt::Display for TimeSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Timestamp => "GPU timestamps",
            Self::WallClock => "wall clock",
        })
    }
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
        let needed =
            wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS;
        let tick_ms = f64::from(queue.get_timestamp_period()) * 1e-6;
        Self {
            tick_ms: (device.features().contains(needed) && tick_ms > 0.0).then_some(tick_ms),
            free: Mutex::default(),
        }
    }

    pub(crate) fn available(&self) -> bool {
        self.tick_ms.is_some()
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

    /// Milliseconds between start and end, once both have run; `None` if the clock went backwards.
    pub(crate) fn read_ms(&self, context: &GpuContext) -> Result<Option<f64>, GpuError> {
        let Some(tick_ms) = context.timestamps.tick_ms else {
            return Ok(None);
        };
        let words: Vec<u64> = context.read_buffer(&self.resolved)?;
        let ticks = |query: u32| words.get((u64::from(query) * STRIDE / 8) as usize);
        let passed = match (ticks(START), ticks(END)) {
            (Some(start), Some(end)) => end.checked_sub(*start),
            _ => None,
        };
        Ok(passed.map(|t| t as f64 * tick_ms))
    }
}
