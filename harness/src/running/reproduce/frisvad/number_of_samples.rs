//! §5: the number of samples.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::irradiance::{correlation, uniform};
use super::steps::{BOX, Step, view};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.samples",
    paper: Paper::Frisvad,
    item: Item::Section("5"),
    title: "number of samples",
    setup: &NumberOfSamples {
        scene: BOX,
        texels: 16,
        samples: [2, 3, 4, 5],
    },
    claims: &[
        Claim {
            id: "C1",
            says: "2×2 samples are better than a constant ambient term.",
            rule: "A trial is a backend: up to one factor on its brightness irradiance by 2×2 samples is \
                nearer to path tracing, in mean squared error beyond its noise, than the truth's mean colour.",
        },
        Claim {
            id: "C2",
            says: "They miss changing shades of bleeding.",
            rule: "A trial is a backend: colours correlate less with the truth's than those of 4×4 samples.",
        },
        Claim {
            id: "C3",
            says: "4×4 samples are not markedly better than 3×3.",
            rule: "A trial is a backend: up to brightness the error of 3×3 samples is less than 1.5 times that \
                of 4×4, beyond the reference's noise.",
        },
    ],
};

/// Most that the error of 3×3 samples may exceed that of 4×4 if these are not markedly better.
const MARKEDLY: f64 = 1.5;

/// As many samples along the edge of the grid, each in turn.
#[derive(Serialize)]
pub(super) struct NumberOfSamples {
    pub(super) scene: SceneSetup,
    pub(super) texels: u32,
    pub(super) samples: [u32; 4],
}

impl Runs for NumberOfSamples {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = view(context, &loaded, Step::Eq14)?;
        let points = view.points(Quantity::Irradiance.layout());
        let mut references = context.references(&loaded, Quantity::Irradiance, &points);
        let truth = references.truth();
        let judge = Judge::new(truth, &points);
        let ambient = uniform(&truth.values, &points);
        for backend in context.backends() {
            let title = format!("irradiance, {backend}");
            let mut row = Row::rendered(title, "path tracing", &view, &truth.values);
            row.add("best constant ambient term", view.image(&ambient));
            let mut found = Vec::new();
            for n in self.samples {
                let settings: [(&str, &dyn ToString); 2] =
                    [("map_resolution", &self.texels), ("samples_per_side", &n)];
                let map = context.method("direct_radiance_map", &settings)?;
                let quantity = Quantity::Irradiance;
                let measured = context.run_once(&loaded, backend, &*map, quantity, &points)?;
                // Shades are compared, not brightness: the published areas lose light by themselves.
                let shades = scaled(&measured.estimate, judge.factor(&measured.estimate));
                let alike = correlation(&shades, &truth.values);
                let error = judge.error(&shades);
                let case = format!("{n}×{n} samples");
                finding.measure((case.as_str(), ERROR), backend, error, "");
                let amount = Amount::exact(alike);
                finding.measure(
                    (case.as_str(), "correlation of colours"),
                    backend,
                    amount,
                    "",
                );
                row.add(case, view.image(&shades));
                finding.runs.push(measured.run);
                found.push((shades, error, alike));
            }
            finding.pictures.push(row);
            if let [two, three, four, ..] = &found[..] {
                let nearer = "2×2 samples nearer to the truth than a constant ambient term";
                let colours = "correlation of colours of 2×2 below that of 4×4 samples";
                finding.judge("C1", [judge.nearer(nearer, backend, &two.0, &ambient)]);
                finding.judge(
                    "C2",
                    [Trial::less_by(colours, backend, (two.2, four.2), 0.0)],
                );
                finding.judge("C3", [not_markedly(backend, three.1, four.1)]);
            }
        }
        Ok(finding)
    }
}

/// That 4×4 samples are not markedly better than 3×3.
fn not_markedly(backend: Backend, three: Amount, four: Amount) -> Trial {
    let what = "error of 3×3 below 1.5 times that of 4×4 samples";
    Trial::less(what, backend, three, four.times(MARKEDLY))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn half_as_much_error_again_is_markedly_more() {
        let markedly =
            |three, four| signs([&not_markedly(Backend::Cpu, about(three), about(four))]);
        assert_eq!([markedly(1.0, 1.0), markedly(2.0, 1.0)], ["+", "-"]);
    }
}
