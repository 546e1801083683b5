//! Render targets and passes, as captures use them: depth is reversed, nearer is greater.

use crate::pipeline::{RenderPipeline, RenderSpec};
use crate::{Binding, GpuContext, GpuCx, GpuError, GpuScene};

/// WGSL that all captures share.
pub(crate) const RASTER: &str = include_str!("raster.wgsl");

/// A render pipeline with what is bound to it.
pub(crate) struct Drawing {
    pipeline: RenderPipeline,
    group: wgpu::BindGroup,
}

impl Drawing {
    pub(crate) fn new(
        context: &GpuContext,
        spec: &RenderSpec<'_>,
        bindings: &[Binding<'_>],
    ) -> Result<Self, GpuError> {
        let pipeline = context.render_pipeline(spec)?;
        let layout = || pipeline.raw.get_bind_group_layout(0);
        let group = context.bind_group(spec.shader, &pipeline.slots, layout, bindings)?;
        Ok(Self { pipeline, group })
    }

    /// Draws all captured triangles as one instance.
    pub(crate) fn draw_scene(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        scene: &GpuScene,
        instance: u32,
    ) {
        self.draw(pass, &scene.vertices, scene.vertex_count, instance);
    }

    /// Draws vertices as one instance.
    pub(crate) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        vertices: &wgpu::Buffer,
        count: u32,
        instance: u32,
    ) {
        self.bind(pass);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.draw(0..count, instance..instance + 1);
    }

    /// Draws one triangle without vertex buffers as one instance.
    pub(crate) fn draw_triangle(&self, pass: &mut wgpu::RenderPass<'_>, instance: u32) {
        self.bind(pass);
        pass.draw(0..3, instance..instance + 1);
    }

    /// Sets the pipeline and what is bound to it.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline.raw);
        pass.set_bind_group(0, &self.group, &[]);
    }
}

impl GpuContext {
    /// A square texture array that is rendered to, read by shaders and copied.
    pub(crate) fn target_array(
        &self,
        label: &str,
        size: u32,
        layers: u32,
        format: wgpu::TextureFormat,
    ) -> Result<wgpu::Texture, GpuError> {
        self.texture(&wgpu::TextureDescriptor {
            label: Some(label),
            size: wgpu::Extent3d {
                width: size,
                height: size,
                depth_or_array_layers: layers,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC
                | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        })
    }

    /// A depth buffer for square targets.
    pub(crate) fn depth_target(&self, size: u32) -> Result<wgpu::TextureView, GpuError> {
        let texture = self.texture(&wgpu::TextureDescriptor {
            label: Some("depth"),
            size: wgpu::Extent3d {
                width: size,
                height: size,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Depth32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        })?;
        Ok(texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }
}

/// One layer of a texture array, as a render target.
pub(crate) fn layer_view(texture: &wgpu::Texture, layer: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2),
        base_array_layer: layer,
        array_layer_count: Some(1),
        ..Default::default()
    })
}

/// All layers of a texture, as shaders read them.
pub(crate) fn array_view(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    })
}

/// Begins a pass that clears its targets to 0 and its depth to infinity.
pub(crate) fn begin_pass<'a>(
    cx: &'a mut GpuCx,
    label: &'static str,
    targets: &[Option<wgpu::TextureView>],
    depth: &wgpu::TextureView,
) -> wgpu::RenderPass<'a> {
    let attachment = |view| wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations {
            load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
            store: wgpu::StoreOp::Store,
        },
    };
    let targets: Vec<_> = targets.iter().map(|t| t.as_ref().map(attachment)).collect();
    cx.begin(label)
        .begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(label),
            color_attachments: &targets,
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
}
