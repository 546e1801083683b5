//! A backend that methods are checked on.

use interreflect_cpu::scene::CpuError;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::{BackendScene, LoadedScene};
use interreflect_estimators::{
    Backend, Configured, Cpu, EstimatorError, Gpu, Quantity, Unsupported,
};
use interreflect_gpu::{GpuContext, GpuError};
use interreflect_scene::{Estimate, Points, Scene};
use std::sync::Arc;

/// Why a check could not be carried out: for a method that was said to work, a failure.
#[derive(Debug, thiserror::Error)]
pub enum VerifyError {
    /// The method can't run there.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// The CPU backend refuses the scene.
    #[error(transparent)]
    Cpu(#[from] CpuError),
    /// The GPU backend refuses.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The method failed.
    #[error(transparent)]
    Estimator(EstimatorError),
    /// What is compared can't be the same on both backends.
    #[error("{0}")]
    NotComparable(String),
    /// An estimate that is not finite.
    #[error("point {point} has the estimate {value}")]
    NotFinite {
        /// Index of the point.
        point: usize,
        /// Its value.
        value: glam::Vec3,
    },
}

impl From<EstimatorError> for VerifyError {
    fn from(error: EstimatorError) -> Self {
        match error {
            EstimatorError::Unsupported(why) => Self::Unsupported(why),
            other => Self::Estimator(other),
        }
    }
}

/// A backend.
#[derive(Clone, Copy)]
pub enum TestBackend<'a> {
    /// Host threads.
    Cpu(&'a CpuCx),
    /// A device, with the host threads that help it.
    Gpu(&'a CpuCx, &'a Arc<GpuContext>),
}

/// Work on a method in a scene that is loaded on some backend.
pub trait OnBackend {
    /// What it comes to.
    type Output;
    /// Does it.
    fn run<S: BackendScene>(self, scene: &S) -> Self::Output;
}

impl TestBackend<'_> {
    /// The backend's name.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Cpu(_) => Cpu::NAME,
            Self::Gpu(..) => Gpu::NAME,
        }
    }

    /// Whether a method has an implementation here.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if it has none.
    pub fn opens(&self, method: &dyn Configured) -> Result<(), Unsupported> {
        match self {
            Self::Cpu(_) => method.on_cpu().map(drop),
            Self::Gpu(_, context) => method.on_gpu(context).map(drop),
        }
    }

    /// Loads a scene here.
    ///
    /// # Errors
    /// [`VerifyError`] if the backend refuses the scene.
    pub fn load(&self, scene: &Scene) -> Result<LoadedScene, VerifyError> {
        match *self {
            Self::Cpu(cx) => Ok(LoadedScene::new(cx, scene)?),
            Self::Gpu(cx, context) => Ok(LoadedScene::new(cx, scene)?.with_gpu(context)?),
        }
    }

    /// Loads a scene and does some work on it.
    ///
    /// # Errors
    /// [`VerifyError`] if the backend refuses the scene.
    pub fn with<J: OnBackend>(&self, scene: &Scene, job: J) -> Result<J::Output, VerifyError> {
        let loaded = self.load(scene)?;
        Ok(match self {
            Self::Cpu(_) => job.run(loaded.cpu()),
            Self::Gpu(..) => job.run(loaded.gpu()?),
        })
    }

    /// A method's estimate in a scene.
    ///
    /// # Errors
    /// [`VerifyError`] if it can't be had or is not a number somewhere.
    pub fn estimate(
        &self,
        scene: &Scene,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
    ) -> Result<Estimate, VerifyError> {
        let mut one = self.estimates(scene, method, quantity, std::slice::from_ref(points))?;
        Ok(one.pop().unwrap_or_else(|| Estimate::new(0)))
    }

    /// A method's estimates at several lists of points, on the same captures.
    ///
    /// # Errors
    /// [`VerifyError`] as [`TestBackend::estimate`].
    pub fn estimates(
        &self,
        scene: &Scene,
        method: &dyn Configured,
        quantity: Quantity,
        lists: &[Points],
    ) -> Result<Vec<Estimate>, VerifyError> {
        let job = Estimates {
            method,
            quantity,
            lists,
        };
        let estimates = self.with(scene, job)??;
        for estimate in &estimates {
            let infinite = estimate.iter().enumerate().find(|(_, v)| !v.is_finite());
            if let Some((point, value)) = infinite {
                return Err(VerifyError::NotFinite { point, value });
            }
        }
        Ok(estimates)
    }
}

struct Estimates<'a> {
    method: &'a dyn Configured,
    quantity: Quantity,
    lists: &'a [Points],
}

impl OnBackend for Estimates<'_> {
    type Output = Result<Vec<Estimate>, EstimatorError>;

    fn run<S: BackendScene>(self, scene: &S) -> Self::Output {
        let mut captures = None;
        let estimate = |points| {
            let mut executor = scene.executor(self.method, self.quantity, points)?;
            if let Some(captures) = captures.take() {
                executor.set_captures(captures);
            }
            let estimate = executor.estimate()?;
            captures = Some(executor.captures()?);
            Ok(estimate)
        };
        self.lists.iter().map(estimate).collect()
    }
}
