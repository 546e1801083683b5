//! The way from the truth to an estimate, step by step.

use super::scene_quantity::SceneQuantity;
use crate::domain::metrics::epsilon;
use crate::domain::record::{Backend, ErrorBreakdown, ParamMap, Part};
use crate::domain::significance::Difference;
use crate::running::error::RunError;
use crate::running::truth::TRUTH;
use glam::DVec3;
use interreflect_conformance::own_model::ModelValues;
use interreflect_cpu::tiles::Arithmetic;
use interreflect_estimators::{Configured, OwnModel};
use interreflect_scene::{Estimate, LightPaths, Points};

/// What a model leaves out of the truth, a step at a time; the last one ends at the model.
pub(super) fn left_out(model: OwnModel) -> Vec<(&'static str, OwnModel)> {
    let traced = |bounces| LightPaths {
        bounces,
        ..LightPaths::ALL
    };
    let alone = |paths| LightPaths {
        self_shadowing: false,
        ..paths
    };
    let as_captured = |bounces: u32| {
        let paths = traced(1 + bounces);
        vec![
            ("further bounces", OwnModel::LightTransport(paths)),
            (
                "receivers as occluders and reflectors",
                OwnModel::LightTransport(alone(paths)),
            ),
        ]
    };
    let with = |mut steps: Vec<_>, last: &[(&'static str, OwnModel)]| {
        steps.extend_from_slice(last);
        steps
    };
    match model {
        OwnModel::VisibleFromReference { bounces } => with(
            as_captured(bounces),
            &[("occlusion by the surroundings", model)],
        ),
        OwnModel::EnvironmentAtInfinity { bounces } => {
            with(as_captured(bounces), &[("parallax", model)])
        }
        OwnModel::MeanRadiance { bounces } => {
            let infinite = OwnModel::EnvironmentAtInfinity { bounces };
            with(
                as_captured(bounces),
                &[("parallax", infinite), ("direction", model)],
            )
        }
        OwnModel::FirstHitsOfLights { directional } => {
            let once = LightPaths {
                least_bounces: 1,
                ..traced(1)
            };
            let mut steps = vec![
                ("further bounces", OwnModel::LightTransport(traced(1))),
                ("emission and environment", OwnModel::LightTransport(once)),
                (
                    "occlusion",
                    OwnModel::FirstHitsOfLights { directional: true },
                ),
            ];
            if !directional {
                steps.push(("gloss of lit surfaces", model));
            }
            steps
        }
        OwnModel::OccludedEnvironment => vec![("light that surfaces reflect or emit", model)],
        OwnModel::LightTransport(LightPaths::ALL) => Vec::new(),
        OwnModel::LightTransport(_) => vec![("paths that are not followed", model)],
        OwnModel::Other(_) => vec![("what the model leaves out", model)],
    }
}

impl SceneQuantity<'_> {
    /// Splits a method's error into what its model leaves out, what its own approximation costs, and what
    /// single precision and the backends do to it.
    pub(super) fn split(
        &mut self,
        method: &dyn Configured,
        backends: &[Backend],
    ) -> Result<ErrorBreakdown, RunError> {
        let steps = left_out(method.model(self.quantity));
        let mut sum = Sum::new(self.points.clone(), self.references.model(TRUTH));
        for (name, model) in steps {
            let values = match model {
                OwnModel::LightTransport(_) => self.between.model(model),
                _ => self.references.model(model),
            };
            sum.step(name, None, &values.values, Some(&values.error));
        }
        let exact = self.estimate_in(method, Arithmetic::Float64)?;
        sum.step("the method's approximation", None, &exact, None);
        let host = self.estimate_in(method, Arithmetic::Lanes)?;
        sum.step("single precision", Some(Backend::Cpu), &host, None);
        let device = match backends.contains(&Backend::Gpu) {
            true => self.estimate_on_gpu(method)?,
            false => None,
        };
        if let Some(device) = device {
            let name = "the GPU instead of the CPU";
            sum.step(name, Some(Backend::Gpu), &device, None);
        }
        Ok(ErrorBreakdown {
            parts: sum.parts,
            ..self.no_split(method)
        })
    }

    /// A split without parts.
    pub(super) fn no_split(&self, method: &dyn Configured) -> ErrorBreakdown {
        ErrorBreakdown {
            scene: self.name.clone(),
            quantity: self.quantity.name().into(),
            estimator: method.info().id.into(),
            fidelity: method.fidelity().map(Into::into),
            params: ParamMap::of(method),
            parts: Vec::new(),
        }
    }
}

/// Steps so far.
struct Sum {
    points: Points,
    truth: Estimate,
    epsilon: f64,
    mean: f64,
    at: Estimate,
    /// Standard error of `at`; `None` if it is exact.
    error: Option<Estimate>,
    parts: Vec<Part>,
}

impl Sum {
    fn new(points: Points, truth: &ModelValues) -> Self {
        let values = || surfaces(&points, &truth.values);
        let count = 3.0 * values().count().max(1) as f64;
        let mean = values().map(DVec3::element_sum).sum::<f64>() / count;
        let magnitude = values().map(|v| v.abs().element_sum()).sum::<f64>() / count;
        Self {
            truth: truth.values.clone(),
            epsilon: epsilon(magnitude),
            mean,
            at: truth.values.clone(),
            error: Some(truth.error.clone()),
            points,
            parts: Vec::new(),
        }
    }

    /// From where the last step ended to these values.
    fn step(
        &mut self,
        name: &str,
        backend: Option<Backend>,
        to: &Estimate,
        error: Option<&Estimate>,
    ) {
        let weight = |i: usize| (self.truth.get(i).as_dvec3().powf(2.0) + self.epsilon).recip();
        let square = |e: Option<&Estimate>, i: usize| {
            e.map_or(DVec3::ZERO, |e| e.get(i).as_dvec3().powf(2.0))
        };
        let (mut count, mut signed, mut squared, mut noise) = (0.0, 0.0, 0.0, 0.0);
        for i in (0..to.len()).filter(|&i| self.points.get(i).is_some()) {
            let step = (to.get(i) - self.at.get(i)).as_dvec3();
            let errors = square(self.error.as_ref(), i) + square(error, i);
            count += 3.0;
            signed += step.element_sum();
            squared += (step * step * weight(i)).element_sum();
            noise += (errors * weight(i)).element_sum();
        }
        let relative = Difference {
            squared: squared / count,
            floor: noise / count,
        };
        self.parts.push(Part {
            name: name.into(),
            backend,
            mean: (self.mean != 0.0).then(|| signed / count / self.mean),
            relmse: relative.squared,
            noise_floor: relative.floor,
            above_noise: relative.is_above_noise(),
        });
        self.at = to.clone();
        self.error = error.cloned();
    }
}

fn surfaces<'a>(points: &'a Points, values: &'a Estimate) -> impl Iterator<Item = DVec3> + 'a {
    let at = (0..values.len()).filter(|&i| points.get(i).is_some());
    at.map(|i| values.get(i).as_dvec3())
}

#[cfg(test)]
mod tests;
