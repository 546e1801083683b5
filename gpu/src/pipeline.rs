//! The pipeline cache.

use crate::shader::{Parsed, Slot};
use crate::{GpuContext, GpuError, Shader};
use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Values of a shader's `override` constants, by name.
pub type Constants<'a> = &'a [(&'a str, f64)];

/// Pipelines that had to be built since the context was opened.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CacheStats {
    /// Number of pipelines built.
    pub misses: u64,
    /// Time spent building them, in milliseconds. A software driver compiles most of a pipeline
    /// only when it first runs.
    pub ms: f64,
}

/// A pipeline and the slots that it uses.
#[derive(Clone)]
pub(crate) struct Bound<P> {
    pub(crate) raw: P,
    pub(crate) slots: Arc<[Slot]>,
}

pub(crate) type ComputePipeline = Bound<wgpu::ComputePipeline>;
pub(crate) type RenderPipeline = Bound<wgpu::RenderPipeline>;

/// How a raster pipeline differs from others.
pub(crate) struct RenderSpec<'a> {
    pub(crate) shader: &'a Shader,
    pub(crate) vertex: &'a str,
    pub(crate) fragment: Option<&'a str>,
    pub(crate) raster: Raster,
    pub(crate) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) targets: &'a [Option<wgpu::TextureFormat>],
}

/// What is drawn and which depth wins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Raster {
    /// Double-sided triangles with reversed depth: nearer is greater.
    #[default]
    Nearest,
    /// Double-sided triangles whose depth alone counts: nearer is smaller, moved back by
    /// `glPolygonOffset(1, 1)` if asked for.
    Depths {
        /// Whether it is moved back.
        slope_scaled: bool,
    },
    /// Single points that are tested against depths where nearer is smaller, and leave no trace.
    Queries,
}

impl Raster {
    fn depth_stencil(self) -> wgpu::DepthStencilState {
        let compare = match self {
            Self::Nearest => wgpu::CompareFunction::GreaterEqual,
            Self::Depths { .. } | Self::Queries => wgpu::CompareFunction::LessEqual,
        };
        let offset = i32::from(self == Self::Depths { slope_scaled: true });
        wgpu::DepthStencilState {
            format: wgpu::TextureFormat::Depth32Float,
            depth_write_enabled: Some(self != Self::Queries),
            depth_compare: Some(compare),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState {
                constant: offset,
                slope_scale: offset as f32,
                clamp: 0.0,
            },
        }
    }

    fn topology(self) -> wgpu::PrimitiveTopology {
        match self {
            Self::Queries => wgpu::PrimitiveTopology::PointList,
            _ => wgpu::PrimitiveTopology::TriangleList,
        }
    }
}

/// What makes two pipelines the same.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Key {
    label: &'static str,
    source_hash: u64,
    entries: Vec<String>,
    constants: Vec<(String, u64)>,
    targets: Vec<Option<wgpu::TextureFormat>>,
    raster: Raster,
}

impl Key {
    fn new(shader: &Shader, entries: &[&str]) -> Self {
        Self {
            label: shader.label,
            source_hash: shader.source_hash(),
            entries: entries.iter().map(|&e| e.to_owned()).collect(),
            constants: Vec::new(),
            targets: Vec::new(),
            raster: Raster::default(),
        }
    }
}

/// Every pipeline that was built.
#[derive(Default)]
pub(crate) struct PipelineCache {
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    compute: HashMap<Key, ComputePipeline>,
    render: HashMap<Key, RenderPipeline>,
    stats: CacheStats,
}

impl PipelineCache {
    pub(crate) fn stats(&self) -> CacheStats {
        self.state
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .stats
    }

    /// The pipeline of a key; built under the lock, so that no two threads build the same one.
    fn get<P: Clone>(
        &self,
        key: Key,
        map: impl Fn(&mut State) -> &mut HashMap<Key, P>,
        build: impl FnOnce() -> Result<P, GpuError>,
    ) -> Result<P, GpuError> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = map(&mut state).get(&key) {
            return Ok(found.clone());
        }
        let start = Instant::now();
        let built = build()?;
        state.stats.misses += 1;
        state.stats.ms += start.elapsed().as_secs_f64() * 1e3;
        map(&mut state).insert(key, built.clone());
        Ok(built)
    }
}

impl GpuContext {
    /// The compute pipeline of an entry point.
    pub(crate) fn compute_pipeline(
        &self,
        shader: &Shader,
        entry: &str,
        constants: Constants<'_>,
    ) -> Result<ComputePipeline, GpuError> {
        let key = Key {
            constants: constants
                .iter()
                .map(|(name, value)| ((*name).to_owned(), value.to_bits()))
                .collect(),
            ..Key::new(shader, &[entry])
        };
        let build = || {
            self.build(shader, &[entry], |module| {
                self.device()
                    .create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                        label: Some(shader.label),
                        layout: None,
                        module,
                        entry_point: Some(entry),
                        compilation_options: wgpu::PipelineCompilationOptions {
                            constants,
                            ..Default::default()
                        },
                        cache: None,
                    })
            })
        };
        self.pipelines().get(key, |state| &mut state.compute, build)
    }

    /// A pipeline that rasterises.
    pub(crate) fn render_pipeline(
        &self,
        spec: &RenderSpec<'_>,
    ) -> Result<RenderPipeline, GpuError> {
        let entries: Vec<_> = std::iter::once(spec.vertex).chain(spec.fragment).collect();
        let key = Key {
            targets: spec.targets.to_vec(),
            raster: spec.raster,
            ..Key::new(spec.shader, &entries)
        };
        let build = || {
            self.build(spec.shader, &entries, |module| {
                create_render_pipeline(self.device(), spec, module)
            })
        };
        self.pipelines().get(key, |state| &mut state.render, build)
    }

    fn build<P>(
        &self,
        shader: &Shader,
        entries: &[&str],
        create: impl FnOnce(&wgpu::ShaderModule) -> P,
    ) -> Result<Bound<P>, GpuError> {
        let parsed = shader.parse()?;
        let slots = used_slots(shader, &parsed, entries)?;
        let raw = self.checked(shader.label, || {
            let module = self
                .device()
                .create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(shader.label),
                    source: wgpu::ShaderSource::Naga(Cow::Owned(parsed.module)),
                });
            create(&module)
        })?;
        Ok(Bound { raw, slots })
    }
}

fn used_slots(shader: &Shader, parsed: &Parsed, entries: &[&str]) -> Result<Arc<[Slot]>, GpuError> {
    let slots = parsed
        .slots(entries)
        .map_err(|known| GpuError::UnknownEntryPoint {
            label: shader.label,
            asked: entries.join(", "),
            known,
        })?;
    Ok(slots.into())
}

fn create_render_pipeline(
    device: &wgpu::Device,
    spec: &RenderSpec<'_>,
    module: &wgpu::ShaderModule,
) -> wgpu::RenderPipeline {
    let targets: Vec<_> = spec.targets.iter().map(|t| t.map(Into::into)).collect();
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(spec.shader.label),
        layout: None,
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(spec.vertex),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: spec.buffers,
        },
        primitive: wgpu::PrimitiveState {
            topology: spec.raster.topology(),
            ..Default::default()
        },
        depth_stencil: Some(spec.raster.depth_stencil()),
        multisample: wgpu::MultisampleState::default(),
        fragment: spec.fragment.map(|entry| wgpu::FragmentState {
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}
