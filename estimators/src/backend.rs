//! The two backends.

use crate::error::Unsupported;
use crate::execution::{BackendScene, CpuLoadedScene, GpuLoadedScene, LoadedScene};
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::{scene::CpuScene, tiles::CpuCx};
use interreflect_gpu::{
    GpuContext, GpuCube, GpuCx, GpuDirectionalDepths, GpuEstimate, GpuPoints, GpuRsm,
};
use interreflect_scene::{CubeImage, Estimate, Points, RsmImage};

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Cpu {}
    impl Sealed for super::Gpu {}
}

/// Where an estimator runs.
pub trait Backend: sealed::Sealed + Copy + Send + Sync + 'static {
    /// Its name on the command line and in records.
    const NAME: &'static str;
    /// What varies from machine to machine.
    type Caps;
    /// What one phase runs with: threads, or an open command encoder.
    type Cx;
    /// A scene set up here.
    type Scene: BackendScene<Backend = Self>;
    /// A captured cube.
    type Cube;
    /// Where depth maps along directions come from.
    type Depths;
    /// Captured views from the lights.
    type Rsm;
    /// The shaded points.
    type Points;
    /// Where the estimate goes.
    type Out;
    /// Access to full light transport.
    type Transport;

    /// This backend's side of a loaded scene.
    ///
    /// # Errors
    /// [`Unsupported`] with the reason if the scene is not loaded here.
    fn side(scene: &LoadedScene) -> Result<&Self::Scene, Unsupported>;
}

/// The CPU backend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cpu;

/// The GPU backend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gpu;

impl Backend for Cpu {
    const NAME: &'static str = "cpu";
    type Caps = ();
    type Cx = CpuCx;
    type Scene = CpuLoadedScene;
    type Cube = CubeImage;
    type Depths = DirectionalDepths;
    type Rsm = RsmImage;
    type Points = Points;
    type Out = Estimate;
    type Transport = CpuScene;

    fn side(scene: &LoadedScene) -> Result<&CpuLoadedScene, Unsupported> {
        Ok(scene.cpu())
    }
}

impl Backend for Gpu {
    const NAME: &'static str = "gpu";
    type Caps = GpuContext;
    type Cx = GpuCx;
    type Scene = GpuLoadedScene;
    type Cube = GpuCube;
    type Depths = GpuDirectionalDepths;
    type Rsm = GpuRsm;
    type Points = GpuPoints;
    type Out = GpuEstimate;
    type Transport = std::convert::Infallible;

    fn side(scene: &LoadedScene) -> Result<&GpuLoadedScene, Unsupported> {
        scene.gpu()
    }
}
