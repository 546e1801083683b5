//! The faces of the cube at a bias so high that the coarsest level is shown.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::Amount;
use super::super::{Claim, Experiment, Item, Paper};
use super::border::{judged, mean_step, pairs};
use super::studio;
use super::{MIRRORING, RESOLUTION};
use crate::running::error::RunError;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::PointLayout;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.4",
    paper: Paper::Kautz,
    item: Item::Figure(4),
    title: "faces of the cube at a high bias",
    setup: &Faces {
        scene: studio(&["sphere"], MIRRORING),
        bias: 9.4,
        resolution: RESOLUTION,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "At a high bias the six faces show.",
            rule: "A trial is a backend: across the cube's edges the published map steps more than three \
                times as far as inside its faces, over the same angle.",
        },
        Claim {
            id: "C2",
            says: "Filtering across faces avoids it.",
            rule: "A trial is a backend: the map that is filtered across edges steps less than half as far \
                there as the published one.",
        },
    ],
};

/// A mirroring object under an environment, and the bias on the level.
#[derive(Serialize)]
pub(super) struct Faces {
    pub(super) scene: SceneSetup,
    /// b, on the hardware's level.
    pub(super) bias: f64,
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
}

impl Runs for Faces {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = context.view(&loaded)?;
        let shown = view.points(PointLayout::Material);
        let (across, inside) = (pairs(1.0), pairs(0.4));
        let case = format!("b = {}", self.bias);
        let mut row = Row::plain(format!("a mirroring ball, {case}"));
        for backend in context.backends() {
            let mut steps = Vec::new();
            for (fidelity, caption) in [
                ("published", "face by face"),
                ("corrected", "across the border"),
            ] {
                let method = self.method(context, fidelity)?;
                let quantity = Quantity::GlossyRadiance;
                let run = |points| context.run_once(&loaded, backend, &*method, quantity, points);
                let picture = run(&shown)?;
                row.add(
                    format!("{caption}, {backend}"),
                    view.image(&picture.estimate),
                );
                for (where_, points) in [("across edges", &across), ("inside faces", &inside)] {
                    let step = mean_step(&run(points)?.estimate);
                    let name = format!("step {where_}, {caption}");
                    finding.measure((&*case, name), backend, Amount::exact(step), "");
                    steps.push(step);
                }
                finding.runs.push(picture.run);
            }
            if let [seam, face, mended, _] = steps[..] {
                let [seen, gone] = judged(&case, backend, [seam, face, mended]);
                finding.judge("C1", [seen]);
                finding.judge("C2", [gone]);
            }
        }
        finding.pictures.push(row);
        Ok(finding)
    }
}

impl Faces {
    fn method(
        &self,
        context: &ExperimentContext<'_>,
        fidelity: &str,
    ) -> Result<Box<dyn Configured>, RunError> {
        context.method(
            "sh_mip_envmap",
            &[
                ("fidelity", &fidelity),
                ("resolution", &self.resolution),
                ("lod_mode", &"bias"),
                ("lod", &self.bias),
                ("f_lambda", &1),
            ],
        )
    }
}
