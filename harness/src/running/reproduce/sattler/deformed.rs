//! A deforming model: each frame's own occlusion, and that of the model at rest.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::sequence::{DEFORMING, Moment};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::stages::Sequence;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let place = ExperimentScene::of("studio")
        .with(&context.mesh("dragon"))
        .set("receiver.deformation", "twist");
    let rest = context.scene(&place, &mut finding)?;
    let method = context.method(
        "directional_ao",
        &[
            ("level", &context.pick(2, 3)),
            ("map_resolution", &context.pick(128, 512)),
        ],
    )?;
    let mut running: Vec<(Backend, Sequence, Option<Estimate>)> = context
        .backends()
        .into_iter()
        .map(|b| (b, Sequence::default(), None))
        .collect();
    for index in 0..context.pick(3_u8, 9) {
        // The shape is at rest at 0 s, and farthest from it at a quarter of its period of 2 s.
        let time_s = 0.5 * f32::from(index) / f32::from(context.pick(2_u8, 8));
        let moment = Moment::of(context, &rest, time_s)?;
        let mut references =
            context.references(&moment.room, Quantity::AmbientOcclusion, &moment.points);
        let truth = references.truth();
        let judge = Judge::at(&truth.values, Some(&truth.error), moment.seen());
        let (view, title) = (&moment.view, format!("at {time_s} s"));
        let mut row = Row::against(
            &*title,
            "traced rays",
            view.image(&truth.values),
            view.surfaces(),
        );
        for (backend, running, at_rest) in &mut running {
            let shaded = moment.shade(context, (running, *backend), &*method, DEFORMING)?;
            let fixed = at_rest.get_or_insert_with(|| shaded.estimate.clone());
            finding.measure(
                (&*title, ERROR),
                *backend,
                judge.error(&shaded.estimate),
                "",
            );
            finding.measure(
                (&*title, "MSE / mean² of the shape at rest"),
                *backend,
                judge.error(fixed),
                "",
            );
            if index > 0 {
                let what = format!("{title}: nearer than the occlusion at rest");
                finding
                    .trials
                    .push(judge.nearer(what, *backend, &shaded.estimate, fixed));
            }
            if *backend == context.backends()[0] {
                row.add("this frame's", view.image(&shaded.estimate));
                row.add("at rest", view.image(fixed));
            }
        }
        finding.pictures.push(row);
    }
    Ok(finding)
}
