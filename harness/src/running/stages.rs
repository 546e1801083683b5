//! A scene on the backends that there are, and a method measured on the one that is asked for.

use crate::domain::record::Backend;
use crate::running::clock::Sampling;
use crate::running::context::Loaded;
use crate::running::error::RunError as HarnessError;
use crate::running::frames::{Frame, Frames, Shaded};
use crate::running::measure::{Measured, measure};
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::stage::{CpuStage, GpuStage, Stage};
use interreflect_estimators::{Configured, Cpu, Gpu, Quantity, Unsupported};
use interreflect_scene::{LightViewImage, Needs, Points};

/// A scene on each backend.
pub struct Stages<'a> {
    cpu: CpuStage<'a>,
    gpu: Result<GpuStage<'a>, Unsupported>,
}

/// A sequence on each backend, begun where its first frame was asked for.
#[derive(Default)]
pub struct Running {
    cpu: Option<Frames<Cpu>>,
    gpu: Option<Frames<Gpu>>,
}

/// A measurement with what its times mean.
pub struct Timed {
    /// The estimate and its times.
    pub measured: Measured,
    /// On an adapter that runs on the CPU.
    pub software: bool,
}

impl<'a> Stages<'a> {
    /// Takes over a loaded scene; a GPU that is not there is found out when it is asked for.
    pub fn new(cx: &'a CpuCx, loaded: Loaded) -> Self {
        let cpu = CpuStage {
            cx,
            scene: loaded.cpu,
        };
        let gpu = match loaded.gpu {
            Some(Ok((context, scene))) => Ok(GpuStage::new(context, scene, cpu.clone())),
            Some(Err(error)) => Err(Unsupported(error.to_string())),
            None => Err(Unsupported("the GPU was not asked for".into())),
        };
        Self { cpu, gpu }
    }

    /// The views from the lights that are needed, as images on the host.
    ///
    /// # Errors
    /// [`HarnessError`] if they can't be captured, or if there is no GPU.
    pub fn light_views(
        &self,
        backend: Backend,
        needs: &Needs,
    ) -> Result<Vec<LightViewImage>, HarnessError> {
        match backend {
            Backend::Cpu => {
                let captures = self.cpu.capture(needs)?.0;
                Ok(captures.light_views.into_values().collect())
            }
            Backend::Gpu => {
                let stage = self.gpu.as_ref().map_err(Clone::clone)?;
                let captures = stage.capture(needs)?.0;
                let views = captures.light_views.values();
                let images = views.map(|views| views.download(&stage.context));
                Ok(images.collect::<Result<_, _>>()?)
            }
        }
    }

    /// Runs the next frame of a sequence on a backend.
    ///
    /// # Errors
    /// [`HarnessError`] as [`Frames::next`], or if there is no GPU.
    pub fn next_frame(
        &self,
        backend: Backend,
        running: &mut Running,
        method: &dyn Configured,
        quantity: Quantity,
        frame: &Frame<'_>,
    ) -> Result<Shaded, HarnessError> {
        match backend {
            Backend::Cpu => next(&self.cpu, &mut running.cpu, method, quantity, frame),
            Backend::Gpu => {
                let stage = self.gpu.as_ref().map_err(Clone::clone)?;
                next(stage, &mut running.gpu, method, quantity, frame)
            }
        }
    }

    /// Runs a method as [`measure`] does.
    ///
    /// # Errors
    /// [`HarnessError`] as there, or if there is no GPU.
    pub fn measure(
        &self,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
        sampling: &Sampling,
    ) -> Result<Timed, HarnessError> {
        let scene = self.cpu.scene.scene();
        match backend {
            Backend::Cpu => Ok(Timed {
                measured: measure(&self.cpu, scene, method, quantity, points, sampling)?,
                software: false,
            }),
            Backend::Gpu => {
                let stage = self.gpu.as_ref().map_err(Clone::clone)?;
                Ok(Timed {
                    measured: measure(stage, scene, method, quantity, points, sampling)?,
                    software: stage.context.info().software,
                })
            }
        }
    }
}

fn next<S: Stage>(
    stage: &S,
    running: &mut Option<Frames<S::Backend>>,
    method: &dyn Configured,
    quantity: Quantity,
    frame: &Frame<'_>,
) -> Result<Shaded, HarnessError> {
    let frames = match running.take() {
        Some(frames) => frames,
        None => Frames::new(stage, method)?,
    };
    running.insert(frames).next(stage, method, quantity, frame)
}
