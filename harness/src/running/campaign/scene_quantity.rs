//! One scene and one quantity: what is measured there, against references that are computed once.

use super::journal::Done;
use super::observer::Images;
use super::plan::Setup;
use super::tasks::Task;
use crate::domain::metrics;
use crate::domain::record::{Backend, Comparison, Floor, ParamMap, Run};
use crate::running::clock::{Sampling, Throttle};
use crate::running::error::RunError;
use crate::running::on_backend::{Timed, measure_on};
use crate::running::run_record;
use crate::running::truth::References;
use crate::running::view::View;
use glam::Vec3;
use interreflect_cpu::tiles::{Arithmetic, CpuCx};
use interreflect_estimators::execution::{BackendScene, CpuLoadedScene, LoadedScene};
use interreflect_estimators::{Configured, EstimatorError, Quantity};
use interreflect_scene::{Estimate, Points};

/// Where tasks are done.
pub(super) struct SceneQuantity<'a> {
    pub(super) name: String,
    pub(super) digest: String,
    pub(super) setup: &'a Setup,
    pub(super) quantity: Quantity,
    pub(super) cx: &'a CpuCx,
    pub(super) loaded: &'a LoadedScene,
    pub(super) view: &'a View,
    pub(super) points: Points,
    pub(super) references: References<'a>,
    /// Light paths between the truth and a model, with fewer samples: what splits step over.
    pub(super) between: References<'a>,
    pub(super) sampling: Sampling,
    pub(super) machine: String,
    /// The last estimate that has an image, for the other backend's to be compared with.
    pub(super) last: Option<LastEstimate>,
}

/// An estimate of one backend.
pub(super) struct LastEstimate {
    label: String,
    params: ParamMap,
    backend: Backend,
    estimate: Estimate,
}

/// Largest mean difference of the backends' estimates over their mean that captures explain: a rasteriser
/// and rays decide texels on edges of surfaces, shadows and silhouettes otherwise.
const APART: f64 = 0.05;

/// What a task gave, and whether that is a failure: that a method can't run so is a result.
pub(super) struct Outcome {
    pub(super) done: Done,
    pub(super) failure: Option<String>,
}

