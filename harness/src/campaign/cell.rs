//! One scene and one quantity: what is measured there, against references that are computed once.

use super::journal::Done;
use super::plan::Setup;
use super::tasks::Task;
use crate::clock::{Pulse, Sampling};
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::metrics;
use crate::record::{Backend, Comparison, Floor, ParamMap, Run};
use crate::stages::Stages;
use crate::truth::References;
use crate::view::View;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::{Arithmetic, CpuCx};
use interreflect_estimators::stage::{CpuStage, captured, estimated};
use interreflect_estimators::{Configured, EstimatorError, Quantity};
use interreflect_scene::{Estimate, Points};
use std::sync::Arc;

/// Where tasks are done.
pub(super) struct Cell<'a> {
    pub(super) name: String,
    pub(super) digest: String,
    pub(super) setup: &'a Setup,
    pub(super) quantity: Quantity,
    pub(super) cx: &'a CpuCx,
    pub(super) scene: Arc<CpuScene>,
    pub(super) stages: &'a Stages<'a>,
    pub(super) view: &'a View,
    pub(super) points: Points,
    pub(super) references: References<'a>,
    /// Light paths between the truth and a model, with fewer samples: what splits step over.
    pub(super) between: References<'a>,
    pub(super) sampling: Sampling,
    pub(super) machine: String,
}

/// What a task gave, and whether that is a failure: that a method can't run so is a result.
pub(super) struct Outcome {
    pub(super) done: Done,
    pub(super) failure: Option<String>,
}

impl Cell<'_> {
    /// Does a task.
    ///
    /// # Errors
    /// [`HarnessError`] if something fails that is not the method's own matter.
    pub(super) fn perform(
        &mut self,
        task: &Task,
        backends: &[Backend],
        pulse: &mut Pulse,
        gallery: &Gallery,
        suffix: &str,
    ) -> Result<Outcome, HarnessError> {
        let (done, failure) = match task {
            Task::Run(method, backend) => {
                let image = Some((gallery, image_name(&**method, *backend, suffix)));
                let (run, failure) = self.run(&**method, *backend, pulse, image);
                (Done::Run(Box::new(run)), failure)
            }
            Task::Baseline(method) => {
                let (run, failure) = self.run(&**method, Backend::Cpu, pulse, None);
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
        pulse: &mut Pulse,
        image: Option<(&Gallery, String)>,
    ) -> (Run, Option<String>) {
        let mut run = self.record(method, backend);
        let measured =
            self.stages
                .measure(backend, method, self.quantity, &self.points, &self.sampling);
        let timed = match measured {
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
        if let Some(shade) = timed.measured.phases.shade {
            run.time_source = shade.source;
        }
        run.phases_ms = timed.measured.phases;
        run.bytes = Some(timed.measured.bytes);
        run.software = timed.software;
        run.slowed = pulse.slowed();
        let shown = image.map_or(Ok(()), |(gallery, name)| {
            gallery.add(&name, &mut run, self.view, estimate)
        });
        let failure = shown.err().map(|why| why.to_string());
        (run, failure)
    }

    fn flip(&mut self, estimate: &Estimate) -> Option<f64> {
        flip_of(self.view, estimate, &self.references.truth().values)
    }

    fn record(&self, method: &dyn Configured, backend: Backend) -> Run {
        Run {
            fidelity: method.fidelity().map(str::to_owned),
            params: params(method),
            points: self.points.len(),
            scene_hash: Some(self.digest.clone()),
            settings: self.setup.varied.clone(),
            machine: Some(self.machine.clone()),
            ..Run::new(&*self.name, method.info().id, backend, self.quantity.name())
        }
    }

    fn floor(&mut self, method: &dyn Configured) -> Result<Floor, HarnessError> {
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
    fn without_split(&self, method: &dyn Configured, why: HarnessError) -> Outcome {
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
    ) -> Result<Estimate, HarnessError> {
        let cx = self.cx.with_arithmetic(arithmetic);
        let stage = CpuStage {
            cx: &cx,
            scene: self.scene.clone(),
        };
        let scene = self.scene.scene();
        let captures = captured(&stage, scene, method, self.quantity)?;
        Ok(estimated(
            &stage,
            scene,
            method,
            self.quantity,
            &captures,
            &self.points,
        )?)
    }

    /// An estimate on the GPU; `None` where it can't be had there.
    pub(super) fn estimate_on_gpu(
        &self,
        method: &dyn Configured,
    ) -> Result<Option<Estimate>, HarnessError> {
        let once = Sampling::ONCE;
        match self
            .stages
            .measure(Backend::Gpu, method, self.quantity, &self.points, &once)
        {
            Ok(timed) => Ok(Some(timed.measured.estimate)),
            Err(why) => match skip_reason(why) {
                (_, false) => Ok(None),
                (reason, true) => Err(HarnessError::Usage(reason)),
            },
        }
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

/// A method's parameters as a record keeps them.
pub(super) fn params(method: &dyn Configured) -> ParamMap {
    let values = method.values().into_iter();
    values.map(|(field, value)| (field.name, value)).collect()
}

/// Why a run did not take place, and whether that is a failure: that a method can't run so is a
/// result.
fn skip_reason(why: HarnessError) -> (String, bool) {
    match why {
        HarnessError::Unsupported(why)
        | HarnessError::Estimator(EstimatorError::Unsupported(why)) => (why.0, false),
        failure => (failure.to_string(), true),
    }
}

/// A comparison, or why there is none.
fn either(result: Result<Comparison, HarnessError>) -> (Option<Comparison>, Option<String>) {
    match result {
        Ok(comparison) => (Some(comparison), None),
        Err(why) => (None, Some(why.to_string())),
    }
}

#[cfg(test)]
mod tests;
