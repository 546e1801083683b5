//! Nine harmonics of a small cube map against the exact convolution.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::environments::environments;
use crate::error::HarnessError;
use interreflect_estimators::{OwnModel, Quantity};

/// Largest rms error over the mean that passes for the same.
const SAME: f64 = 0.05;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    for (name, place) in environments(desk, &mut finding) {
        let room = desk.room(&place, &mut finding)?;
        let view = desk.view(&room)?;
        let points = view.points(Quantity::Irradiance.layout());
        let materials = view.points(Quantity::GlossyRadiance.layout());
        let mut references = desk.references(&room, Quantity::Irradiance, &points);
        let exact = references.model(OwnModel::EnvironmentAtInfinity { bounces: 0 });
        let judge = Judge::new(exact, &points);
        let title = format!("{name}: irradiance");
        let mut row = Row::against(
            title,
            "exact convolution",
            view.image(&exact.values),
            view.surfaces(),
        );
        let mut lit = Row::plain(format!("{name}: diffuse and glossy, in one pass"));
        for backend in desk.backends() {
            let first = backend == desk.backends()[0];
            let harmonics = desk.method("sh_mip_envmap", &[])?;
            let convolved = desk.method("classic_envmap", &[])?;
            let shot =
                desk.timed_shot(&room, backend, &*harmonics, Quantity::Irradiance, &points)?;
            // Points with a glossy part: the pyramid is then made too.
            let both = desk.timed_shot(
                &room,
                backend,
                &*harmonics,
                Quantity::GlossyRadiance,
                &materials,
            )?;
            let slow =
                desk.timed_shot(&room, backend, &*convolved, Quantity::Irradiance, &points)?;
            let rms = judge.relative_rms(&shot.estimate);
            finding.measure((name, "rms error / mean"), backend, rms, "");
            for (label, ms) in [
                ("both maps", both.prepare_ms()),
                ("convolution", slow.prepare_ms()),
            ] {
                let unit = ("ms", desk.software(backend));
                finding.time((name, format!("prepare {label}")), backend, ms, unit);
            }
            let what = format!("{name}: irradiance, rms error over mean");
            finding
                .trials
                .push(Trial::less(what, backend, rms, Amount::exact(SAME)));
            let what = format!("{name}: both maps prepared before one convolution, ms");
            finding.trials.push(Trial::less(
                what,
                backend,
                both.prepare_ms(),
                slow.prepare_ms(),
            ));
            if first {
                row.add("nine harmonics", view.image(&shot.estimate));
                lit.add("harmonics and mip level", view.lit(&both.estimate));
            }
            finding.runs.extend([shot.run, both.run, slow.run]);
        }
        finding.pictures.extend([row, lit]);
    }
    Ok(finding)
}
