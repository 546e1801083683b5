//! A scene on all backends that are to run it.

use super::{CpuLoadedScene, GpuLoadedScene};
use crate::{Backend, Unsupported};
use interreflect_cpu::scene::{CpuError, CpuScene};
use interreflect_cpu::tiles::CpuCx;
use interreflect_gpu::{GpuContext, GpuError};
use interreflect_scene::Scene;
use std::sync::Arc;

/// A scene that is set up: on the CPU, which traces rays in it, and on the GPU if that was asked for.
pub struct LoadedScene {
    cpu: CpuLoadedScene,
    gpu: Result<GpuLoadedScene, Unsupported>,
}

impl LoadedScene {
    /// Loads a scene on the CPU.
    ///
    /// # Errors
    /// [`CpuError`] if the CPU can't use it.
    pub fn new(cx: &CpuCx, scene: &Scene) -> Result<Self, CpuError> {
        let scene = Arc::new(cx.install(|| CpuScene::new(scene))?);
        Ok(Self::of(CpuLoadedScene::new(cx, scene)))
    }

    /// A scene that is on the CPU already.
    pub fn of(cpu: CpuLoadedScene) -> Self {
        let gpu = Err(Unsupported("the GPU was not asked for".into()));
        Self { cpu, gpu }
    }

    /// Loads the scene on a GPU too.
    ///
    /// # Errors
    /// [`GpuError`] if the GPU can't use it.
    pub fn with_gpu(self, context: &Arc<GpuContext>) -> Result<Self, GpuError> {
        let gpu = Ok(GpuLoadedScene::new(context, self.cpu.clone())?);
        Ok(Self { gpu, ..self })
    }

    /// Loads the scene on a GPU too if there is one that can use it; else what runs there says why
    /// it can't.
    pub fn with_gpu_if_there(self, context: Result<&Arc<GpuContext>, GpuError>) -> Self {
        let host = self.cpu.clone();
        let gpu = context.and_then(|context| GpuLoadedScene::new(context, host));
        let gpu = gpu.map_err(|why| Unsupported(why.to_string()));
        Self { gpu, ..self }
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        self.cpu.scene.scene()
    }

    /// The CPU's side.
    pub fn cpu(&self) -> &CpuLoadedScene {
        &self.cpu
    }

    /// The GPU's side.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if there is none.
    pub fn gpu(&self) -> Result<&GpuLoadedScene, Unsupported> {
        self.gpu.as_ref().map_err(Clone::clone)
    }

    /// One backend's side.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if the scene is not loaded there.
    pub fn on<B: Backend>(&self) -> Result<&B::Scene, Unsupported> {
        B::side(self)
    }
}
