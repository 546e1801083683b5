//! Compute kernels: made once, recorded many times.

use crate::pipeline::ComputePipeline;
use crate::{Constants, GpuContext, GpuCx, GpuError, Shader, shader::Slot};

/// What a slot of `@group(0)` is bound to.
#[derive(Clone, Copy, Debug)]
pub enum Binding<'a> {
    /// A whole uniform or storage buffer.
    Buffer(&'a wgpu::Buffer),
    /// A sampled or storage texture.
    Texture(&'a wgpu::TextureView),
    /// A sampler.
    Sampler(&'a wgpu::Sampler),
    /// Nothing, for a slot that the entry point does not use.
    None,
}

impl<'a> From<&'a wgpu::Buffer> for Binding<'a> {
    fn from(buffer: &'a wgpu::Buffer) -> Self {
        Self::Buffer(buffer)
    }
}

impl<'a> From<&'a wgpu::TextureView> for Binding<'a> {
    fn from(view: &'a wgpu::TextureView) -> Self {
        Self::Texture(view)
    }
}

impl<'a> From<&'a wgpu::Sampler> for Binding<'a> {
    fn from(sampler: &'a wgpu::Sampler) -> Self {
        Self::Sampler(sampler)
    }
}

impl<'a> Binding<'a> {
    fn resource(self) -> Option<wgpu::BindingResource<'a>> {
        match self {
            Self::Buffer(buffer) => Some(buffer.as_entire_binding()),
            Self::Texture(view) => Some(wgpu::BindingResource::TextureView(view)),
            Self::Sampler(sampler) => Some(wgpu::BindingResource::Sampler(sampler)),
            Self::None => None,
        }
    }
}

/// A compute pipeline with what is bound to it.
#[derive(Clone)]
pub struct Kernel {
    label: &'static str,
    pipeline: ComputePipeline,
    bind_group: wgpu::BindGroup,
}

impl Kernel {
    /// Records a dispatch of `workgroups` in a compute pass of its own.
    pub fn record(&self, cx: &mut GpuCx, workgroups: [u32; 3]) {
        self.record_as(cx, self.label, workgroups);
    }

    /// As [`Kernel::record`], the pass under a label of its own.
    pub(crate) fn record_as(&self, cx: &mut GpuCx, label: &'static str, workgroups: [u32; 3]) {
        let mut pass = cx
            .begin(label)
            .begin_compute_pass(&wgpu::ComputePassDescriptor {
                label: Some(label),
                timestamp_writes: None,
            });
        pass.set_pipeline(&self.pipeline.raw);
        pass.set_bind_group(0, &self.bind_group, &[]);
        let [x, y, z] = workgroups;
        pass.dispatch_workgroups(x, y, z);
    }
}

impl GpuContext {
    /// A kernel of a compute entry point. `bindings[i]` belongs to `@group(0) @binding(i)`; those
    /// that the entry point does not use are left out, so the kernels of one shader can share a list.
    ///
    /// # Errors
    /// [`GpuError`] if the shader is invalid, has no such entry point, uses a slot that is not
    /// bound, or if a binding is of another kind than the shader declares.
    ///
    /// # Loops
    /// lavapipe, the software driver, ends the loops of an invocation after 65535 turns in all,
    /// without an error: longer sums are spread over invocations or dispatches.
    pub fn kernel(
        &self,
        shader: &Shader,
        entry: &str,
        bindings: &[Binding<'_>],
    ) -> Result<Kernel, GpuError> {
        self.kernel_with(shader, entry, &[], bindings)
    }

    /// As [`GpuContext::kernel`], with values for the shader's `override` constants.
    ///
    /// # Errors
    /// As [`GpuContext::kernel`].
    pub fn kernel_with(
        &self,
        shader: &Shader,
        entry: &str,
        constants: Constants<'_>,
        bindings: &[Binding<'_>],
    ) -> Result<Kernel, GpuError> {
        let pipeline = self.compute_pipeline(shader, entry, constants)?;
        let layout = || pipeline.raw.get_bind_group_layout(0);
        let bind_group = self.bind_group(shader, &pipeline.slots, layout, bindings)?;
        Ok(Kernel {
            label: shader.label,
            pipeline,
            bind_group,
        })
    }

    /// Binds the slots that a pipeline uses.
    pub(crate) fn bind_group(
        &self,
        shader: &Shader,
        slots: &[Slot],
        layout: impl FnOnce() -> wgpu::BindGroupLayout,
        bindings: &[Binding<'_>],
    ) -> Result<wgpu::BindGroup, GpuError> {
        let mut entries = Vec::with_capacity(slots.len());
        for slot in slots {
            let binding = bindings.get(slot.index as usize).copied();
            let resource = binding.and_then(Binding::resource);
            entries.push(wgpu::BindGroupEntry {
                binding: slot.index,
                resource: resource.ok_or_else(|| GpuError::Unbound {
                    label: shader.label,
                    slot: slot.index,
                    name: slot.name.clone(),
                })?,
            });
        }
        self.checked(shader.label, || {
            self.device().create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(shader.label),
                layout: &layout(),
                entries: &entries,
            })
        })
    }
}
