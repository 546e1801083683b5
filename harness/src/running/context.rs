//! What a command works with: the registered methods and the backends of this machine.

use super::error::RunError;
use super::settings::{ContextOptions, SCENE, SceneChanges, Setting};
use super::warning::Warning;
use crate::domain::machine::{Adapter, Machine};
use crate::domain::record::Backend;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Registry};
use interreflect_gpu::{GpuContext, GpuError};
use interreflect_scene::Scene;
use interreflect_scene::load::{SceneRequest, open};
use std::sync::{Arc, OnceLock};

/// Methods and backends.
pub struct Context {
    /// The methods.
    pub registry: Registry,
    /// Threads and instruction set of the CPU backend.
    pub cpu: CpuCx,
    /// Seed of everything random.
    pub seed: u64,
    adapter: Option<String>,
    machine: OnceLock<Machine>,
    gpu: OnceLock<Result<Arc<GpuContext>, GpuError>>,
}

/// Whether a scene is loaded on the GPU too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GpuUse {
    /// Not at all.
    No,
    /// If there is one; else what runs there says why it can't.
    IfThere,
    /// It has to be there.
    Required,
}

impl GpuUse {
    /// If the GPU is one of these backends and there is one.
    pub fn where_listed(backends: &[Backend]) -> Self {
        match backends.contains(&Backend::Gpu) {
            true => Self::IfThere,
            false => Self::No,
        }
    }

    /// If the GPU is one of these backends, it has to be there.
    pub fn required_in(backends: &[Backend]) -> Self {
        match backends.contains(&Backend::Gpu) {
            true => Self::Required,
            false => Self::No,
        }
    }
}

impl Context {
    /// Sets up the CPU backend; the GPU is opened when it is first needed.
    ///
    /// # Errors
    /// [`RunError`] if the threads or instructions that were asked for can't be had.
    pub fn new(registry: Registry, options: &ContextOptions) -> Result<Self, RunError> {
        Ok(Self {
            registry,
            cpu: CpuCx::new(options.threads, options.instruction_set)?,
            seed: options.seed,
            adapter: options.adapter.clone(),
            machine: OnceLock::new(),
            gpu: OnceLock::new(),
        })
    }

    /// The CPU backend on so many threads.
    ///
    /// # Errors
    /// [`RunError`] if they can't be had.
    pub fn cpu_on(&self, threads: usize) -> Result<CpuCx, RunError> {
        let set = self.cpu.instruction_set();
        Ok(CpuCx::new(Some(threads), Some(set))?)
    }

    /// The GPU, opened once.
    ///
    /// # Errors
    /// [`GpuError`] if there is none, or not the one that was asked for.
    pub fn gpu(&self) -> Result<&Arc<GpuContext>, GpuError> {
        let opened = self
            .gpu
            .get_or_init(|| GpuContext::new(self.adapter.as_deref()));
        opened.as_ref().map_err(GpuError::clone)
    }

    /// Where results come from, as it was at the first call. Names the adapter only if it was open
    /// by then.
    pub fn machine(&self) -> Machine {
        self.machine.get_or_init(|| self.detect()).clone()
    }

    fn detect(&self) -> Machine {
        let adapter = self.gpu.get().and_then(|gpu| gpu.as_ref().ok());
        let adapter = adapter.map(|gpu| {
            let info = gpu.info();
            Adapter {
                name: info.name.clone(),
                driver: format!("{} {}", info.driver, info.driver_info),
                software: info.software,
            }
        });
        let set = self.cpu.instruction_set().name();
        Machine::detect(self.cpu.threads(), set, adapter.as_ref())
    }

    /// Opens and loads a scene on the CPU and, if asked for, on the GPU.
    ///
    /// # Errors
    /// [`RunError`] if the scene can't be used, or if a GPU is required and not there.
    pub fn load(
        &self,
        source: &str,
        changes: &SceneChanges,
        settings: &[Setting],
        gpu: GpuUse,
    ) -> Result<LoadedScene, RunError> {
        let scene = self.scene(source, changes, settings)?;
        self.set_up(&self.cpu, &scene, gpu)
    }

