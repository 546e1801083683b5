//! A method on the backend that is asked for: measured, frame by frame, or its captures alone.

use crate::domain::record::Backend;
use crate::running::clock::Sampling;
use crate::running::error::RunError;
use crate::running::frames::{Frame, Frames, Shaded};
use crate::running::measure::{Measured, measure};
use interreflect_estimators::execution::{BackendScene, Elapsed, LoadedScene};
use interreflect_estimators::{Configured, Cpu, Gpu, Quantity};
use interreflect_scene::{DirectLight, Estimate, Needs, Points, RsmImage};

/// A sequence of frames on each backend, begun where its first frame was asked for.
#[derive(Default)]
pub struct Sequence {
    cpu: Frames<Cpu>,
    gpu: Frames<Gpu>,
}

/// A measurement with what its times mean.
pub struct Timed {
    /// The estimate and its times.
    pub measured: Measured,
    /// On an adapter that runs on the CPU.
    pub software: bool,
}

/// Runs a method as [`measure`] does.
///
/// # Errors
/// [`RunError`] as there, or if the scene is not on that backend.
pub fn measure_on(
    scene: &LoadedScene,
    backend: Backend,
    method: &dyn Configured,
    quantity: Quantity,
    points: &Points,
    sampling: &Sampling,
) -> Result<Timed, RunError> {
    match backend {
        Backend::Cpu => Ok(Timed {
            measured: measure(scene.on::<Cpu>()?, method, quantity, points, sampling)?,
            software: false,
        }),
        Backend::Gpu => {
            let side = scene.on::<Gpu>()?;
            Ok(Timed {
                measured: measure(side, method, quantity, points, sampling)?,
                software: side.software(),
            })
        }
    }
}

/// Runs the next frame of a sequence on a backend.
///
/// # Errors
/// [`RunError`] as [`Frames::next`], or if the scene is not on that backend.
pub fn next_frame(
    scene: &LoadedScene,
    backend: Backend,
    sequence: &mut Sequence,
    method: &dyn Configured,
    quantity: Quantity,
    frame: &Frame<'_>,
) -> Result<Shaded, RunError> {
    match backend {
        Backend::Cpu => sequence
            .cpu
            .next(scene.on::<Cpu>()?, method, quantity, frame),
        Backend::Gpu => sequence
            .gpu
            .next(scene.on::<Gpu>()?, method, quantity, frame),
    }
}

/// The direct light that points reflect, and the time that this took.
///
/// # Errors
/// [`RunError`] if the backend refuses, or if the scene is not on it.
pub fn direct_light(
    scene: &LoadedScene,
    backend: Backend,
    points: &Points,
    how: DirectLight,
) -> Result<(Estimate, Elapsed), RunError> {
    fn on<B: BackendScene>(
        side: &B,
        points: &Points,
        how: DirectLight,
    ) -> Result<(Estimate, Elapsed), RunError> {
        let mut placed = side.place(points)?;
        let elapsed = side.direct_light(&mut placed, how)?;
        Ok((side.read_back(&placed.out)?.0, elapsed))
    }
    match backend {
        Backend::Cpu => on(scene.on::<Cpu>()?, points, how),
        Backend::Gpu => on(scene.on::<Gpu>()?, points, how),
    }
}

/// The views from the lights that are needed, as images on the host.
///
/// # Errors
/// [`RunError`] if they can't be captured, or if the scene is not on that backend.
pub fn rsms(
    scene: &LoadedScene,
    backend: Backend,
    needs: &Needs,
) -> Result<Vec<RsmImage>, RunError> {
    match backend {
        Backend::Cpu => {
            let captures = scene.on::<Cpu>()?.capture(needs)?.0;
            Ok(captures.rsms.into_values().collect())
        }
        Backend::Gpu => {
            let side = scene.on::<Gpu>()?;
            let captures = side.capture(needs)?.0;
            let views = captures.rsms.values();
            let images = views.map(|views| views.download(&side.context));
            Ok(images.collect::<Result<_, _>>()?)
        }
    }
}
