//! What keeps a surface from occluding itself, and what filtering leaves as it is.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::place::Place;
use super::super::verdict::{Amount, Trial};
use super::sequence::{Moment, RESTING};
use crate::error::HarnessError;
use crate::record::Backend;
use crate::stages::Sequence;
use interreflect_estimators::Quantity;
use interreflect_scene::motion::Moves;

/// Largest change of a pixel over the mean that leaves a picture as it is.
const SAME: f64 = 1e-3;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    biases(desk, &mut finding)?;
    for backend in desk.backends() {
        filtered(desk, backend, &mut finding)?;
    }
    Ok(finding)
}

fn biases(desk: &Desk<'_>, finding: &mut Finding) -> Result<(), HarnessError> {
    let quantity = Quantity::AmbientOcclusion;
    let room = desk.room(&Place::of("studio").with(&desk.mesh("bunny")), finding)?;
    let view = desk.view(&room)?;
    let points = view.points(quantity.layout());
    let mut references = desk.references(&room, quantity, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let mut row = Row::against(
        "openness",
        "traced rays",
        view.image(&truth.values),
        view.surfaces(),
    );
    for backend in desk.backends() {
        let mut estimates = Vec::new();
        for (bias, label) in [
            ("polygon_offset", "slope-scaled"),
            ("constant", "constant"),
            ("none", "none"),
        ] {
            let method = desk.method(
                "directional_ao",
                &[("bias", &bias), ("map_resolution", &desk.pick(256, 512))],
            )?;
            let shot = desk.shot(&room, backend, &*method, quantity, &points)?;
            finding.measure(
                (format!("bias {label}"), ERROR),
                backend,
                judge.error(&shot.estimate),
                "",
            );
            if backend == desk.backends()[0] {
                row.add(label, view.image(&shot.estimate));
            }
            estimates.push((label, shot.estimate));
            finding.runs.push(shot.run);
        }
        for (rival, estimate) in &estimates[1..] {
            let what = format!("slope-scaled bias nearer than {rival}");
            finding
                .trials
                .push(judge.nearer(what, backend, &estimates[0].1, estimate));
        }
    }
    finding.pictures.push(row);
    Ok(())
}

fn filtered(desk: &Desk<'_>, backend: Backend, finding: &mut Finding) -> Result<(), HarnessError> {
    let place = Place::of("studio")
        .with(&desk.mesh("bunny"))
        .set("camera.orbit_deg_per_s", 60);
    let rest = desk.scene(&place, finding)?;
    let moves = Moves {
        camera: true,
        ..RESTING
    };
    let method = |filter: bool| {
        desk.method(
            "directional_ao",
            &[("filter", &filter), ("map_resolution", &192)],
        )
    };
    let (plain, with_lists) = (method(false)?, method(true)?);
    let (mut all, mut filtered) = (Sequence::default(), Sequence::default());
    let mut worst = 0.0_f64;
    let mut row = Row::plain(format!(
        "a turning camera's frames with the lists, {backend}"
    ));
    for index in 0..4_u8 {
        let moment = Moment::of(desk, &rest, 0.5 * f32::from(index))?;
        let a = moment.shade(desk, (&mut all, backend), &*plain, moves)?;
        let b = moment.shade(desk, (&mut filtered, backend), &*with_lists, moves)?;
        let (a, b) = (
            moment.view.image(&a.estimate),
            moment.view.image(&b.estimate),
        );
        let pairs = a.pixels.iter().zip(&b.pixels);
        let change = pairs
            .map(|(a, b)| (*a - *b).abs().max_element())
            .fold(0.0, f32::max);
        let mean = a.pixels.iter().map(|p| p.x).sum::<f32>() / a.pixels.len() as f32;
        worst = worst.max(f64::from(change / mean));
        row.add(format!("frame {index}"), b);
    }
    finding.measure(
        ("the lists", "largest change / mean"),
        backend,
        Amount::exact(worst),
        "",
    );
    let what = "largest change of a pixel by filtering, over the mean";
    finding
        .trials
        .push(Trial::less_by(what, backend, (worst, SAME), 0.0));
    finding.pictures.push(row);
    Ok(())
}