impl SceneQuantity<'_> {
    /// Does a task.
    ///
    /// # Errors
    /// [`RunError`] if something fails that is not the method's own matter.
    pub(super) fn perform(
        &mut self,
        task: &Task,
        backends: &[Backend],
        throttle: &mut Throttle,
        images: &dyn Images,
        suffix: &str,
    ) -> Result<Outcome, RunError> {
        let (done, failure) = match task {
            Task::Run(method, backend) => {
                let image = Some((images, image_name(&**method, *backend, suffix)));
                let (run, failure) = self.run(&**method, *backend, throttle, image);
                (Done::Run(Box::new(run)), failure)
            }
            Task::Baseline(method) => {
                let (run, failure) = self.run(&**method, Backend::Cpu, throttle, None);
                (Done::Baseline(Box::new(run)), failure)
            }
            Task::Floor(method) => (Done::Floor(Box::new(self.floor(&**method)?)), None),
            Task::Split(method) => match self.split(&**method, backends) {
                Ok(split) => (Done::Split(Box::new(split)), None),
                Err(why) => return Ok(self.without_split(&**method, why)),
            },
        };
        Ok(Outcome { done, failure })
    }

    /// A run; one without an image is a baseline, which is held against the truth alone.
    fn run(
        &mut self,
        method: &dyn Configured,
        backend: Backend,
        throttle: &mut Throttle,
        image: Option<(&dyn Images, String)>,
    ) -> (Run, Option<String>) {
        let mut run = self.record(method, backend);
        let timed = match self.measured(method, backend, &self.sampling) {
            Ok(timed) => timed,
            Err(why) => {
                let (reason, failed) = skip_reason(why);
                let label = || format!("{} on {backend} in {}: {reason}", run.label(), self.name);
                let failure = failed.then(label);
                run.skipped = Some(reason);
                return (run, failure);
            }
        };
        let estimate = &timed.measured.estimate;
        let truth = match image {
            Some(_) => {
                let model = method.model(self.quantity);
                let [own, truth] = self.references.compare(estimate, model);
                (run.own_model, run.own_model_missing) = either(own);
                truth
            }
            None => {
                run.own_model_missing = Some("held against the truth alone".into());
                self.references.compare_with_truth(estimate)
            }
        };
        (run.truth, run.truth_missing) = either(truth);
        if let Some(truth) = &mut run.truth {
            truth.flip = self.flip(estimate);
        }
        let mut run = run_record::measured(run, &timed);
        if image.is_some() {
            run.backends_apart = self.apart_from_last(&run, estimate);
        }
        run.slowed = throttle.slowed();
        let shown = image.map_or(Ok(()), |(images, name)| {
            images.estimate(&name, &mut run, self.view, estimate)
        });
        let failure = shown.err().map(|why| why.to_string());
        (run, failure)
    }

    /// How far a run's estimate is from the other backend's, if the run before was that, and if it is
    /// more than captures explain.
    fn apart_from_last(&mut self, run: &Run, estimate: &Estimate) -> Option<f64> {
        let this = LastEstimate {
            label: run.label(),
            params: run.params.clone(),
            backend: run.backend,
            estimate: estimate.clone(),
        };
        let last = self.last.replace(this)?;
        let same = (&last.label, &last.params) == (&run.label(), &run.params);
        if !same || last.backend == run.backend {
            return None;
        }
        let apart = mean_difference(&last.estimate, estimate);
        (apart > APART).then_some(apart)
    }

    fn measured(
        &self,
        method: &dyn Configured,
        backend: Backend,
        sampling: &Sampling,
    ) -> Result<Timed, RunError> {
        let (quantity, points) = (self.quantity, &self.points);
        measure_on(self.loaded, backend, method, quantity, points, sampling)
    }

    fn flip(&mut self, estimate: &Estimate) -> Option<f64> {
        flip_of(self.view, estimate, &self.references.truth().values)
    }

    fn record(&self, method: &dyn Configured, backend: Backend) -> Run {
        Run {
            points: self.points.len(),
            scene_hash: Some(self.digest.clone()),
            settings: self.setup.varied.clone(),
            machine: Some(self.machine.clone()),
            ..Run::of(&*self.name, method, backend, self.quantity)
        }
    }

    fn floor(&mut self, method: &dyn Configured) -> Result<Floor, RunError> {
        let model = method.model(self.quantity);
        Ok(Floor {
            scene: self.name.clone(),
            quantity: self.quantity.name().into(),
            estimator: method.info().id.into(),
            model: format!("{model:?}"),
            against_truth: self.references.floor(model)?,
        })
    }

    /// A split without parts: the method can't run here, as its run says.
    fn without_split(&self, method: &dyn Configured, why: RunError) -> Outcome {
        let (reason, failed) = skip_reason(why);
        let label = format!(
            "the error of {} in {}: {reason}",
            method.info().id,
            self.name
        );
        Outcome {
            done: Done::Split(Box::new(self.no_split(method))),
            failure: failed.then_some(label),
        }
    }

    /// An estimate on the host in some arithmetic.
    pub(super) fn estimate_in(
        &self,
        method: &dyn Configured,
        arithmetic: Arithmetic,
    ) -> Result<Estimate, RunError> {
        let cx = self.cx.with_arithmetic(arithmetic);
        let scene = CpuLoadedScene::new(&cx, self.loaded.cpu().scene.clone());
        Ok(scene
            .executor(method, self.quantity, &self.points)?
            .estimate()?)
    }

    /// An estimate on the GPU; `None` where it can't be had there.
    pub(super) fn estimate_on_gpu(
        &self,
        method: &dyn Configured,
    ) -> Result<Option<Estimate>, RunError> {
        match self.measured(method, Backend::Gpu, &Sampling::ONCE) {
            Ok(timed) => Ok(Some(timed.measured.estimate)),
            Err(why) => match skip_reason(why) {
                (_, false) => Ok(None),
                (reason, true) => Err(RunError::Usage(reason)),
            },
        }
    }
}

/// Mean absolute difference of two estimates over the mean of the first; 0 where both are black. Also 0 if one
/// is not finite: its comparison with the references says that.
fn mean_difference(a: &Estimate, b: &Estimate) -> f64 {
    let sum = |values: &mut dyn Iterator<Item = Vec3>| -> f64 {
        values.map(|v| f64::from(v.abs().element_sum())).sum()
    };
    let difference = sum(&mut a.iter().zip(b.iter()).map(|(a, b)| a - b));
    match difference > 0.0 {
        true => difference / sum(&mut a.iter()),
        false => 0.0,
    }
}

/// Mean FLIP of an estimate's image against the truth's, over the pixels that show a surface.
fn flip_of(view: &View, estimate: &Estimate, truth: &Estimate) -> Option<f64> {
    let surfaces = view.surfaces();
    let images = [estimate, truth].map(|e| view.image(e));
    let flip = metrics::flip(&images[0], &images[1], |i| surfaces[i]);
    flip.map(|f| f.mean)
}

/// Name of the file of an estimate's image, with what tells it from others of its method.
fn image_name(method: &dyn Configured, backend: Backend, suffix: &str) -> String {
    let fidelity = method.fidelity().map_or(String::new(), |f| format!("-{f}"));
    format!("{}{fidelity}-{backend}{suffix}", method.info().id)
}

/// Why a run did not take place, and whether that is a failure: that a method can't run so is a
/// result.
fn skip_reason(why: RunError) -> (String, bool) {
    match why {
        RunError::Unsupported(why) | RunError::Estimator(EstimatorError::Unsupported(why)) => {
            (why.0, false)
        }
        failure => (failure.to_string(), true),
    }
}

/// A comparison, or why there is none.
fn either(result: Result<Comparison, RunError>) -> (Option<Comparison>, Option<String>) {
    match result {
        Ok(comparison) => (Some(comparison), None),
        Err(why) => (None, Some(why.to_string())),
    }
}

#[cfg(test)]
mod tests;
