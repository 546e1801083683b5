//! Steps of a filtered cube map across the edges of the cube and inside its faces.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::setup::InCode;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::environments::environments;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Point, PointLayout, Points, SurfaceMaterial};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.seams",
    paper: Paper::Kautz,
    item: Item::NotInThePaper,
    title: "seams of filtering each face by itself, level by level",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Levels that are filtered face by face show the edges of the cube.",
            rule: "A trial is an environment, level and backend: across the cube's edges the published \
                map steps more than three times as far as inside its faces, over the same angle.",
        },
        Claim {
            id: "C2",
            says: "Filtering across a border removes them.",
            rule: "A trial is an environment, level and backend: the map that is filtered across edges \
                steps less than half as far as the published one there.",
        },
    ],
};

/// Half a step, along a face of the cube of edge 2.
const HALF_STEP: f32 = 0.002;

/// Places along an edge.
const PLACES: i32 = 40;

/// How much farther a seam steps than a face does inside.
const SEEN: f64 = 3.0;

/// What is left of a seam that is gone, at most.
const GONE: f64 = 0.5;

/// Change of the mirrored direction in radians between neighbouring pixels of a ball that fills a picture of some
/// 200 pixels.
const FOOTPRINT: f32 = 0.02;

/// Levels of the pyramid of 64² texels a face.
const LEVELS: [u32; 2] = [4, 5];

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for (name, place) in environments(context, &mut finding) {
        steps(context, (name, &place), &mut finding)?;
        pictures(context, (name, place), &mut finding)?;
    }
    Ok(finding)
}

fn steps(
    context: &ExperimentContext<'_>,
    (name, place): (&str, &ExperimentScene),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let loaded = context.load(place, finding)?;
    let quantity = Quantity::GlossyRadiance;
    let (across, inside) = (pairs(1.0), pairs(0.4));
    for level in LEVELS {
        for backend in context.backends() {
            let case = format!("{name}, level {level}");
            let mut step = |fidelity: &str, points: &Points| {
                let method = context.method(
                    "sh_mip_envmap",
                    &[("fidelity", &fidelity), ("lod", &level), ("f_lambda", &1)],
                )?;
                let measured = context.run_once(&loaded, backend, &*method, quantity, points)?;
                finding.runs.push(measured.run);
                Ok::<_, RunError>(mean_step(&measured.estimate))
            };
            let seam = step("published", &across)?;
            let face = step("published", &inside)?;
            let mended = step("corrected", &across)?;
            for (label, value) in [
                ("step across edges, face by face", seam),
                ("step inside faces", face),
                ("step across edges, across the border", mended),
            ] {
                finding.measure((&*case, label), backend, Amount::exact(value), "");
            }
            let [seen, gone] = judged(&case, backend, [seam, face, mended]);
            finding.judge("C1", [seen]);
            finding.judge("C2", [gone]);
        }
    }
    Ok(())
}

/// That the step across edges is a seam beside that inside faces, and that filtering across them mends it.
pub(super) fn judged(case: &str, backend: Backend, [seam, face, mended]: [f64; 3]) -> [Trial; 2] {
    let seen = format!("{case}: {SEEN} steps inside faces below a step across edges");
    let gone = format!("{case}: step across edges below {GONE} of that face by face");
    [
        Trial::less_by(seen, backend, (SEEN * face, seam), 0.0),
        Trial::less_by(gone, backend, (mended, GONE * seam), 0.0),
    ]
}

/// Pairs of points that mirror in directions a step apart, from either side of a plane: with the first
/// axis at ±1, a pair lies at ±`along` on the second, which is the edge of the cube at 1.
pub(super) fn pairs(along: f32) -> Points {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let mut points = Vec::new();
    for i in 0..3 {
        let (a, b, c) = (axes[i], axes[(i + 1) % 3], axes[(i + 2) % 3]);
        for (sa, sb) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            for place in 0..PLACES {
                let t = 0.9 * (2.0 * (place as f32 + 0.5) / PLACES as f32 - 1.0);
                for side in [HALF_STEP, -HALF_STEP] {
                    let direction = a * sa + b * sb * (along + side) + c * t;
                    points.push(Some(mirroring(direction.normalize())));
                }
            }
        }
    }
    Points::new(PointLayout::Material, points)
}

/// A point that reflects what comes from a direction back there.
pub(super) fn mirroring(direction: Vec3) -> Point {
    Point {
        position: Vec3::ZERO,
        normal: direction,
        view: direction,
        material: SurfaceMaterial {
            diffuse: Vec3::ZERO,
            specular: Vec3::ONE,
            shininess: 225.0,
        },
        footprint: FOOTPRINT,
    }
}

/// Mean difference within pairs over the mean of all values.
pub(super) fn mean_step(estimate: &Estimate) -> f64 {
    let values: Vec<Vec3> = estimate.iter().collect();
    let (mut step, mut sum) = (0.0, 0.0);
    for pair in values.chunks_exact(2) {
        step += f64::from((pair[0] - pair[1]).abs().element_sum());
        sum += f64::from((pair[0] + pair[1]).element_sum()) / 2.0;
    }
    step / sum
}

fn pictures(
    context: &ExperimentContext<'_>,
    (name, place): (&str, ExperimentScene),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let mut ball = place;
    ball.changes.receivers = vec!["sphere".into()];
    let ball = ball.set("receiver.diffuse", 0).set("receiver.specular", 1);
    let loaded = context.load(&ball, finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(PointLayout::Material);
    let mut row = Row::plain(format!("{name}: a mirroring ball, level 5"));
    for (fidelity, caption) in [
        ("published", "face by face"),
        ("corrected", "across the border"),
    ] {
        for &backend in &context.backends() {
            let method = context.method(
                "sh_mip_envmap",
                &[("fidelity", &fidelity), ("lod", &5), ("f_lambda", &1)],
            )?;
            let measured = context.run_once(
                &loaded,
                backend,
                &*method,
                Quantity::GlossyRadiance,
                &points,
            )?;
            row.add(
                format!("{caption}, {backend}"),
                view.image(&measured.estimate),
            );
        }
    }
    finding.pictures.push(row);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn seams_are_thrice_a_step_inside_and_mended_to_less_than_half() {
        let judged = |steps| signs(&judged("case", Backend::Cpu, steps));
        assert_eq!(judged([3.1, 1.0, 1.5]), "++");
        assert_eq!(judged([2.9, 1.0, 1.5]), "--");
        assert_eq!(judged([0.31, 0.1, 0.16]), "+-");
    }

    #[test]
    fn steps_are_relative_and_pairs_lie_on_both_sides_of_an_edge() {
        let mut estimate = Estimate::new(4);
        for (i, v) in [1.0, 3.0, 2.0, 2.0].into_iter().enumerate() {
            estimate.set(i, Vec3::splat(v));
        }
        assert!((mean_step(&estimate) - 0.5).abs() < 1e-6);
        let points = pairs(1.0);
        let face = |i: usize| points.get(i).map(|p| p.normal.abs().max_position());
        assert!((0..points.len()).step_by(2).all(|i| face(i) != face(i + 1)));
        let points = pairs(0.4);
        let face = |i: usize| points.get(i).map(|p| p.normal.abs().max_position());
        assert!((0..points.len()).step_by(2).all(|i| face(i) == face(i + 1)));
    }
}