    /// Loads an opened scene on these threads and, if asked for, on the GPU.
    ///
    /// # Errors
    /// [`RunError`] if it can't be used, or if a GPU is required and not there.
    pub fn set_up(&self, cx: &CpuCx, scene: &Scene, gpu: GpuUse) -> Result<LoadedScene, RunError> {
        let loaded = LoadedScene::new(cx, scene)?;
        match gpu {
            GpuUse::No => Ok(loaded),
            GpuUse::Required => Ok(loaded.with_gpu(self.gpu()?)?),
            GpuUse::IfThere => Ok(loaded.with_gpu_if_there(self.gpu())),
        }
    }

    /// Opens a scene.
    ///
    /// # Errors
    /// [`RunError`] if it can't be used.
    pub fn scene(
        &self,
        source: &str,
        changes: &SceneChanges,
        settings: &[Setting],
    ) -> Result<Scene, RunError> {
        Ok(open(&request(source, changes, settings))?)
    }

    /// A method with the settings that are meant for it: all unqualified ones, if it is the only
    /// method, and those qualified by its id. A parameter named `seed` takes the context's seed first.
    ///
    /// # Errors
    /// [`RunError`] if a setting is refused.
    pub fn configure(
        &self,
        id: &str,
        settings: &[Setting],
    ) -> Result<Box<dyn Configured>, RunError> {
        self.configured(self.registry.get(id)?.configure(), settings)
    }

    /// As [`Context::configure`], from other defaults.
    ///
    /// # Errors
    /// [`RunError`] if a setting is refused.
    pub fn configured(
        &self,
        mut method: Box<dyn Configured>,
        settings: &[Setting],
    ) -> Result<Box<dyn Configured>, RunError> {
        let id = method.info().id;
        let refused = |error| RunError::Param {
            estimator: id.into(),
            error,
        };
        if method.values().iter().any(|(field, _)| field.name == SEED) {
            method.set(SEED, &self.seed.to_string()).map_err(refused)?;
        }
        for setting in settings {
            let (owner, name) = setting.split();
            if owner.is_none_or(|owner| owner == id) {
                method.set(name, &setting.value).map_err(refused)?;
            }
        }
        Ok(method)
    }

    /// A method with these parameters of its own.
    ///
    /// # Errors
    /// [`RunError::Param`] if it does not have one, or not that value.
    pub fn configured_with(
        &self,
        method: Box<dyn Configured>,
        params: &[(&str, String)],
    ) -> Result<Box<dyn Configured>, RunError> {
        let settings: Vec<Setting> = params
            .iter()
            .map(|(name, value)| Setting::new(*name, value))
            .collect();
        self.configured(method, &settings)
    }

    /// Checks that every setting is meant for a scene or for one of these methods.
    ///
    /// # Errors
    /// [`RunError::Usage`] if one is not, or is not qualified while several methods run.
    pub fn check_owners(&self, ids: &[String], settings: &[Setting]) -> Result<(), RunError> {
        for setting in settings {
            match setting.split() {
                (None, name) if ids.len() > 1 => {
                    return Err(RunError::Usage(format!(
                        "--set {name}={}: several estimators run; say which one is meant, as in \
                         `{}.{name}`",
                        setting.value, ids[0]
                    )));
                }
                (Some(owner), name) if owner != SCENE && !ids.iter().any(|id| id == owner) => {
                    self.registry.get(owner)?;
                    return Err(RunError::Usage(format!(
                        "--set {owner}.{name}={}: {owner} does not run; add --estimator {owner}",
                        setting.value
                    )));
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// A scene as it is asked for.
pub(crate) fn request(source: &str, changes: &SceneChanges, settings: &[Setting]) -> SceneRequest {
    let of_scene = settings.iter().filter_map(|s| match s.split() {
        (Some(SCENE), name) => Some((name.to_owned(), s.value.clone())),
        _ => None,
    });
    let path = |p: &std::path::PathBuf| p.to_string_lossy().into_owned();
    SceneRequest {
        source: source.into(),
        receivers: changes.receivers.iter().map(path).collect(),
        environment: changes.environment.clone(),
        reference_point: changes.reference_point,
        set: of_scene.collect(),
    }
}

/// Name of the parameter that `--seed` sets, in every method that has it.
const SEED: &str = "seed";

/// What is remarkable about a scene.
pub fn remarkable(scene: &Scene) -> Option<Warning> {
    let facts = scene.facts();
    let lit = facts.environment || facts.emitters || facts.lights > 0;
    (!lit).then(|| Warning::NoLight {
        scene: scene.name.clone(),
    })
}
