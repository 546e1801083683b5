//! Reading buffers and textures back, in chunks through one reusable buffer.

use crate::{GpuContext, GpuError};
use bytemuck::Pod;
use std::sync::{PoisonError, mpsc};
use std::time::Duration;

/// Largest chunk in bytes; larger things pass in several.
const CHUNK: u64 = 16 << 20;

/// Time that a mapping may still take once the copy is done: another thread that waits for the
/// device may have taken the notice, and passes it on when it has its turn on the processor.
const PATIENCE: Duration = Duration::from_secs(120);

/// The buffer that everything is read back through; made at the first read, grown up to [`CHUNK`].
#[derive(Default)]
pub(crate) struct Staging {
    buffer: Option<wgpu::Buffer>,
}

impl Staging {
    /// A buffer of at least `bytes`, taken out: one whose mapping fails is not used again.
    fn take(&mut self, context: &GpuContext, bytes: u64) -> Result<wgpu::Buffer, GpuError> {
        match self.buffer.take() {
            Some(buffer) if buffer.size() >= bytes => Ok(buffer),
            _ => context.checked("read-back buffer", || {
                context.device().create_buffer(&wgpu::BufferDescriptor {
                    label: Some("read-back"),
                    size: bytes.next_power_of_two().max(4096),
                    usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                    mapped_at_creation: false,
                })
            }),
        }
    }
}

impl GpuContext {
    /// The content of a buffer that was made by [`GpuContext::storage`].
    ///
    /// # Errors
    /// [`GpuError`] if the buffer can't be copied from, its size is no whole number of `T`, or the
    /// device fails.
    pub fn read_buffer<T: Pod>(&self, buffer: &wgpu::Buffer) -> Result<Vec<T>, GpuError> {
        let size = buffer.size();
        let mut bytes = Vec::with_capacity(size as usize);
        let mut offset = 0;
        while offset < size {
            let part = CHUNK.min(size - offset);
            self.read_chunk(part, &mut bytes, |encoder, staging| {
                encoder.copy_buffer_to_buffer(buffer, offset, staging, 0, part);
            })?;
            offset += part;
        }
        cast(&bytes)
    }

    /// The texels of the first mip level of a texture: layer after layer, row after row, without
    /// any padding.
    ///
    /// # Errors
    /// [`GpuError`] if the texture can't be copied from, its texels are no whole number of `T`, or
    /// the device fails.
    pub fn read_texture<T: Pod>(&self, texture: &wgpu::Texture) -> Result<Vec<T>, GpuError> {
        let texel = texture.format().block_copy_size(None).unwrap_or(0);
        let row = u64::from(texture.width() * texel);
        let pitch = row.next_multiple_of(u64::from(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT));
        let rows_at_once = u32::try_from(CHUNK / pitch.max(1))
            .unwrap_or(u32::MAX)
            .max(1);
        let mut bytes = Vec::new();
        for layer in 0..texture.depth_or_array_layers() {
            let mut first = 0;
            while first < texture.height() {
                let rows = rows_at_once.min(texture.height() - first);
                let mut padded = Vec::new();
                self.read_chunk(pitch * u64::from(rows), &mut padded, |encoder, staging| {
                    copy_rows(
                        encoder,
                        texture,
                        layer,
                        first..first + rows,
                        staging,
                        pitch as u32,
                    );
                })?;
                for line in padded.chunks_exact(pitch as usize) {
                    bytes.extend_from_slice(&line[..row as usize]);
                }
                first += rows;
            }
        }
        cast(&bytes)
    }

    /// Copies `bytes` into the staging buffer, waits, and appends them to `out`.
    fn read_chunk(
        &self,
        bytes: u64,
        out: &mut Vec<u8>,
        copy: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::Buffer),
    ) -> Result<(), GpuError> {
        let mut staging = self.staging.lock().unwrap_or_else(PoisonError::into_inner);
        let buffer = staging.take(self, bytes)?;
        let submission = self.checked("read-back", || {
            let mut encoder = self
                .device()
                .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            copy(&mut encoder, &buffer);
            let submission = self.queue().submit([encoder.finish()]);
            let (send, mapped) = mpsc::sync_channel(1);
            buffer.map_async(wgpu::MapMode::Read, 0..bytes, move |result| {
                // Nobody waits for it any more if the device failed meanwhile.
                send.send(result).ok();
            });
            (submission, mapped)
        })?;
        let (submission, mapped) = submission;
        self.wait(submission)?;
        let failed = |reason: String| GpuError::Driver {
            what: "read-back".into(),
            reason,
        };
        match mapped.recv_timeout(PATIENCE) {
            Ok(Ok(())) => {}
            Ok(Err(e)) => return Err(failed(e.to_string())),
            Err(_) => return Err(failed("the buffer was not mapped in time".into())),
        }
        let view = buffer
            .get_mapped_range(0..bytes)
            .map_err(|e| failed(e.to_string()))?;
        out.extend_from_slice(&view);
        drop(view);
        buffer.unmap();
        staging.buffer = Some(buffer);
        Ok(())
    }
}

fn copy_rows(
    encoder: &mut wgpu::CommandEncoder,
    texture: &wgpu::Texture,
    layer: u32,
    rows: std::ops::Range<u32>,
    staging: &wgpu::Buffer,
    pitch: u32,
) {
    encoder.copy_texture_to_buffer(
        wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d {
                x: 0,
                y: rows.start,
                z: layer,
            },
            aspect: wgpu::TextureAspect::All,
        },
        wgpu::TexelCopyBufferInfo {
            buffer: staging,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(pitch),
                rows_per_image: None,
            },
        },
        wgpu::Extent3d {
            width: texture.width(),
            height: rows.end - rows.start,
            depth_or_array_layers: 1,
        },
    );
}

fn cast<T: Pod>(bytes: &[u8]) -> Result<Vec<T>, GpuError> {
    let whole = size_of::<T>() > 0 && bytes.len().is_multiple_of(size_of::<T>());
    if !whole {
        return Err(GpuError::Validation {
            what: "read-back".into(),
            reason: format!(
                "{} bytes are no whole number of {}",
                bytes.len(),
                size_of::<T>()
            ),
        });
    }
    Ok(bytemuck::pod_collect_to_vec(bytes))
}
