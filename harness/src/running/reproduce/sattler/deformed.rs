//! A deforming model: each frame's own occlusion, and that of the model at rest.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::Trial;
use super::sequence::{DEFORMING, Moment};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
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
            context.references(&moment.loaded, Quantity::AmbientOcclusion, &moment.points);
        let truth = references.truth();
        let judge = Judge::at(&truth.values, Some(&truth.error), moment.seen());
        let (view, title) = (&moment.view, format!("at {time_s} s"));
        let mut row = Row::rendered(&*title, "traced rays", view, &truth.values);
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
                let trial = follows(&judge, (&*title, *backend), &shaded.estimate, fixed);
                finding.judge("C1", [trial]);
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

/// That a frame's own occlusion is nearer to the reference than that at rest.
fn follows(
    judge: &Judge<'_>,
    (title, backend): (&str, Backend),
    own: &Estimate,
    at_rest: &Estimate,
) -> Trial {
    let what = format!("{title}: nearer than the occlusion at rest");
    judge.nearer(what, backend, own, at_rest)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;

    #[test]
    fn a_frame_s_own_occlusion_has_to_be_the_nearer_one() {
        let reference = flat(0.5);
        let judge = exact(&reference);
        let judged = |own, rest| {
            signs([&follows(
                &judge,
                ("", Backend::Cpu),
                &flat(own),
                &flat(rest),
            )])
        };
        assert_eq!(
            (judged(0.6, 0.8), judged(0.8, 0.6)),
            ("+".into(), "-".into())
        );
    }
}
