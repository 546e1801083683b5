//! A texel's average reflectivity by one sample in its direction, and from a table over angle and solid angle.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::room;
use super::room::SPECULAR;
use super::room::{Reflection, UNSHADOWED, localized};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "szirmay-kalos.reflectivity",
    paper: Paper::SzirmayKalos,
    item: Item::Section("3"),
    title: "average reflectivity by one sample or from a table",
    setup: &Reflectivities {
        scene: room(&["bunny"], SPECULAR),
        reflection: Reflection::Specular,
        resolutions: [2, 4],
        capture_resolution: CAPTURE,
        reflectivities: ["sample", "table"],
    },
    claims: &[Claim {
        id: "C1",
        says: "The average reflectivity is had by one sample or from a table, either way.",
        rule: "A trial is an M and a backend: with one sample the mean squared error against a path-traced \
            reference is less than twice that with the table, each up to one factor on its brightness.",
    }],
};

/// A model in the room, and maps of few texels.
#[derive(Serialize)]
pub(super) struct Reflectivities {
    pub(super) scene: SceneSetup,
    pub(super) reflection: Reflection,
    /// M, texels along a face's edge.
    pub(super) resolutions: [u32; 2],
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
    /// Ways to average.
    pub(super) reflectivities: [&'static str; 2],
}

/// Largest factor on the error of the one way that counts as doing as well.
const WORSE: f64 = 2.0;

impl Runs for Reflectivities {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = self.reflection.quantity();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let mut references = context.references(&loaded, quantity, &points);
        let truth = references.model(UNSHADOWED);
        let judge = Judge::new(truth, &points);
        let mut row = Row::rendered("reflectivity", "reference", &view, &truth.values);
        for m in self.resolutions {
            for backend in context.backends() {
                let mut errors = Vec::new();
                for way in self.reflectivities {
                    let texels = (m, self.capture_resolution);
                    let method = localized(context, texels, "shader", &[("reflectivity", &way)])?;
                    let run = context.run_timed(&loaded, backend, &*method, quantity, &points)?;
                    // The published lobe is not normalised.
                    let estimate = match self.reflection {
                        Reflection::Diffuse => run.estimate.clone(),
                        Reflection::Specular => scaled(&run.estimate, judge.factor(&run.estimate)),
                    };
                    let at = |name: &str| (format!("M = {m}"), format!("{name}, {way}"));
                    let error = judge.error(&estimate);
                    finding.measure(at(ERROR), backend, error, "");
                    let unit = ("ms", context.software(backend));
                    finding.time(at("shading"), backend, run.shade_ms(), unit);
                    if backend == context.backends()[0] {
                        row.add(format!("M = {m}, {way}"), view.image(&estimate));
                    }
                    errors.push(error);
                    finding.runs.push(run.run);
                }
                if let [sample, table] = errors[..] {
                    finding.judge("C1", [as_well(m, backend, sample, table)]);
                }
            }
        }
        finding.pictures.push(row);
        Ok(finding)
    }
}

/// That one sample errs less than twice as much as the table.
fn as_well(m: u32, backend: Backend, sample: Amount, table: Amount) -> Trial {
    let what = format!("M = {m}: error of one sample below {WORSE} times the table's");
    Trial::less(what, backend, sample, table.times(WORSE))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn one_sample_may_err_up_to_twice_as_much() {
        let judged = |sample, table| {
            let [sample, table] = [sample, table].map(Amount::exact);
            signs([&as_well(2, Backend::Cpu, sample, table)])
        };
        assert_eq!(
            (judged(1.9, 1.0), judged(2.1, 1.0)),
            ("+".into(), "-".into())
        );
    }
}
