//! Buffers and textures, made and written.

use crate::{GpuContext, GpuError};
use bytemuck::Pod;
use std::sync::atomic::Ordering;

impl GpuContext {
    /// A uniform buffer with this content; rewritten by [`GpuContext::write`].
    ///
    /// # Errors
    /// [`GpuError`] if the device has no room.
    pub fn uniform<T: Pod>(&self, label: &str, value: &T) -> Result<wgpu::Buffer, GpuError> {
        let bytes = bytemuck::bytes_of(value);
        self.filled_buffer(label, bytes, wgpu::BufferUsages::UNIFORM)
    }

    /// A storage buffer with this content, which can be read back.
    ///
    /// # Errors
    /// [`GpuError::BufferTooLarge`], or another [`GpuError`] if the device has no room.
    pub fn storage<T: Pod>(&self, label: &str, values: &[T]) -> Result<wgpu::Buffer, GpuError> {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        self.check_binding_size(label, bytes.len() as u64)?;
        self.filled_buffer(label, bytes, STORAGE)
    }

    /// A storage buffer of `bytes` zeros, which can be read back.
    ///
    /// # Errors
    /// As [`GpuContext::storage`].
    pub fn storage_zeroed(&self, label: &str, bytes: u64) -> Result<wgpu::Buffer, GpuError> {
        self.check_binding_size(label, bytes)?;
        self.empty_buffer(label, bytes, STORAGE)
    }

    /// Overwrites the start of a buffer, before anything that is submitted from now on: everything
    /// recorded since the last [`crate::GpuCx::split`] sees the new content.
    ///
    /// # Errors
    /// [`GpuError::Validation`] if the values are longer than the buffer, or not whole words of 4
    /// bytes.
    pub fn write<T: Pod>(&self, buffer: &wgpu::Buffer, values: &[T]) -> Result<(), GpuError> {
        let bytes = bytemuck::cast_slice(values);
        self.checked("writing a buffer", || {
            self.queue().write_buffer(buffer, 0, bytes)
        })
    }

    /// A texture.
    ///
    /// # Errors
    /// [`GpuError`] if the device refuses the size, format or usage, or has no room.
    pub fn texture(
        &self,
        descriptor: &wgpu::TextureDescriptor<'_>,
    ) -> Result<wgpu::Texture, GpuError> {
        let what = descriptor.label.unwrap_or("a texture");
        let size = descriptor.size.width.max(descriptor.size.height);
        let max = self.device().limits().max_texture_dimension_2d;
        if size == 0 || size > max {
            return Err(GpuError::TextureTooLarge {
                what: what.to_owned(),
                size,
                max,
            });
        }
        self.made_bytes
            .fetch_add(texture_bytes(descriptor), Ordering::Relaxed);
        self.checked(what, || self.device().create_texture(descriptor))
    }

    /// Writes the first mip level of a texture: layer after layer, row after row, without padding.
    ///
    /// # Errors
    /// [`GpuError::Validation`] if the values are fewer than the texels.
    pub fn write_texture<T: Pod>(
        &self,
        texture: &wgpu::Texture,
        values: &[T],
    ) -> Result<(), GpuError> {
        let texel = texture.format().block_copy_size(None).unwrap_or(0);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(texture.width() * texel),
            rows_per_image: Some(texture.height()),
        };
        let bytes = bytemuck::cast_slice(values);
        self.checked("writing a texture", || {
            self.queue()
                .write_texture(texture.as_image_copy(), bytes, layout, texture.size());
        })
    }

    /// Room for the answers of occlusion queries, 8 bytes each, that shaders can read.
    pub(crate) fn query_answers(&self, count: usize) -> Result<wgpu::Buffer, GpuError> {
        self.storage_zeroed("occlusion answers", 8 * count as u64)
    }

    /// Room that occlusion queries are resolved into and copied from.
    pub(crate) fn query_room(&self, count: u32) -> Result<wgpu::Buffer, GpuError> {
        let usage = wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC;
        self.empty_buffer("occlusion queries", 8 * u64::from(count), usage)
    }

    pub(crate) fn filled_buffer(
        &self,
        label: &str,
        bytes: &[u8],
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, GpuError> {
        let buffer = self.empty_buffer(label, bytes.len() as u64, usage)?;
        self.write(&buffer, bytes)?;
        Ok(buffer)
    }

    fn empty_buffer(
        &self,
        label: &str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, GpuError> {
        let max = self.device().limits().max_buffer_size;
        if bytes > max {
            return Err(GpuError::BufferTooLarge {
                what: label.to_owned(),
                bytes,
                max,
            });
        }
        self.buffer(&wgpu::BufferDescriptor {
            label: Some(label),
            // Empty buffers can't be bound.
            size: bytes.max(wgpu::COPY_BUFFER_ALIGNMENT),
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        })
    }

    /// A buffer.
    ///
    /// # Errors
    /// [`GpuError`] if the device refuses the size or usage, or has no room.
    pub fn buffer(
        &self,
        descriptor: &wgpu::BufferDescriptor<'_>,
    ) -> Result<wgpu::Buffer, GpuError> {
        let what = descriptor.label.unwrap_or("a buffer");
        self.made_bytes
            .fetch_add(descriptor.size, Ordering::Relaxed);
        self.checked(what, || self.device().create_buffer(descriptor))
    }

    fn check_binding_size(&self, what: &str, bytes: u64) -> Result<(), GpuError> {
        let max = self.device().limits().max_storage_buffer_binding_size;
        match bytes <= max {
            true => Ok(()),
            false => Err(GpuError::BufferTooLarge {
                what: what.to_owned(),
                bytes,
                max,
            }),
        }
    }
}

const STORAGE: wgpu::BufferUsages = wgpu::BufferUsages::STORAGE.union(wgpu::BufferUsages::COPY_SRC);

/// Bytes of a texture's texels at all its levels and samples.
fn texture_bytes(descriptor: &wgpu::TextureDescriptor<'_>) -> u64 {
    let format = descriptor.format;
    let aspect = (format.is_depth_stencil_format()).then_some(wgpu::TextureAspect::DepthOnly);
    let texel = format.block_copy_size(aspect).unwrap_or(4);
    let texels = |level: u32| {
        let size = descriptor.size.mip_level_size(level, descriptor.dimension);
        u64::from(size.width) * u64::from(size.height) * u64::from(size.depth_or_array_layers)
    };
    let texels: u64 = (0..descriptor.mip_level_count).map(texels).sum();
    texels * u64::from(texel) * u64::from(descriptor.sample_count)
}
