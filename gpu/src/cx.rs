//! Recording work.

use crate::{GpuContext, GpuError, GpuTime, Mistimed};
use std::sync::Arc;
use std::time::Instant;

/// An open command encoder: what is recorded into it runs when the recording ends.
pub struct GpuCx {
    context: Arc<GpuContext>,
    encoder: wgpu::CommandEncoder,
    passes: Vec<&'static str>,
}

impl GpuCx {
    fn new(context: &Arc<GpuContext>) -> Self {
        Self {
            context: Arc::clone(context),
            encoder: open(context),
            passes: Vec::new(),
        }
    }

    /// Labels of the passes that were recorded so far, in order: what the work asks of the device.
    pub fn passes(&self) -> &[&'static str] {
        &self.passes
    }

    /// The encoder, for a pass of this label.
    pub(crate) fn begin(&mut self, label: &'static str) -> &mut wgpu::CommandEncoder {
        self.passes.push(label);
        &mut self.encoder
    }

    /// The context that records.
    pub fn context(&self) -> &Arc<GpuContext> {
        &self.context
    }

    /// The open encoder, for commands that no kernel covers.
    pub fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        &mut self.encoder
    }

    /// Submits what is recorded and goes on: later commands, and later [`GpuContext::write`]s, run
    /// after it. The recorded time goes on too.
    pub fn split(&mut self) {
        self.submit();
    }

    /// As [`Self::split`], and waits until all of it has run, so that nothing of it stays in memory.
    pub(crate) fn finish_pending(&mut self) -> Result<(), GpuError> {
        let submission = self.submit();
        self.context.wait(submission)
    }

    fn submit(&mut self) -> wgpu::SubmissionIndex {
        let done = std::mem::replace(&mut self.encoder, open(&self.context));
        self.context.queue().submit([done.finish()])
    }
}

fn open(context: &GpuContext) -> wgpu::CommandEncoder {
    context
        .device()
        .create_command_encoder(&wgpu::CommandEncoderDescriptor { label: None })
}

impl GpuContext {
    /// Records work, submits it, waits for it, and says how long it took on the GPU. Time that
    /// passes between two parts of a split recording counts.
    ///
    /// # Errors
    /// The closure's own error, or what the device refused in the recorded work, as a [`GpuError`].
    pub fn record<T, E: From<GpuError>>(
        self: &Arc<Self>,
        label: &str,
        work: impl FnOnce(&mut GpuCx) -> Result<T, E>,
    ) -> Result<(T, GpuTime), E> {
        self.checked(label, || self.record_unchecked(work))?
    }

    fn record_unchecked<T, E: From<GpuError>>(
        self: &Arc<Self>,
        work: impl FnOnce(&mut GpuCx) -> Result<T, E>,
    ) -> Result<(T, GpuTime), E> {
        let timestamps = self.timestamps.take(self.device());
        if timestamps.is_none() {
            // The wall clock must not count uploads that are still pending.
            self.wait(self.queue().submit([]))?;
        }
        let mut cx = GpuCx::new(self);
        let start = Instant::now();
        if let Some(timestamps) = &timestamps {
            timestamps.start(&mut cx.encoder);
        }
        let value = work(&mut cx)?;
        let worked = !cx.passes.is_empty();
        if let Some(timestamps) = &timestamps {
            timestamps.end(&mut cx.encoder);
        }
        self.wait(self.queue().submit([cx.encoder.finish()]))?;
        let wall_ms = start.elapsed().as_secs_f64() * 1e3;
        let device_ms = match timestamps {
            None => Err(Mistimed::NoClock),
            Some(timestamps) => {
                let ms = timestamps.read(self, worked, wall_ms)?;
                self.timestamps.give_back(timestamps);
                ms
            }
        };
        Ok((value, GpuTime { wall_ms, device_ms }))
    }
}
