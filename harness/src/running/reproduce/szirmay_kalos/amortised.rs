//! A kept cube map while the object moves away from where it was made, and one map for two objects.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::View;
use glam::Vec3;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::{Estimate, Points, Role};

/// Metres that the object has moved since the map was made.
const MOVED_M: [f32; 4] = [0.0, 0.125, 0.25, 0.5];

/// Metres up to which a reused map has to do.
const NEAR_M: f32 = 0.25;

/// Largest factor on the error that counts as serving as well.
const WORSE: f64 = 2.0;

/// What an estimate costs, and how good it is.
type Cost = (Amount, Amount);

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for moved in MOVED_M {
        moved_by(context, moved, &mut finding)?;
    }
    for backend in context.backends() {
        shared(context, backend, &mut finding)?;
    }
    Ok(finding)
}

fn place(context: &ExperimentContext<'_>, moved: f32, receivers: u32) -> ExperimentScene {
    ExperimentScene::of("colored-room")
        .set("reference.offset", 0)
        .with(&context.mesh("bunny"))
        .set("receiver.size", 0.5)
        .set("receiver.moved", moved)
        .set("receivers", receivers)
}

/// A map of M = 8 that is kept while the object is no farther than `within_m` from where it was made;
/// always fresh for 0.
fn map(context: &ExperimentContext<'_>, within_m: f32) -> Result<Box<dyn Configured>, RunError> {
    let parameters: [(&str, &dyn ToString); 3] = [
        ("resolution", &8),
        ("bounces", &4),
        ("recapture_distance", &within_m),
    ];
    context.method("localized_cubemap", &parameters)
}

