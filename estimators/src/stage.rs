//! A scene set up on one backend: where captures, points and estimates live, and how a phase is
//! timed there.

mod cpu;
mod gpu;
mod once;

pub use cpu::CpuStage;
pub use gpu::GpuStage;
pub use once::{captured, estimated};

use crate::{Backend, Captures, Configured, EstimatorError, Session, Unsupported};
use interreflect_scene::{Environment, Estimate, Needs, Points, Scene};
use std::time::Instant;

/// What an estimator does in one phase.
pub type Phase<'p, B> = dyn FnMut(&mut <B as Backend>::Cx<'_>) -> Result<(), EstimatorError> + 'p;

/// A backend with a scene on it.
pub trait Stage {
    /// The backend.
    type Backend: Backend;

    /// Starts a method here.
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

    /// Finds the coarse solutions that captured radiance will hold: work done once for a scene, not
    /// once a frame. The milliseconds that this took when it was done, `None` if nothing is needed.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError>;

    /// Makes every capture that is needed, those that would be kept too, where they were made;
    /// milliseconds, without those of [`Stage::solve`].
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn capture(&self, needs: &Needs) -> Result<(Captures<Self::Backend>, f64), EstimatorError>;

    /// Runs one phase to its end; milliseconds.
    ///
    /// # Errors
    /// [`EstimatorError`] if the work fails or the backend refuses.
    fn timed(
        &self,
        label: &str,
        work: &mut Phase<'_, Self::Backend>,
    ) -> Result<f64, EstimatorError>;

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

    /// Whether all phases so far were timed by the device's own clock.
    fn device_clock(&self) -> bool;
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
