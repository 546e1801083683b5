//! The diffuse part at vertices and at pixels.

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
use crate::running::view::{Look, ShadedAt};
use interreflect_estimators::{OwnModel, Quantity};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.vertices",
    paper: Paper::Kautz,
    item: Item::Section("4.1"),
    title: "diffuse part at vertices or at pixels",
    setup: &Vertices {
        scene: SceneSetup::of("studio")
            .with(&["bunny"])
            .under("blender_courtyard"),
    },
    claims: &[Claim {
        id: "C1",
        says: "The diffuse part need not be evaluated at every pixel: it varies slowly.",
        rule: "A trial is a backend: a picture interpolated from vertices differs from one shaded at \
            pixels by less than that differs from the exact convolution, rms.",
    }],
};

/// A model under an environment.
#[derive(Serialize)]
pub(super) struct Vertices {
    pub(super) scene: SceneSetup,
}

impl Runs for Vertices {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::Irradiance;
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let look = |at| {
            let width = context.pick(180, 512);
            let look = Look {
                at,
                ..Look::default()
            };
            context.whole_view(&loaded, width, look)
        };
        let (pixels, vertices) = (look(ShadedAt::Pixels)?, look(ShadedAt::Vertices)?);
        let points = [&pixels, &vertices].map(|view| view.points(quantity.layout()));
        let mut references = context.references(&loaded, quantity, &points[0]);
        let exact = references.model(OwnModel::EnvironmentAtInfinity { bounces: 0 });
        let surfaces = pixels.surfaces();
        let shown: Vec<usize> = (0..surfaces.len()).filter(|&i| surfaces[i]).collect();
        let mut row = Row::rendered("irradiance", "exact convolution", &pixels, &exact.values);
        let exact = pixels.image(&exact.values).to_estimate();
        let harmonics = context.method("sh_mip_envmap", &[])?;
        for backend in context.backends() {
            let mut images = Vec::new();
            for (view, (points, label)) in [&pixels, &vertices]
                .into_iter()
                .zip(points.iter().zip(["pixels", "vertices"]))
            {
                let run = context.run_timed(&loaded, backend, &*harmonics, quantity, points)?;
                let image = view.image(&run.estimate);
                let unit = ("ms", context.software(backend));
                finding.time((label, "shading"), backend, run.shade_ms(), unit);
                let count = Amount::exact(points.len() as f64);
                finding.measure((label, "points"), backend, count, "");
                images.push(image.to_estimate());
                if backend == context.backends()[0] {
                    row.add(format!("at {label}"), image);
                }
                finding.runs.push(run.run);
            }
            if let [by_pixel, by_vertex] = &images[..] {
                let rms = |of, from| Judge::at(from, None, shown.clone()).relative_rms(of);
                let (vertices, harmonics) = (rms(by_vertex, by_pixel), rms(by_pixel, &exact));
                for (name, rms) in [("vertices", vertices), ("nine harmonics", harmonics)] {
                    finding.measure((name, "rms of the picture / mean"), backend, rms, "");
                }
                finding.judge("C1", [unneeded(backend, vertices, harmonics)]);
            }
        }
        finding.pictures.push(row);
        Ok(finding)
    }
}

/// That interpolation between vertices errs less than nine harmonics do.
fn unneeded(backend: Backend, vertices: Amount, harmonics: Amount) -> Trial {
    let what = "rms of the picture by vertices below that by nine harmonics";
    Trial::less(what, backend, vertices, harmonics)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn vertices_have_to_err_less_than_the_harmonics() {
        let judged = |vertices, harmonics| {
            signs([&unneeded(Backend::Cpu, about(vertices), about(harmonics))])
        };
        assert_eq!(
            (judged(0.01, 0.02), judged(0.02, 0.01)),
            ("+".into(), "-".into())
        );
    }
}
