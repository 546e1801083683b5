//! What experiments work with: scenes on the backends, methods, and measurements.

mod scenes;

use super::assets::Assets;
use super::experiment_scene::setting;
use super::measured_run::{MeasuredRun, amount_of};
use super::verdict::Amount;
use crate::domain::record::{Backend, Phases, Run};
use crate::running::clock::Sampling;
use crate::running::context::Context;
use crate::running::error::RunError;
use crate::running::frames::{Frame, Shaded};
use crate::running::on_backend::{Sequence, direct_light, measure_on, next_frame};
use crate::running::run_record;
use crate::running::truth::References;
use crate::running::view::View;
use interreflect_cpu::path_tracer::Stop;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity, VisibleTriangles};
use interreflect_scene::motion::Moves;
use interreflect_scene::{DirectLight, Estimate, Points, ReflectionLaw};

/// Methods, backends and models, and how much effort is made.
pub struct ExperimentContext<'a> {
    context: &'a Context,
    backends: Vec<Backend>,
    assets: Assets,
    quick: bool,
}

impl<'a> ExperimentContext<'a> {
    /// A context for those of the backends that there are; `quick` takes fewer points, samples and cases.
    pub fn new(context: &'a Context, backends: Vec<Backend>, assets: Assets, quick: bool) -> Self {
        Self {
            context,
            backends,
            assets,
            quick,
        }
    }

    /// The backends that there are.
    pub(super) fn backends(&self) -> Vec<Backend> {
        self.backends.clone()
    }

    /// The one of two that the effort calls for.
    pub(super) fn pick<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Points of a picture.
    pub(super) fn points(&self) -> usize {
        self.pick(8_000, 16_000)
    }

    /// When references are good enough.
    pub(super) fn stop(&self) -> Stop {
        Stop {
            samples: Some(self.pick(64, 256)),
            ..Stop::default()
        }
    }

    /// A method with parameters.
    pub(super) fn method(
        &self,
        id: &str,
        parameters: &[(&str, &dyn ToString)],
    ) -> Result<Box<dyn Configured>, RunError> {
        let settings = parameters
            .iter()
            .map(|(name, value)| setting(name, value.to_string()));
        self.context.configure(id, &settings.collect::<Vec<_>>())
    }

    /// The references of a quantity at points, none of them computed yet.
    pub(super) fn references<'b>(
        &'b self,
        loaded: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        self.references_to(self.stop(), loaded, quantity, points)
    }

    /// As [`Self::references`], with eight times as many samples: for what is cheap to trace and judged by
    /// more than a mean.
    pub(super) fn precise<'b>(
        &'b self,
        loaded: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        let stop = Stop {
            samples: self.stop().samples.map(|n| 8 * n),
            ..Stop::default()
        };
        self.references_to(stop, loaded, quantity, points)
    }

    fn references_to<'b>(
        &'b self,
        stop: Stop,
        loaded: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        let (cx, seed) = (&self.context.cpu, self.context.seed);
        References::new(cx, &loaded.cpu().scene, quantity, points, stop, seed)
    }

    /// Runs a method for its estimate alone: its record has no times.
    pub(super) fn run_once(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
    ) -> Result<MeasuredRun, RunError> {
        let mut measured =
            self.measured(loaded, backend, method, (quantity, points), &Sampling::ONCE)?;
        measured.run.phases_ms = Phases::default();
        Ok(measured)
    }

    /// Runs and times a method.
    pub(super) fn run_timed(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
    ) -> Result<MeasuredRun, RunError> {
        let usual = Sampling::default();
        let sampling = Sampling {
            most: self.pick(8, usual.most),
            patience_ms: self.pick(usual.patience_ms, 5.0 * usual.patience_ms),
            ..usual
        };
        self.measured(loaded, backend, method, (quantity, points), &sampling)
    }

    /// The only place that measures.
    fn measured(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        (quantity, points): (Quantity, &Points),
        sampling: &Sampling,
    ) -> Result<MeasuredRun, RunError> {
        let timed = measure_on(loaded, backend, method, quantity, points, sampling)?;
        let run = Run {
            points: points.len(),
            truth_missing: Some("compared by the experiment".into()),
            own_model_missing: Some("compared by the experiment".into()),
            ..Run::of(&loaded.scene().name, method, backend, quantity)
        };
        let run = run_record::measured(run, &timed);
        Ok(MeasuredRun {
            estimate: timed.measured.estimate,
            run,
        })
    }

    /// The direct light that the surfaces of a view reflect by Lambert's law, computed on a backend.
    pub(super) fn direct_light(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        view: &View,
    ) -> Result<Estimate, RunError> {
        self.direct_light_at(loaded, backend, &view.seen())
    }

    /// The direct light that points with materials reflect by Lambert's law, computed on a backend.
    pub(super) fn direct_light_at(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        points: &Points,
    ) -> Result<Estimate, RunError> {
        Ok(direct_light(loaded, backend, points, ReflectionLaw::Lambert.into())?.0)
    }

    /// Direct light at points, and the milliseconds that it takes, shadows included, over a few runs.
    pub(super) fn direct_light_timed(
        &self,
        loaded: &LoadedScene,
        backend: Backend,
        (points, how): (&Points, DirectLight),
    ) -> Result<(Estimate, Amount), RunError> {
        let (estimate, _) = direct_light(loaded, backend, points, how)?;
        let mut times_ms = Vec::new();
        for _ in 0..self.pick(3, 9) {
            times_ms.push(direct_light(loaded, backend, points, how)?.1.ms());
        }
        Ok((estimate, amount_of(&times_ms)))
    }

    /// Runs the next frame of a sequence.
    pub(super) fn frame(
        &self,
        loaded: &LoadedScene,
        (running, backend): (&mut Sequence, Backend),
        method: &dyn Configured,
        quantity: Quantity,
        (points, seen, moves): (&Points, Option<VisibleTriangles<'_>>, Moves),
    ) -> Result<Shaded, RunError> {
        let scene = loaded.scene();
        let frame = Frame {
            scene,
            moves,
            points,
            visible: seen,
        };
        next_frame(loaded, backend, running, method, quantity, &frame)
    }

    /// Whether times of a backend are a software adapter's.
    pub(super) fn software(&self, backend: Backend) -> bool {
        backend == Backend::Gpu && self.context.machine().software == Some(true)
    }
}
