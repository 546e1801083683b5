//! What is done for one scene and quantity, in the order of the results.

use super::plan::Plan;
use crate::domain::record::Backend;
use crate::running::context::Context;
use crate::running::error::RunError;
use crate::running::truth::TRUTH;
use interreflect_estimators::{Configured, OwnModel, Quantity};
use interreflect_scene::digest;

/// Something that is done at once and kept.
pub(super) enum Task {
    /// A method on a backend, timed and compared.
    Run(Box<dyn Configured>, Backend),
    /// Path tracing or n-ray gathering, which methods are held against.
    Baseline(Box<dyn Configured>),
    /// What a method's model leaves out.
    Floor(Box<dyn Configured>),
    /// What a method's error is made of.
    Split(Box<dyn Configured>),
}

/// Samples a point of the baselines.
const RAYS: [u32; 4] = [1, 4, 16, 64];

/// Reflections of the baselines: no limit is path tracing; one, what n rays a point gather of emitted and
/// once reflected light.
const BOUNCES: [u32; 2] = [0, 1];

impl Task {
    /// All of them for a quantity.
    ///
    /// # Errors
    /// [`RunError`] if the registered path tracer does not take what baselines set.
    pub(super) fn all(
        context: &Context,
        plan: &Plan,
        quantity: Quantity,
        concluding: bool,
    ) -> Result<Vec<Self>, RunError> {
        let methods = plan.methods_for(quantity);
        let mut tasks = Vec::new();
        for method in &methods {
            let on = |backend: &Backend| Self::Run(method.boxed_clone(), *backend);
            tasks.extend(plan.backends.iter().map(on));
        }
        if tasks.is_empty() || !concluding {
            return Ok(tasks);
        }
        if plan.backends.contains(&Backend::Cpu) {
            let baselines = baselines(context, quantity)?;
            tasks.extend(baselines.into_iter().map(Self::Baseline));
        }
        let mut models: Vec<(&str, OwnModel)> = Vec::new();
        for method in &methods {
            let model = (method.info().id, method.model(quantity));
            if model.1 != TRUTH && !models.contains(&model) {
                models.push(model);
                tasks.push(Self::Floor(method.boxed_clone()));
            }
        }
        let split = methods.iter().filter(|m| m.model(quantity) != TRUTH);
        tasks.extend(split.map(|m| Self::Split(m.boxed_clone())));
        Ok(tasks)
    }

    /// What it is about, in a word.
    pub(super) fn label(&self) -> String {
        match self {
            Self::Run(method, backend) => format!("{} on {backend}", method.info().id),
            Self::Baseline(method) => format!("{} for comparison", method.info().id),
            Self::Floor(method) => format!("bias floor of {}", method.info().id),
            Self::Split(method) => format!("the error of {}", method.info().id),
        }
    }

    /// Digest of what the task is, beside where it is done.
    pub(super) fn digest(&self, quantity: Quantity) -> String {
        let (kind, method, backend) = match self {
            Self::Run(method, backend) => ("run", method, Some(*backend)),
            Self::Baseline(method) => ("baseline", method, None),
            Self::Floor(method) => ("floor", method, None),
            Self::Split(method) => ("split", method, None),
        };
        let values: Vec<String> = method
            .values()
            .iter()
            .map(|(f, v)| format!("{}={v}", f.name))
            .collect();
        digest(&(kind, method.info().id, values, backend, quantity))
    }
}

/// The registered path tracer at several sample counts, with and without further bounces.
fn baselines(context: &Context, quantity: Quantity) -> Result<Vec<Box<dyn Configured>>, RunError> {
    let traces =
        |m: &dyn Configured| m.quantities().contains(&quantity) && m.model(quantity) == TRUTH;
    let mut registered = context.registry.entries().iter().map(|e| e.configure());
    let Some(tracer) = registered.find(|m| traces(&**m)) else {
        return Ok(Vec::new());
    };
    let limits = match quantity {
        Quantity::AmbientOcclusion => &BOUNCES[..1],
        _ => &BOUNCES[..],
    };
    let mut baselines = Vec::new();
    for bounces in limits {
        for samples in RAYS {
            let settings = [
                ("bounces", bounces.to_string()),
                ("samples", samples.to_string()),
            ];
            baselines.push(context.configured_with(tracer.boxed_clone(), &settings)?);
        }
    }
    Ok(baselines)
}

#[cfg(test)]
mod tests;
