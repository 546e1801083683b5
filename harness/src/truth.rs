//! What estimates are compared with, computed once for each scene, quantity and point list.

use crate::error::HarnessError;
use crate::metrics::{self, Reference};
use crate::record::Comparison;
use interreflect_conformance::own_model::{ModelValues, evaluate};
use interreflect_cpu::path_tracer::{LightPaths, Stop};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{OwnModel, Quantity};
use interreflect_scene::{Estimate, Points};

/// Full light transport.
const TRUTH: OwnModel = OwnModel::LightTransport(LightPaths::ALL);

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
        }
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
                let (cx, scene, points) = (self.cx, self.scene, self.points);
                let values = evaluate(
                    cx,
                    model,
                    self.quantity,
                    scene,
                    points,
                    &self.stop,
                    self.seed,
                );
                self.known.push((model, values));
                self.known.len() - 1
            }
        };
        &self.known[at].1
    }

    /// Compares an estimate with its own model and with the truth; an error if it, or what it is
    /// compared with, is not finite.
    pub fn compare(
        &mut self,
        estimate: &Estimate,
        model: OwnModel,
    ) -> [Result<Comparison, HarnessError>; 2] {
        [model, TRUTH].map(|model| self.compare_with(estimate, model))
    }

    fn compare_with(
        &mut self,
        estimate: &Estimate,
        model: OwnModel,
    ) -> Result<Comparison, HarnessError> {
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
