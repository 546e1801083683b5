//! Depth maps along directions, some at a time, and occlusion queries against them.

use super::raster::{Drawing, layer_view};
use crate::pipeline::{Raster, RenderSpec};
use crate::{Binding, GpuContext, GpuCx, GpuError, GpuPoints, Shader, wgsl};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use interreflect_scene::{BoundingSphere, DirectionalDepthSpec, DirectionalFrame, Scene};
use std::sync::Arc;

/// Depth maps that are there at a time: as many as a word has bits.
pub const DEPTH_MAPS_AT_ONCE: u32 = 32;

/// Points that are queried at a time: as many as a set has queries, WebGPU's limit.
pub const QUERIED_AT_ONCE: usize = 4096;

/// Queries that are recorded before the device answers them: each takes some hundred bytes on the host
/// until then.
const QUERIES_PENDING: usize = 1 << 16;

pub(crate) const SHADER: Shader = Shader {
    label: "directional depth maps",
    parts: &[
        wgsl::POINTS,
        wgsl::DIRECTIONAL,
        include_str!("directional_depth.wgsl"),
    ],
};

const POSITION: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 12,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3],
};

/// The WGSL struct `Frame`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub(crate) struct Frame {
    pub(crate) right: [f32; 3],
    pub(crate) pad_right: f32,
    pub(crate) up: [f32; 3],
    pub(crate) pad_up: f32,
    pub(crate) towards: [f32; 3],
    pub(crate) pad_towards: f32,
}

/// The WGSL struct `Frames`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(crate) struct Frames {
    pub(crate) centre: [f32; 3],
    pub(crate) radius: f32,
    pub(crate) frames: [Frame; DEPTH_MAPS_AT_ONCE as usize],
}

/// The triangles of all objects of a scene, receivers too.
pub struct GpuOccluders {
    corners: wgpu::Buffer,
    count: u32,
    sphere: BoundingSphere,
}

impl GpuOccluders {
    /// Uploads a scene's triangles.
    ///
    /// # Errors
    /// [`GpuError`] if the device has no room.
    pub fn new(context: &GpuContext, scene: &Scene) -> Result<Self, GpuError> {
        let corners: Vec<Vec3> = scene
            .objects
            .iter()
            .flat_map(|o| (0..o.mesh.triangles.len()).flat_map(|t| o.mesh.corners(t)))
            .collect();
        let usage = wgpu::BufferUsages::VERTEX;
        Ok(Self {
            corners: context.filled_buffer("occluders", bytemuck::cast_slice(&corners), usage)?,
            count: corners.len() as u32,
            sphere: BoundingSphere::of_objects(scene),
        })
    }
}

/// Where depth maps of a scene come from, some directions at a time.
#[derive(Clone)]
pub struct GpuDirectionalDepths {
    occluders: Arc<GpuOccluders>,
    spec: DirectionalDepthSpec,
}

/// Depth maps of up to [`DEPTH_MAPS_AT_ONCE`] directions, rendered again and again.
pub struct GpuDepthMaps {
    view: wgpu::TextureView,
    layers: Vec<wgpu::TextureView>,
    size: u32,
}

impl GpuDepthMaps {
    /// Room for depth maps.
    ///
    /// # Errors
    /// [`GpuError`] if the device has no room.
    pub fn new(context: &GpuContext, size: u32) -> Result<Self, GpuError> {
        let texture = context.texture(&wgpu::TextureDescriptor {
            label: Some("directional depth maps"),
            size: wgpu::Extent3d {
                width: size,
                height: size,
                depth_or_array_layers: DEPTH_MAPS_AT_ONCE,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Depth32Float,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
            view_formats: &[],
        })?;
        let layer = |i| layer_view(&texture, i);
        Ok(Self {
            view: super::raster::array_view(&texture),
            layers: (0..DEPTH_MAPS_AT_ONCE).map(layer).collect(),
            size,
        })
    }

    /// All maps as an array of depth textures, 1 where there is nothing.
    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// Texels along the edge of a map.
    pub fn size(&self) -> u32 {
        self.size
    }
}

impl GpuDirectionalDepths {
    /// Depth maps of these triangles.
    pub fn new(occluders: Arc<GpuOccluders>, spec: DirectionalDepthSpec) -> Self {
        Self { occluders, spec }
    }

