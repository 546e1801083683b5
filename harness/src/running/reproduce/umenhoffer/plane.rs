//! A plane that faces a wall, ever nearer.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Estimate, Point, PointLayout, Points, SurfaceMaterial};

/// Metres between plane and wall, in a room of half-width 1.
const DISTANCES_M: [f32; 4] = [0.4, 0.2, 0.1, 0.05];

/// Metres from which a wall is near: a quarter of the width of a texel of M = 4 on it.
const NEAR_M: f32 = 0.125;

/// Half the plane's edge in metres: more than a texel of M = 4.
const HALF_M: f32 = 0.6;

/// What is left of the points' spike, at most.
const LESS: f64 = 0.5;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let place = ExperimentScene::of("colored-room")
        .set("reference.offset", 0)
        .set("block", false)
        .set("receiver.size", 0.01);
    let loaded = context.load(&place, &mut finding)?;
    for distance_m in DISTANCES_M {
        at(context, &loaded, distance_m, &mut finding)?;
    }
    Ok(finding)
}

fn at(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    distance_m: f32,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let edge = context.pick(64, 128);
    let points = plane(edge, distance_m - 1.0);
    let mut references = context.references(loaded, Quantity::Irradiance, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let case = format!("{distance_m} m from the wall");
    let image =
        |e: &Estimate| HdrImage::from_estimate(edge, edge, e).unwrap_or(HdrImage::new(edge, edge));
    let mut row = Row::against(
        &*case,
        "path tracing",
        image(&truth.values),
        vec![true; edge * edge],
    );
    for backend in context.backends() {
        let mut spike = |label: &str, id: &str, parameters: &[(&str, &dyn ToString)]| {
            let method = context.method(id, parameters)?;
            let measured =
                context.run_once(loaded, backend, &*method, Quantity::Irradiance, &points)?;
            let spike = judge.spike(&measured.estimate);
            finding.measure(
                (&*case, format!("spike of {label} / mean")),
                backend,
                Amount::exact(spike),
                "",
            );
            let error = judge.error(&measured.estimate);
            finding.measure((&*case, format!("{ERROR}, {label}")), backend, error, "");
            if backend == context.backends()[0] {
                row.add(label, image(&measured.estimate));
            }
            finding.runs.push(measured.run);
            Ok::<_, RunError>(spike)
        };
        let bounces: (&str, &dyn ToString) = ("bounces", &4);
        let point = spike("points", "point_form_factor", &[bounces])?;
        let polygon = spike("polygons", "polygon_form_factor", &[bounces])?;
        let fidelity: (&str, &dyn ToString) = ("fidelity", &"corrected");
        let corrected = spike(
            "corrected polygons",
            "polygon_form_factor",
            &[bounces, fidelity],
        )?;
        if distance_m <= NEAR_M {
            let spikes = [point, polygon, corrected];
            let [spike, polygons @ ..] = judged(&case, backend, spikes);
            finding.judge("C1", [spike]);
            finding.judge("C2", polygons);
        }
    }
    finding.pictures.push(row);
    Ok(())
}

/// That points spike, and polygons, published and corrected, do so by less than half as much.
fn judged(case: &str, backend: Backend, [point, published, corrected]: [f64; 3]) -> [Trial; 3] {
    let spikes = format!("{case}: the mean below the points' spike");
    let less = |fidelity: &str, polygon: f64| {
        let what = format!("{case}: spike of {fidelity} polygons below {LESS} of the points'");
        Trial::less_by(what, backend, (polygon, LESS * point), 0.0)
    };
    [
        Trial::less_by(spikes, backend, (1.0, point), 0.0),
        less("published", published),
        less("corrected", corrected),
    ]
}

/// A square of `edge`² points at a place on the x-axis that faces −x.
fn plane(edge: usize, x: f32) -> Points {
    let point = |i: usize| {
        let along = |v: usize| HALF_M * (2.0 * (v as f32 + 0.5) / edge as f32 - 1.0);
        Some(Point {
            position: Vec3::new(x, -along(i / edge), along(i % edge)),
            normal: Vec3::NEG_X,
            view: Vec3::NEG_X,
            material: SurfaceMaterial {
                diffuse: Vec3::ONE,
                specular: Vec3::ZERO,
                shininess: 5.0,
            },
            footprint: 0.0,
        })
    };
    Points::new(PointLayout::Surface, (0..edge * edge).map(point))
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn points_spike_and_polygons_by_less_than_half() {
        let judged = |spikes| signs(&judged("", Backend::Cpu, spikes));
        assert_eq!(judged([1.1, 0.5, 0.6]), "++-");
        assert_eq!(judged([0.9, 0.5, 0.4]), "--+");
        // Within a quarter of the width of a texel of M = 4 on a wall 2 m wide.
        assert_eq!(DISTANCES_M.map(|d| d <= NEAR_M), [false, false, true, true]);
    }

    /// Faces −x at its place; rows go down, columns towards +z.
    #[test]
    fn the_plane_faces_the_wall() {
        let points = plane(2, -0.5);
        let at = |i: usize| points.get(i).map(|p| (p.position, p.normal));
        assert_eq!(at(0), Some((Vec3::new(-0.5, 0.3, -0.3), Vec3::NEG_X)));
        assert_eq!(at(3), Some((Vec3::new(-0.5, -0.3, 0.3), Vec3::NEG_X)));
    }
}
