//! What keeps a surface from occluding itself, and what filtering leaves as it is.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::sequence::{Moment, RESTING};
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;
use interreflect_scene::motion::Moves;

/// Largest change of a pixel over the mean that leaves a picture as it is.
const SAME: f64 = 1e-3;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    biases(context, &mut finding)?;
    for backend in context.backends() {
        filtered(context, backend, &mut finding)?;
    }
    Ok(finding)
}

fn biases(context: &ExperimentContext<'_>, finding: &mut Finding) -> Result<(), RunError> {
    let quantity = Quantity::AmbientOcclusion;
    let loaded = context.load(
        &ExperimentScene::of("studio").with(&context.mesh("bunny")),
        finding,
    )?;
    let view = context.view(&loaded)?;
    let points = view.points(quantity.layout());
    let mut references = context.references(&loaded, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::rendered("openness", "traced rays", &view, &truth.values);
    for backend in context.backends() {
        let mut estimates = Vec::new();
        for (bias, label) in [
            ("polygon_offset", "slope-scaled"),
            ("constant", "constant"),
            ("none", "none"),
        ] {
            let method = context.method(
                "directional_ao",
                &[("bias", &bias), ("map_resolution", &context.pick(256, 512))],
            )?;
            let measured = context.run_once(&loaded, backend, &*method, quantity, &points)?;
            finding.measure(
                (format!("bias {label}"), ERROR),
                backend,
                judge.error(&measured.estimate),
                "",
            );
            if backend == context.backends()[0] {
                row.add(label, view.image(&measured.estimate));
            }
            estimates.push((label, measured.estimate));
            finding.runs.push(measured.run);
        }
        finding.judge("C1", nearest(&judge, backend, &estimates));
    }
    finding.pictures.push(row);
    Ok(())
}

fn filtered(
    context: &ExperimentContext<'_>,
    backend: Backend,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let place = ExperimentScene::of("studio")
        .with(&context.mesh("bunny"))
        .set("camera.orbit_deg_per_s", 60);
    let rest = context.scene(&place, finding)?;
    let moves = Moves {
        camera: true,
        ..RESTING
    };
    let method = |filter: &'static str| {
        context.method(
            "directional_ao",
            &[("filter", &filter), ("map_resolution", &192)],
        )
    };
    let (plain, with_lists) = (method("none")?, method("triangles")?);
    let (mut all, mut filtered) = (Sequence::default(), Sequence::default());
    let mut worst = 0.0_f64;
    let mut row = Row::plain(format!(
        "a turning camera's frames with the lists, {backend}"
    ));
    for index in 0..4_u8 {
        let moment = Moment::of(context, &rest, 0.5 * f32::from(index))?;
        let a = moment.shade(context, (&mut all, backend), &*plain, moves)?;
        let b = moment.shade(context, (&mut filtered, backend), &*with_lists, moves)?;
        let (a, b) = (
            moment.view.image(&a.estimate),
            moment.view.image(&b.estimate),
        );
        worst = worst.max(largest_change(&a, &b));
        row.add(format!("frame {index}"), b);
    }
    finding.measure(
        ("the lists", "largest change / mean"),
        backend,
        Amount::exact(worst),
        "",
    );
    finding.judge("C2", [unchanged(backend, worst)]);
    finding.pictures.push(row);
    Ok(())
}

/// That the first of the estimates is nearer to the reference than each of the others.
fn nearest(judge: &Judge<'_>, backend: Backend, estimates: &[(&str, Estimate)]) -> Vec<Trial> {
    let Some(((_, first), rivals)) = estimates.split_first() else {
        return Vec::new();
    };
    let nearer = |(rival, estimate): &(&str, Estimate)| {
        let what = format!("slope-scaled bias nearer than {rival}");
        judge.nearer(what, backend, first, estimate)
    };
    rivals.iter().map(nearer).collect()
}

/// The largest change of a pixel over the mean of the first image's red.
fn largest_change(before: &HdrImage, after: &HdrImage) -> f64 {
    let pairs = before.pixels.iter().zip(&after.pixels);
    let change = pairs
        .map(|(a, b)| (*a - *b).abs().max_element())
        .fold(0.0, f32::max);
    let mean = before.pixels.iter().map(|p| p.x).sum::<f32>() / before.pixels.len() as f32;
    f64::from(change / mean)
}

/// That filtering leaves every pixel as it is.
fn unchanged(backend: Backend, worst: f64) -> Trial {
    let what = "largest change of a pixel by filtering, over the mean";
    Trial::less_by(what, backend, (worst, SAME), 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, flat, signs};
    use super::*;
    use glam::Vec3;

    #[test]
    fn the_slope_scaled_bias_has_to_be_the_nearest() {
        let reference = flat(1.0);
        let judge = exact(&reference);
        let estimates = |values: [f32; 3]| {
            let names = ["slope-scaled", "constant", "none"];
            let all = names.into_iter().zip(values.map(flat));
            signs(&nearest(&judge, Backend::Cpu, &all.collect::<Vec<_>>()))
        };
        assert_eq!(estimates([0.9, 0.8, 0.3]), "++");
        assert_eq!(estimates([0.5, 0.8, 0.3]), "-+");
        assert_eq!(estimates([0.3, 0.8, 0.9]), "--");
    }

    #[test]
    fn a_picture_stays_as_it_is_within_a_thousandth() {
        let signs = |worst| signs([&unchanged(Backend::Cpu, worst)]);
        assert_eq!((signs(0.9e-3), signs(1.1e-3)), ("+".into(), "-".into()));
        let image = |values: [f32; 4]| HdrImage {
            width: 4,
            height: 1,
            pixels: values.map(Vec3::splat).to_vec(),
        };
        let (before, after) = (image([0.0, 1.0, 1.0, 2.0]), image([0.0, 1.5, 1.0, 1.75]));
        assert!((largest_change(&before, &after) - 0.5).abs() < 1e-6);
    }
}