    /// Records the maps of at most [`DEPTH_MAPS_AT_ONCE`] unit directions, in the first layers;
    /// the buffer holds `Frames` of the part [`wgsl::DIRECTIONAL`].
    ///
    /// # Errors
    /// [`GpuError`] if the device refuses.
    pub fn record(
        &self,
        cx: &mut GpuCx,
        maps: &GpuDepthMaps,
        directions: &[Vec3],
    ) -> Result<wgpu::Buffer, GpuError> {
        let context = cx.context().clone();
        let frames = context.uniform("directions", &self.frames(directions))?;
        let spec = RenderSpec {
            shader: &SHADER,
            vertex: "vs_depth",
            fragment: None,
            raster: Raster::Depths {
                slope_scaled: self.spec.slope_scaled,
            },
            buffers: &[Some(POSITION)],
            targets: &[],
        };
        let bindings = [
            Binding::None,
            Binding::None,
            Binding::None,
            Binding::Buffer(&frames),
        ];
        let drawing = Drawing::new(&context, &spec, &bindings)?;
        for (layer, view) in (0..directions.len() as u32).zip(&maps.layers) {
            let mut pass = depth_pass(cx, view, wgpu::LoadOp::Clear(1.0), None);
            drawing.draw(
                &mut pass,
                &self.occluders.corners,
                self.occluders.count,
                layer,
            );
        }
        Ok(frames)
    }

    fn frames(&self, directions: &[Vec3]) -> Frames {
        let sphere = self.occluders.sphere;
        let mut frames = Frames {
            centre: sphere.centre.to_array(),
            radius: sphere.radius,
            ..Frames::zeroed()
        };
        for (slot, &towards) in frames.frames.iter_mut().zip(directions) {
            let frame = DirectionalFrame::new(sphere, towards);
            *slot = Frame {
                right: frame.right.to_array(),
                up: frame.up.to_array(),
                towards: frame.towards.to_array(),
                ..Frame::default()
            };
        }
        frames
    }
}

impl GpuDirectionalDepths {
    /// Answers of occlusion queries: for each map after the other, for each point of a list a 64-bit
    /// count of samples that passed, of which only zero or not is meant.
    ///
    /// The points, at most [`QUERIED_AT_ONCE`] indices among all, are drawn one by one, nearer by a
    /// depth of `margin`, against the first maps, so many as were recorded last; `frames` is what
    /// recording them returned. Queries are submitted and waited for in batches.
    ///
    /// # Errors
    /// [`GpuError`] if the device refuses.
    pub fn queries(
        &self,
        cx: &mut GpuCx,
        (maps, frames, maps_count): (&GpuDepthMaps, &wgpu::Buffer, u32),
        (points, list): (&GpuPoints, &[u32]),
        margin: f32,
    ) -> Result<wgpu::Buffer, GpuError> {
        let context = cx.context().clone();
        let spec = RenderSpec {
            shader: &SHADER,
            vertex: "vs_point",
            fragment: None,
            raster: Raster::Queries,
            buffers: &[],
            targets: &[],
        };
        let [points, info] = points.inputs();
        let margin = context.uniform("margin", &margin)?;
        let bindings = [points, info, Binding::None, frames.into(), (&margin).into()];
        let drawing = Drawing::new(&context, &spec, &bindings)?;
        let answers = context.query_answers(maps_count as usize * list.len())?;
        let set = context
            .device()
            .create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("occlusion"),
                ty: wgpu::QueryType::Occlusion,
                count: QUERIED_AT_ONCE as u32,
            });
        let resolved = context.query_room(QUERIED_AT_ONCE as u32)?;
        let count = list.len() as u32;
        let bytes = 8 * u64::from(count);
        let mut pending = 0;
        for (layer, view) in (0..maps_count).zip(&maps.layers) {
            let mut pass = depth_pass(cx, view, wgpu::LoadOp::Load, Some(&set));
            drawing.bind(&mut pass);
            for (i, &point) in (0..).zip(list) {
                pass.begin_occlusion_query(i);
                pass.draw(point..point + 1, layer..layer + 1);
                pass.end_occlusion_query();
            }
            drop(pass);
            let encoder = cx.encoder();
            encoder.resolve_query_set(&set, 0..count, &resolved, 0);
            encoder.copy_buffer_to_buffer(&resolved, 0, &answers, u64::from(layer) * bytes, bytes);
            pending += list.len();
            if pending >= QUERIES_PENDING {
                cx.finish_pending()?;
                pending = 0;
            }
        }
        // What the next batch asks is not known here.
        cx.finish_pending()?;
        Ok(answers)
    }
}

fn depth_pass<'a>(
    cx: &'a mut GpuCx,
    view: &wgpu::TextureView,
    load: wgpu::LoadOp<f32>,
    queries: Option<&wgpu::QuerySet>,
) -> wgpu::RenderPass<'a> {
    cx.begin(SHADER.label)
        .begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some(SHADER.label),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view,
                depth_ops: Some(wgpu::Operations {
                    load,
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: queries,
            multiview_mask: None,
        })
}
