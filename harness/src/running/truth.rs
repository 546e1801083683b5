//! What estimates are compared with, computed once for each scene, quantity and point list.

mod cache;

pub use cache::Cache;

use crate::domain::metrics;
use crate::domain::metrics::Reference;
use crate::domain::record::Comparison;
use crate::running::error::RunError;
use interreflect_conformance::own_model::{ModelValues, evaluate};
use interreflect_cpu::path_tracer::Stop;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::{Estimate, LightPaths, Points, digest};

/// Full light transport.
pub const TRUTH: OwnModel = OwnModel::LightTransport(LightPaths::ALL);

/// Keeps the references' random numbers apart from those of a path-traced estimate.
const SEED_APART: u64 = 0x7ef3_5a2c_91d4_0b68;

/// The references for one quantity at one list of points.
pub struct References<'a> {
    cx: &'a CpuCx,
    scene: &'a CpuScene,
    quantity: Quantity,
    points: &'a Points,
    stop: Stop,
    seed: u64,
    known: Vec<(OwnModel, ModelValues)>,
    cache: Option<Cache>,
}

impl<'a> References<'a> {
    /// No reference is computed before it is asked for.
    pub fn new(
        cx: &'a CpuCx,
        scene: &'a CpuScene,
        quantity: Quantity,
        points: &'a Points,
        stop: Stop,
        seed: u64,
    ) -> Self {
        Self {
            cx,
            scene,
            quantity,
            points,
            stop,
            seed: seed ^ SEED_APART,
            known: Vec::new(),
            cache: None,
        }
    }

    /// Looks values up in a folder before it computes them, and leaves them there.
    pub fn cached(self, cache: Option<Cache>) -> Self {
        Self { cache, ..self }
    }

    /// Full light transport.
    pub fn truth(&mut self) -> &ModelValues {
        self.model(TRUTH)
    }

    /// What a method claims to compute.
    pub fn model(&mut self, model: OwnModel) -> &ModelValues {
        let at = match self.known.iter().position(|(m, _)| *m == model) {
            Some(at) => at,
            None => {
                let values = self.evaluated(model);
                self.known.push((model, values));
                self.known.len() - 1
            }
        };
        &self.known[at].1
    }

    fn evaluated(&self, model: OwnModel) -> ModelValues {
        let key = digest(&(
            model,
            self.quantity,
            self.points.len(),
            self.stop,
            self.seed,
        ));
        let kept = self
            .cache
            .as_ref()
            .and_then(|c| c.get(&key, self.points.len()));
        kept.unwrap_or_else(|| {
            let values = evaluate(
                self.cx,
                model,
                self.quantity,
                self.scene,
                self.points,
                &self.stop,
                self.seed,
            );
            if let Some(cache) = &self.cache {
                cache.keep(&key, &values);
            }
            values
        })
    }

    /// Compares an estimate with its own model and with the truth; an error if it, or what it is
    /// compared with, is not finite.
    pub fn compare(
        &mut self,
        estimate: &Estimate,
        model: OwnModel,
    ) -> [Result<Comparison, RunError>; 2] {
        [model, TRUTH].map(|model| self.compare_with(estimate, model))
    }

    /// Compares an estimate with the truth alone.
    ///
    /// # Errors
    /// [`RunError`] if it, or the truth, is not finite.
    pub fn compare_with_truth(&mut self, estimate: &Estimate) -> Result<Comparison, RunError> {
        self.compare_with(estimate, TRUTH)
    }

    /// How far a model is from the truth, whoever computes it: a comparison of one reference with the other,
    /// whose noise is that of both.
    ///
    /// # Errors
    /// [`RunError`] if one of them is not finite.
    pub fn floor(&mut self, model: OwnModel) -> Result<Comparison, RunError> {
        let points = self.points;
        let of_model = self.model(model);
        let (values, own_error) = (of_model.values.clone(), of_model.error.clone());
        let truth = self.truth();
        let mut both = Estimate::new(own_error.len());
        for i in 0..both.len() {
            let (a, b) = (own_error.get(i), truth.error.get(i));
            both.set(i, (a * a + b * b).map(f32::sqrt));
        }
        let reference = Reference {
            values: &truth.values,
            standard_error: Some(&both),
            description: &truth.description,
        };
        Ok(metrics::compare(&values, reference, Some(points))?)
    }

    fn compare_with(
        &mut self,
        estimate: &Estimate,
        model: OwnModel,
    ) -> Result<Comparison, RunError> {
        let points = self.points;
        let values = self.model(model);
        let reference = Reference {
            values: &values.values,
            standard_error: Some(&values.error),
            description: &values.description,
        };
        Ok(metrics::compare(estimate, reference, Some(points))?)
    }
}
