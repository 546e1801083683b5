//! Nine harmonics of a small cube map against the exact convolution.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::environments::environments;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::{OwnModel, Quantity};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.harmonics",
    paper: Paper::Kautz,
    item: Item::NotInThePaper,
    title: "nine harmonics against the exact convolution",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Nine harmonics of 8² texels a face light a diffuse object as the whole environment does.",
            rule: "A trial is an environment and a backend: the irradiance differs from the exact \
                convolution by less than 5 % rms of its mean.",
        },
        Claim {
            id: "C2",
            says: "Both maps are prepared anew sooner than one is convolved.",
            rule: "A trial is an environment and a backend, beyond the spread of both times.",
        },
    ],
};

/// Largest rms error over the mean that passes for the same.
const SAME: f64 = 0.05;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for (name, place) in environments(context, &mut finding) {
        let loaded = context.load(&place, &mut finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(Quantity::Irradiance.layout());
        let materials = view.points(Quantity::GlossyRadiance.layout());
        let mut references = context.references(&loaded, Quantity::Irradiance, &points);
        let exact = references.model(OwnModel::EnvironmentAtInfinity { bounces: 0 });
        let judge = Judge::new(exact, &points);
        let title = format!("{name}: irradiance");
        let mut row = Row::rendered(title, "exact convolution", &view, &exact.values);
        let mut lit = Row::plain(format!("{name}: diffuse and glossy, in one pass"));
        for backend in context.backends() {
            let first = backend == context.backends()[0];
            let harmonics = context.method("sh_mip_envmap", &[])?;
            let convolved = context.method("classic_envmap", &[])?;
            let measured =
                context.run_timed(&loaded, backend, &*harmonics, Quantity::Irradiance, &points)?;
            // Points with a glossy part: the pyramid is then made too.
            let both = context.run_timed(
                &loaded,
                backend,
                &*harmonics,
                Quantity::GlossyRadiance,
                &materials,
            )?;
            let slow =
                context.run_timed(&loaded, backend, &*convolved, Quantity::Irradiance, &points)?;
            let rms = judge.relative_rms(&measured.estimate);
            finding.measure((name, "rms error / mean"), backend, rms, "");
            for (label, ms) in [
                ("both maps", both.prepare_ms()),
                ("convolution", slow.prepare_ms()),
            ] {
                let unit = ("ms", context.software(backend));
                finding.time((name, format!("prepare {label}")), backend, ms, unit);
            }
            let times = (both.prepare_ms(), slow.prepare_ms());
            let [same, sooner] = judged(name, backend, rms, times);
            finding.judge("C1", [same]);
            finding.judge("C2", [sooner]);
            if first {
                row.add("nine harmonics", view.image(&measured.estimate));
                lit.add(
                    "harmonics and mip level",
                    view.lit(
                        &both.estimate,
                        &context.direct_light(&loaded, backend, &view)?,
                    ),
                );
            }
            finding.runs.extend([measured.run, both.run, slow.run]);
        }
        finding.pictures.extend([row, lit]);
    }
    Ok(finding)
}

/// That the irradiance is the exact convolution's, and both maps are prepared before one is convolved.
fn judged(
    name: &str,
    backend: Backend,
    rms: Amount,
    (both_ms, convolution_ms): (Amount, Amount),
) -> [Trial; 2] {
    let same = format!("{name}: irradiance, rms error over mean");
    let sooner = format!("{name}: both maps prepared before one convolution, ms");
    [
        Trial::less(same, backend, rms, Amount::exact(SAME)),
        Trial::less(sooner, backend, both_ms, convolution_ms),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn harmonics_are_within_five_percent_and_sooner() {
        let judged = |rms, both, slow| {
            signs(&judged(
                "case",
                Backend::Cpu,
                about(rms),
                (about(both), about(slow)),
            ))
        };
        assert_eq!(judged(0.04, 1.0, 2.0), "++");
        assert_eq!(judged(0.06, 2.0, 1.0), "--");
        assert_eq!(judged(0.049, 1.0, 1.1), "??");
    }
}
