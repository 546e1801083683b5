//! How a method is run: a scene is loaded on its backends once, and an [`Executor`] runs one method and
//! quantity on it, phase by phase.

mod cpu;
mod executor;
mod gpu;
mod loaded_scene;

pub use cpu::CpuLoadedScene;
pub use executor::{Executor, Suspended};
pub use gpu::GpuLoadedScene;
pub use loaded_scene::LoadedScene;

use crate::{Backend, Captures, Configured, EstimatorError, Quantity, Session, Unsupported};
use interreflect_gpu::{GpuTime, Mistimed};
use interreflect_scene::{DirectLight, Environment, Estimate, Needs, Points, Scene};
use std::time::Instant;

/// What is recorded, or done, in one phase.
pub type Phase<'p, B> = dyn FnMut(&mut <B as Backend>::Cx) -> Result<(), EstimatorError> + 'p;

/// One backend's side of a [`LoadedScene`]: where captures, points and estimates live, and how a phase
/// is timed there.
pub trait BackendScene {
    /// The backend.
    type Backend: Backend<Scene = Self>;

    /// The scene that is loaded.
    fn scene(&self) -> &Scene;

    /// What methods are asked whether they support it.
    fn caps(&self) -> &<Self::Backend as Backend>::Caps;

    /// Runs a method here, at these points.
    ///
    /// # Errors
    /// [`EstimatorError`] if the method can't work here or a point can't be shaded.
    fn executor<'s>(
        &'s self,
        method: &dyn Configured,
        quantity: Quantity,
        points: &'s Points,
    ) -> Result<Executor<'s, Self::Backend>, EstimatorError>
    where
        Self: Sized,
    {
        Executor::new(self, method, quantity, points)
    }

    /// Starts a session of a method.
    ///
    /// # Errors
    /// [`Unsupported`] if it has no implementation here.
    fn open(&self, method: &dyn Configured)
    -> Result<Box<dyn Session<Self::Backend>>, Unsupported>;

    /// Puts points, and room for their estimate, where the backend reads them.
    ///
    /// # Errors
    /// [`EstimatorError`] if one can't be shaded, or if they don't fit.
    fn place(&self, points: &Points) -> Result<Placed<Self::Backend>, EstimatorError>;

    /// Solves the coarse radiosity that captured radiance will hold: once for a scene, not once a
    /// frame. The milliseconds that this took when it was done, `None` if nothing is needed.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError>;

    /// Makes every capture that is needed, those that would be kept too, where they were made;
    /// the time is without that of [`BackendScene::solve`].
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn capture(&self, needs: &Needs) -> Result<(Captures<Self::Backend>, Elapsed), EstimatorError>;

    /// Runs one phase to its end.
    ///
    /// # Errors
    /// [`EstimatorError`] if the work fails or the backend refuses.
    fn timed(
        &self,
        label: &str,
        work: &mut Phase<'_, Self::Backend>,
    ) -> Result<Elapsed, EstimatorError>;

    /// Computes the direct light that placed points reflect, into their estimate: what a frame
    /// shows beside a method's. Points have the layout with materials.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn direct_light(
        &self,
        placed: &mut Placed<Self::Backend>,
        how: DirectLight,
    ) -> Result<Elapsed, EstimatorError>;

    /// Brings the estimate to the host; milliseconds, or `None` where it is there already.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn read_back(
        &self,
        out: &<Self::Backend as Backend>::Out,
    ) -> Result<(Estimate, Option<f64>), EstimatorError>;

    /// Milliseconds spent compiling so far, or `None` where nothing is compiled.
    fn compiled_ms(&self) -> Option<f64>;

    /// Bytes of captures in the host's memory; `None` where they are on a device.
    fn host_bytes(&self, captures: &Captures<Self::Backend>) -> Option<u64>;

    /// Bytes of all that was made on the device so far; `None` where all is in the host's memory.
    fn made_bytes(&self) -> Option<u64>;

    /// Whether times are those of a software adapter, which say nothing about a GPU.
    fn software(&self) -> bool;
}

/// How long a phase took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elapsed {
    /// Milliseconds by the host's clock, from the start of the work to its completion.
    pub wall_ms: f64,
    /// Milliseconds by the device's own clock, or why it did not time the work; `None` where the host
    /// does the work.
    pub device_ms: Option<Result<f64, Mistimed>>,
}

impl Elapsed {
    /// Time of work on the host that began then.
    pub fn since(start: Instant) -> Self {
        Self {
            wall_ms: milliseconds(start),
            device_ms: None,
        }
    }

    /// Milliseconds by the better clock that there is.
    pub fn ms(&self) -> f64 {
        match self.device_ms {
            Some(Ok(ms)) => ms,
            _ => self.wall_ms,
        }
    }
}

impl From<GpuTime> for Elapsed {
    fn from(time: GpuTime) -> Self {
        Self {
            wall_ms: time.wall_ms,
            device_ms: Some(time.device_ms),
        }
    }
}

/// Points and room for their estimate on a backend.
pub struct Placed<B: Backend> {
    /// The points.
    pub points: B::Points,
    /// Where the estimate goes.
    pub out: B::Out,
}

/// The environment, where it is asked for.
fn environment(needs: &Needs, scene: &Scene) -> Option<Environment> {
    scene.environment.clone().filter(|_| needs.environment)
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// The sum of some times; `None` without any.
fn sum(times_ms: impl Iterator<Item = f64>) -> Option<f64> {
    times_ms.reduce(|a, b| a + b)
}
