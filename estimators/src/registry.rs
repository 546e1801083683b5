//! The list of methods.

use crate::backend::{Cpu, Gpu};
use crate::configured::{Configured, Running, Typed};
use crate::leaves::Leaves;
use crate::method::{Estimator, Info};
use interreflect_gpu::Shader;
use interreflect_scene::params;

/// A registered method.
#[derive(Clone, Copy)]
pub struct Entry {
    info: &'static Info,
    gpu: Result<(), &'static str>,
    shaders: &'static [Shader],
    leaves: &'static Leaves,
    make: fn() -> Box<dyn Configured>,
}

impl Entry {
    /// A method with an implementation on each backend.
    pub fn both<M: Estimator<Cpu> + Estimator<Gpu>>() -> Self {
        Self {
            info: &M::INFO,
            gpu: Ok(()),
            shaders: <M as Estimator<Gpu>>::SHADERS,
            leaves: &M::LEAVES,
            make: || {
                Box::new(Typed::<M> {
                    method: M::default(),
                    cpu: Ok(Running::<M, Cpu>::open),
                    gpu: Ok(Running::<M, Gpu>::open),
                    shaders: <M as Estimator<Gpu>>::SHADERS,
                })
            },
        }
    }

    /// A method that runs on the CPU alone; it says why by itself when asked for more.
    pub fn cpu_only<M: CpuOnly>() -> Self {
        Self {
            info: &M::INFO,
            gpu: Err(M::NO_GPU),
            shaders: &[],
            leaves: &M::LEAVES,
            make: || {
                Box::new(Typed::<M> {
                    method: M::default(),
                    cpu: Ok(Running::<M, Cpu>::open),
                    gpu: Err(M::NO_GPU),
                    shaders: &[],
                })
            },
        }
    }

    /// What the method is called.
    pub fn info(&self) -> &'static Info {
        self.info
    }

    /// Whether there is a GPU implementation.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn gpu(&self) -> Result<(), &'static str> {
        self.gpu
    }

    /// The method's GPU shaders.
    pub fn shaders(&self) -> &'static [Shader] {
        self.shaders
    }

    /// The formulas of the method's math.rs and math.wgsl.
    pub fn leaves(&self) -> &'static Leaves {
        self.leaves
    }

    /// The method with its default parameters.
    pub fn configure(&self) -> Box<dyn Configured> {
        (self.make)()
    }
}

/// A method without a GPU implementation.
pub trait CpuOnly: Estimator<Cpu> {
    /// Why there is none: shown where a GPU run was asked for.
    const NO_GPU: &'static str;
}

/// The methods that a program knows: a value, so that a stranger's `main` can add its own.
#[derive(Clone, Default)]
pub struct Registry {
    entries: Vec<Entry>,
}

impl Registry {
    /// The methods of this crate.
    pub fn builtin() -> Self {
        Self::default()
            .with(Entry::both::<crate::constant_ambient::ConstantAmbient>())
            .with(Entry::both::<crate::classic_envmap::ClassicEnvmap>())
            .with(Entry::both::<crate::sh_mip_envmap::ShMipEnvmap>())
            .with(Entry::both::<crate::phong_envmap::PhongEnvmap>())
            .with(Entry::both::<crate::localized_cubemap::LocalizedCubemap>())
            .with(Entry::both::<crate::point_form_factor::PointFormFactor>())
            .with(Entry::both::<crate::direct_radiance_map::DirectRadianceMap>())
            .with(Entry::both::<crate::polygon_form_factor::PolygonFormFactor>())
            .with(Entry::both::<crate::directional_ao::DirectionalAo>())
            .with(Entry::cpu_only::<crate::path_reference::PathReference>())
    }

    /// With one more method; it takes the place of one with the same id.
    pub fn with(mut self, entry: Entry) -> Self {
        self.entries.retain(|e| e.info.id != entry.info.id);
        self.entries.push(entry);
        self
    }

    /// All methods in the order in which they were registered.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The method of this id.
    ///
    /// # Errors
    /// [`UnknownEstimator`] with the nearest known id.
    pub fn get(&self, id: &str) -> Result<&Entry, UnknownEstimator> {
        let ids = || self.entries.iter().map(|e| e.info.id);
        let found = self.entries.iter().find(|e| e.info.id == id);
        found.ok_or_else(|| UnknownEstimator {
            id: id.into(),
            hint: params::nearest(id, ids())
                .map(|n| format!(", did you mean `{n}`?"))
                .unwrap_or_default(),
            known: ids().collect::<Vec<_>>().join(", "),
        })
    }
}

/// No method has this id.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no estimator `{id}`{hint}; known: {known}")]
pub struct UnknownEstimator {
    id: String,
    hint: String,
    known: String,
}