fn moved_by(
    context: &ExperimentContext<'_>,
    moved: f32,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let loaded = context.load(&place(context, moved, 1), finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let mut references = context.references(&loaded, Quantity::Irradiance, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let case = format!("moved {moved} m");
    let mut row = Row::rendered(&*case, "truth", &view, &truth.values);
    for backend in context.backends() {
        let mut runs = Vec::new();
        for (label, within_m) in [("fresh", 0.0), ("reused", 1.0)] {
            let method = map(context, within_m)?;
            let measured =
                context.run_timed(&loaded, backend, &*method, Quantity::Irradiance, &points)?;
            if backend == context.backends()[0] {
                row.add(label, view.image(&measured.estimate));
            }
            runs.push((measured.frame_ms(), judge.error(&measured.estimate)));
            finding.runs.push(measured.run);
        }
        if let [fresh, kept] = runs[..] {
            let software = context.software(backend);
            weigh(
                (&case, backend, software),
                ("reused", kept),
                ("fresh", fresh),
                moved <= NEAR_M,
                finding,
            );
        }
    }
    finding.pictures.push(row);
    Ok(())
}

/// One map between two objects, against a map in the middle of each.
fn shared(
    context: &ExperimentContext<'_>,
    backend: Backend,
    finding: &mut Finding,
) -> Result<(), RunError> {
    let scene = context.scene(&place(context, 0.0, 2), finding)?;
    let middle = |mesh: &interreflect_scene::Mesh| {
        let (low, high) = mesh.bounds().unwrap_or_default();
        0.5 * (low + high)
    };
    let middles: Vec<Vec3> = scene
        .objects_of(Role::Receiver)
        .map(|o| middle(&o.mesh))
        .collect();
    let loaded = context.set_up(&scene)?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let mut references = context.references(&loaded, Quantity::Irradiance, &points);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let method = map(context, 0.0)?;
    let mut shoot = |loaded: &LoadedScene| {
        let measured =
            context.run_timed(loaded, backend, &*method, Quantity::Irradiance, &points)?;
        finding.runs.push(measured.run.clone());
        Ok::<_, RunError>(measured)
    };
    let one = shoot(&loaded)?;
    let mut own = Vec::new();
    for &at in &middles {
        let mut there = scene.clone();
        (there.reference_point, there.captured_at) = (at, None);
        own.push(shoot(&context.set_up(&there)?)?);
    }
    let estimates: Vec<&Estimate> = own.iter().map(|measured| &measured.estimate).collect();
    let each = of_the_nearest(&points, &middles, &estimates);
    let capture = |measured: &super::super::measured_run::MeasuredRun| measured.frame_ms();
    let each_cost = (together(own.iter().map(capture)), judge.error(&each));
    let one_cost = (one.frame_ms(), judge.error(&one.estimate));
    let at = ("2 objects", backend, context.software(backend));
    weigh(
        at,
        ("one map", one_cost),
        ("a map each", each_cost),
        true,
        finding,
    );
    if backend == context.backends()[0] {
        finding
            .pictures
            .push(pictures(&view, &truth.values, [&one.estimate, &each]));
    }
    Ok(())
}

fn pictures(view: &View, truth: &Estimate, [one, each]: [&Estimate; 2]) -> Row {
    let mut row = Row::rendered("2 objects", "truth", view, truth);
    row.add("one map", view.image(one));
    row.add("a map each", view.image(each));
    row
}

/// The sum of independent times; no number without any.
fn together(times: impl Iterator<Item = Amount>) -> Amount {
    let sum = times.reduce(|a, b| Amount {
        value: a.value + b.value,
        spread: a.spread.hypot(b.spread),
    });
    sum.unwrap_or(Amount::exact(f64::NAN))
}

/// At each point the estimate whose place is the nearest.
fn of_the_nearest(points: &Points, places: &[Vec3], estimates: &[&Estimate]) -> Estimate {
    let mut merged = Estimate::new(points.len());
    for (i, point) in points.iter().enumerate() {
        let Some(point) = point else { continue };
        let distance = |p: &Vec3| point.position.distance_squared(*p);
        let ranked = places.iter().zip(estimates);
        let nearest = ranked.min_by(|a, b| distance(a.0).total_cmp(&distance(b.0)));
        if let Some((_, estimate)) = nearest {
            merged.set(i, estimate.get(i));
        }
    }
    merged
}

/// That the first way takes less time and, if `near`, is not much worse.
fn weigh(
    (case, backend, software): (&str, Backend, bool),
    (cheap, (cheap_ms, cheap_error)): (&str, Cost),
    (dear, (dear_ms, dear_error)): (&str, Cost),
    near: bool,
    finding: &mut Finding,
) {
    for (label, ms, error) in [(cheap, cheap_ms, cheap_error), (dear, dear_ms, dear_error)] {
        finding.time(
            (case, format!("frame, {label}")),
            backend,
            ms,
            ("ms", software),
        );
        finding.measure((case, format!("{ERROR}, {label}")), backend, error, "");
    }
    let time = format!("{case}: frame of {cheap} below that of {dear}, ms");
    finding.judge("C1", [Trial::less(time, backend, cheap_ms, dear_ms)]);
    if near {
        let error = format!("{case}: error of {cheap} below {WORSE} times that of {dear}");
        let limit = dear_error.times(WORSE);
        finding.judge("C2", [Trial::less(error, backend, cheap_error, limit)]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, flat, signs};
    use super::*;
    use interreflect_scene::{Point, PointLayout};

    #[test]
    fn a_kept_map_has_to_be_faster_and_near_by_not_twice_as_wrong() {
        let weighed = |cheap: Cost, dear: Cost, near: bool| {
            let mut finding = Finding::default();
            let at = ("case", Backend::Cpu, false);
            weigh(at, ("reused", cheap), ("fresh", dear), near, &mut finding);
            assert_eq!(finding.measured.len(), 4);
            assert_eq!(finding.measured[0].value, cheap.0.value);
            assert_eq!(finding.measured[3].value, dear.1.value);
            signs(finding.trials_of("C1")) + &signs(finding.trials_of("C2"))
        };
        let cost = |ms: f64, error: f64| (about(ms), Amount::exact(error));
        assert_eq!(weighed(cost(1.0, 1.9), cost(2.0, 1.0), true), "++");
        assert_eq!(weighed(cost(2.0, 2.1), cost(1.0, 1.0), true), "--");
        assert_eq!(weighed(cost(2.0, 0.1), cost(2.1, 1.0), true), "?+");
        assert_eq!(weighed(cost(1.0, 9.0), cost(2.0, 1.0), false), "+");
        // A quarter of the half-width of the room, which is 1 m.
        assert_eq!(MOVED_M.map(|m| m <= NEAR_M), [true, true, true, false]);
    }

    #[test]
    fn two_maps_take_the_time_of_both_and_each_point_has_the_nearest() {
        let sum = together([about(3.0), about(4.0)].into_iter());
        assert!((sum.value - 7.0).abs() < 1e-12 && (sum.spread - 0.5).abs() < 1e-12);
        assert!(together(std::iter::empty()).value.is_nan());
        let at = |x: f32| {
            Some(Point {
                position: Vec3::X * x,
                normal: Vec3::Y,
                ..Point::default()
            })
        };
        let points = Points::new(PointLayout::Surface, [at(-0.9), at(0.2), None, at(-0.2)]);
        let (left, right) = (flat(1.0), flat(2.0));
        let merged = of_the_nearest(&points, &[-Vec3::X, Vec3::X], &[&left, &right]);
        let found: Vec<f32> = merged.iter().map(|v| v.x).collect();
        assert_eq!(found, [1.0, 2.0, 0.0, 1.0]);
    }
}
