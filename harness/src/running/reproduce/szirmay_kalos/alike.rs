//! What the vertices of a model receive as it is moved from place to place.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::scene_setup::SceneSetup;
use super::super::verdict::{Amount, Trial};
use super::room::{UNSHADOWED, classic};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Point, PointLayout, Points, Role, Scene};

/// Vertices that are compared.
const VERTICES: usize = 2000;

/// Largest share of the reference's change that passes for looking alike.
const ALIKE: f64 = 0.5;

/// A place, the reference there, and classic mapping's estimates.
type AtPlace = (&'static str, Estimate, Vec<(Backend, Estimate)>);

/// Judges how much irradiance by classic mapping changes from the first of the places to the others.
pub(super) fn judge(
    context: &ExperimentContext<'_>,
    (scene, places): (&SceneSetup, &[&'static str]),
    capture: u32,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let quantity = Quantity::Irradiance;
    let method = classic(context, capture)?;
    let mut there: Vec<AtPlace> = Vec::new();
    for &place in places {
        let moved = context.place(scene).set("receiver.place", place);
        let loaded = context.load(&moved, finding)?;
        let points = vertices(loaded.scene());
        let mut references = context.references(&loaded, quantity, &points);
        let reference = references.model(UNSHADOWED).values.clone();
        let mut estimates = Vec::new();
        for backend in context.backends() {
            let run = context.run_once(&loaded, backend, &*method, quantity, &points)?;
            estimates.push((backend, run.estimate));
        }
        there.push((place, reference, estimates));
    }
    let Some(((from, first, at_first), others)) = there.split_first() else {
        return Ok(());
    };
    for (place, reference, estimates) in others {
        let truth = change(first, reference);
        for ((backend, before), (_, after)) in at_first.iter().zip(estimates) {
            let classic = change(before, after);
            for (name, value) in [("reference", truth), ("classic", classic)] {
                let name = format!("change from {from}, {name}");
                finding.measure((*place, name), *backend, Amount::exact(value), "");
            }
            finding.judge("C1", [alike(place, *backend, classic, truth)]);
        }
    }
    Ok(())
}

/// Root mean square change over the first one's mean.
fn change(before: &Estimate, after: &Estimate) -> f64 {
    let judge = Judge::at(before, None, (0..before.len()).collect());
    judge.relative_rms(after).value
}

/// That classic mapping changes by less than half as much as the reference.
fn alike(place: &str, backend: Backend, classic: f64, reference: f64) -> Trial {
    let what = format!("{place}: change by classic below {ALIKE} of the reference's, rms / mean");
    Trial::less_by(what, backend, (classic, ALIKE * reference), 0.0)
}

/// Some of the receivers' vertices, the same wherever they stand.
fn vertices(scene: &Scene) -> Points {
    let meshes = || scene.objects_of(Role::Receiver).map(|o| &o.mesh);
    let all: usize = meshes().map(|mesh| mesh.positions.len()).sum();
    let pairs = meshes().flat_map(|mesh| mesh.positions.iter().zip(&mesh.normals));
    let point = |(position, normal): (&glam::Vec3, &glam::Vec3)| {
        Some(Point {
            position: *position,
            normal: *normal,
            ..Point::default()
        })
    };
    let points = pairs.step_by(all.div_ceil(VERTICES).max(1)).map(point);
    Points::new(PointLayout::Surface, points.collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{flat, signs};
    use super::*;

    #[test]
    fn classic_mapping_looks_alike_where_it_changes_by_less_than_half() {
        let judged = |classic| signs([&alike("", Backend::Cpu, classic, 0.4)]);
        assert_eq!((judged(0.19), judged(0.21)), ("+".into(), "-".into()));
        assert!((change(&flat(2.0), &flat(3.0)) - 0.5).abs() < 1e-6);
    }
}
