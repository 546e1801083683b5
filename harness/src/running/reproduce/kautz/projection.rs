//! The size of the map that spherical harmonics are projected from.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::{OwnModel, Quantity};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.s5.1.1",
    paper: Paper::Kautz,
    item: Item::Section("5.1.1"),
    title: "size of the map that spherical harmonics are projected from",
    setup: &Projection {
        scenes: [
            SceneSetup::of("studio").with(&["bunny"]),
            SceneSetup::of("studio")
                .with(&["bunny"])
                .under("blender_courtyard"),
            SceneSetup::of("studio")
                .with(&["bunny"])
                .under("blender_interior"),
        ],
        texels: 8,
        many_texels: 64,
    },
    claims: &[Claim {
        id: "C1",
        says: "8×8 texels a face are enough for accurate harmonics.",
        rule: "A trial is an environment and a backend: irradiance from 8² texels differs from that from \
            64² by less than nine harmonics from 64² differ from the exact convolution, rms.",
    }],
};

/// A model under environments, and the sizes.
#[derive(Serialize)]
pub(super) struct Projection {
    pub(super) scenes: [SceneSetup; 3],
    /// Texels along a face's edge that are enough.
    pub(super) texels: u32,
    /// Texels along a face's edge that they are compared with.
    pub(super) many_texels: u32,
}

impl Runs for Projection {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::Irradiance;
        for setup in &self.scenes {
            let place = context.place(setup);
            let loaded = context.load(&place, &mut finding)?;
            let view = context.view(&loaded)?;
            let points = view.points(quantity.layout());
            let mut references = context.references(&loaded, quantity, &points);
            let exact = references.model(OwnModel::EnvironmentAtInfinity { bounces: 0 });
            let judge = Judge::new(exact, &points);
            let case = setup.environment.unwrap_or("sky");
            let mut row = Row::rendered(case, "exact convolution", &view, &exact.values);
            for backend in context.backends() {
                let mut shoot = |texels: u32| {
                    let harmonics =
                        context.method("sh_mip_envmap", &[("sh_resolution", &texels)])?;
                    let run =
                        context.run_timed(&loaded, backend, &*harmonics, quantity, &points)?;
                    let unit = ("ms", context.software(backend));
                    let name = format!("projection, {texels}² texels");
                    finding.time((case, name), backend, run.prepare_ms(), unit);
                    if backend == context.backends()[0] {
                        row.add(format!("{texels}² texels"), view.image(&run.estimate));
                    }
                    finding.runs.push(run.run);
                    Ok::<_, RunError>(run.estimate)
                };
                let (few, many) = (shoot(self.texels)?, shoot(self.many_texels)?);
                let by_size = Judge::at(&many, None, (0..many.len()).collect()).relative_rms(&few);
                let by_harmonics = judge.relative_rms(&many);
                for (name, rms) in [
                    ("rms by size / mean", by_size),
                    ("rms by nine harmonics / mean", by_harmonics),
                    ("rms of both / mean", judge.relative_rms(&few)),
                ] {
                    finding.measure((case, name), backend, rms, "");
                }
                finding.judge("C1", [enough(case, backend, by_size, by_harmonics)]);
            }
            finding.pictures.push(row);
        }
        Ok(finding)
    }
}

/// That fewer texels change less than leaving harmonics out does.
fn enough(case: &str, backend: Backend, by_size: Amount, by_harmonics: Amount) -> Trial {
    let what = format!("{case}: rms by the size below that by nine harmonics");
    Trial::less(what, backend, by_size, by_harmonics)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn texels_are_enough_while_the_harmonics_err_more() {
        let judged =
            |size, harmonics| signs([&enough("", Backend::Cpu, about(size), about(harmonics))]);
        assert_eq!(
            (judged(0.01, 0.02), judged(0.02, 0.01)),
            ("+".into(), "-".into())
        );
    }
}
