//! An open device, shared by everything that runs on it.

use crate::{
    AdapterInfo, CacheStats, GpuError, adapter, pipeline::PipelineCache, readback::Staging,
    timestamps::TimestampPool,
};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock};

/// An open device with its queue, pipeline cache, timestamps and read-back buffer.
pub struct GpuContext {
    info: AdapterInfo,
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipelines: PipelineCache,
    pub(crate) staging: Mutex<Staging>,
    pub(crate) timestamps: TimestampPool,
    lost: Arc<OnceLock<String>>,
    pub(crate) made_bytes: AtomicU64,
}

impl GpuContext {
    /// Opens the adapter of an index (place in [`crate::adapters`]) or of a part of a name,
    /// whatever the case; without a choice the best one, hardware before software.
    ///
    /// # Errors
    /// [`GpuError::NoAdapter`], [`GpuError::UnknownAdapter`] or [`GpuError::NoDevice`].
    pub fn new(choice: Option<&str>) -> Result<Arc<Self>, GpuError> {
        let adapter = adapter::choose(choice)?;
        let request = adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("interreflect"),
            required_features: adapter.features() & optional_features(),
            required_limits: limits(&adapter.limits()),
            experimental_features: wgpu::ExperimentalFeatures::disabled(),
            memory_hints: wgpu::MemoryHints::default(),
            trace: wgpu::Trace::Off,
        });
        let (device, queue) = pollster::block_on(request).map_err(|e| GpuError::NoDevice {
            adapter: adapter.get_info().name,
            reason: e.to_string(),
        })?;
        let lost = Arc::new(OnceLock::new());
        let reason = Arc::clone(&lost);
        // The first reason is kept: later ones follow from it.
        device.set_device_lost_callback(move |why, message| {
            let _ = reason.set(format!("{why:?}: {message}"));
        });
        Ok(Self::with_device(device, queue, lost))
    }

    /// A context on a device that somebody else opened, a viewer for instance. Its owner keeps its
    /// error and device-lost callbacks.
    pub fn from_device(device: wgpu::Device, queue: wgpu::Queue) -> Arc<Self> {
        Self::with_device(device, queue, Arc::default())
    }

    fn with_device(
        device: wgpu::Device,
        queue: wgpu::Queue,
        lost: Arc<OnceLock<String>>,
    ) -> Arc<Self> {
        Arc::new(Self {
            info: device.adapter_info().into(),
            pipelines: PipelineCache::default(),
            staging: Mutex::default(),
            timestamps: TimestampPool::new(&device, &queue),
            device,
            queue,
            lost,
            made_bytes: AtomicU64::new(0),
        })
    }

    /// The adapter.
    pub fn info(&self) -> &AdapterInfo {
        &self.info
    }

    /// The device.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// The queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// Bytes of all buffers and textures that were made so far; what was dropped since counts too.
    pub fn made_bytes(&self) -> u64 {
        self.made_bytes.load(Ordering::Relaxed)
    }

    /// Pipelines built so far.
    pub fn cache_stats(&self) -> CacheStats {
        self.pipelines.stats()
    }

    pub(crate) fn pipelines(&self) -> &PipelineCache {
        &self.pipelines
    }

    /// Runs `work` and turns whatever the device refuses in it, on this thread, into an error that
    /// begins with `what`.
    ///
    /// # Errors
    /// [`GpuError::Validation`], [`GpuError::OutOfMemory`], [`GpuError::Driver`] or
    /// [`GpuError::DeviceLost`].
    pub fn checked<T>(&self, what: &str, work: impl FnOnce() -> T) -> Result<T, GpuError> {
        self.check_alive()?;
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let internal = self.device.push_error_scope(wgpu::ErrorFilter::Internal);
        let result = work();
        // Scopes are popped from the inside out; all of them, so that none is left behind.
        let internal = pollster::block_on(internal.pop());
        let memory = pollster::block_on(memory.pop());
        let validation = pollster::block_on(validation.pop());
        self.check_alive()?;
        match memory.or(validation).or(internal) {
            None => Ok(result),
            Some(error) => Err(typed(what, error)),
        }
    }

    /// Waits until a submission has run.
    pub(crate) fn wait(&self, submission: wgpu::SubmissionIndex) -> Result<(), GpuError> {
        let waited = self.device.poll(wgpu::PollType::Wait {
            submission_index: Some(submission),
            timeout: None,
        });
        if waited.is_err() {
            // Gives the device-lost callback its chance to say why.
            let _ = self.device.poll(wgpu::PollType::Poll);
        }
        self.check_alive()?;
        waited.map(drop).map_err(|e| GpuError::Driver {
            what: "waiting for the GPU".into(),
            reason: e.to_string(),
        })
    }

    fn check_alive(&self) -> Result<(), GpuError> {
        match self.lost.get() {
            None => Ok(()),
            Some(reason) => Err(GpuError::DeviceLost {
                reason: reason.clone(),
            }),
        }
    }
}

fn optional_features() -> wgpu::Features {
    wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::TIMESTAMP_QUERY_INSIDE_ENCODERS
}

/// The defaults, with as large buffers and textures as the adapter has.
fn limits(adapter: &wgpu::Limits) -> wgpu::Limits {
    wgpu::Limits {
        max_buffer_size: adapter.max_buffer_size,
        max_storage_buffer_binding_size: adapter.max_storage_buffer_binding_size,
        max_texture_dimension_2d: adapter.max_texture_dimension_2d,
        max_texture_array_layers: adapter.max_texture_array_layers,
        ..wgpu::Limits::default().or_worse_values_from(adapter)
    }
}

fn typed(what: &str, error: wgpu::Error) -> GpuError {
    let what = what.to_owned();
    match error {
        wgpu::Error::OutOfMemory { .. } => GpuError::OutOfMemory { what },
        wgpu::Error::Validation { description, .. } => GpuError::Validation {
            what,
            reason: description,
        },
        wgpu::Error::Internal { description, .. } => GpuError::Driver {
            what,
            reason: description,
        },
    }
}
