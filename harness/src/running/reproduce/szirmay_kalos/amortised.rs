//! A kept cube map while the object moves away from where it was made, and one map for two objects.
//!
//! Longer than most: three claims of one setup, with their rules.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::CAPTURE;
use super::room;
use super::room::localized;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::View;
use glam::Vec3;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::{Estimate, Points, Role};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "szirmay-kalos.amortised",
    paper: Paper::SzirmayKalos,
    item: Item::Section("2"),
    title: "one cube map for several frames and objects",
    setup: &Amortised {
        scene: room(
            &["bunny"],
            &[
                ("ceiling", "green"),
                ("divider", "0.9"),
                ("block", "false"),
                ("reference.offset", "0"),
                ("receiver.size", "0.5"),
                ("receiver.diffuse", "0.8"),
                ("receiver.specular", "0"),
            ],
        ),
        resolution: 4,
        capture_resolution: CAPTURE,
        moved_m: [0.0, 0.125, 0.25, 0.5],
        near_m: 0.25,
        objects: 2,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "One map serves several close objects.",
            rule: "A trial is time or error on a backend: one map between two objects takes less time than \
                a map in the middle of each that shades its own object's points alone, beyond the \
                spread of both; and its mean squared error against the truth is less than twice that \
                of a map each.",
        },
        Claim {
            id: "C2",
            says: "A kept map saves the cost of making it.",
            rule: "A trial is a distance moved and a backend: a frame with the kept map takes less time \
                than one with a fresh map, beyond the spread of both.",
        },
        Claim {
            id: "C3",
            says: "It has to be made again only when the object has moved far.",
            rule: "A trial is a distance up to a quarter of the half-width of the room, and a backend: the \
                kept map's mean squared error is less than twice the fresh one's, beyond the \
                reference's noise.",
        },
    ],
};

/// An object that moves away from where its map was made, and several objects that share a map.
#[derive(Serialize)]
pub(super) struct Amortised {
    pub(super) scene: SceneSetup,
    /// M, texels along a face's edge.
    pub(super) resolution: u32,
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
    /// Metres that the object has moved since the map was made.
    pub(super) moved_m: [f64; 4],
    /// Metres up to which a reused map has to do.
    pub(super) near_m: f64,
    /// Objects that share a map.
    pub(super) objects: u32,
}

/// Largest factor on the error that counts as serving as well.
const WORSE: f64 = 2.0;

/// What an estimate costs, and how good it is.
type Cost = (Amount, Amount);

impl Runs for Amortised {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for moved in self.moved_m {
            self.moved_by(context, moved, &mut finding)?;
        }
        for backend in context.backends() {
            self.shared(context, backend, &mut finding)?;
        }
        Ok(finding)
    }
}

impl Amortised {
    fn place(&self, context: &ExperimentContext<'_>, moved: f64, objects: u32) -> ExperimentScene {
        context
            .place(&self.scene)
            .set("receiver.moved", moved)
            .set("receivers", objects)
    }

    /// A map that is kept while the object is no farther than `within_m` from where it was made; always
    /// fresh for 0.
    fn map(
        &self,
        context: &ExperimentContext<'_>,
        within_m: f64,
    ) -> Result<Box<dyn Configured>, RunError> {
        let texels = (self.resolution, self.capture_resolution);
        localized(
            context,
            texels,
            "shader",
            &[("recapture_distance", &within_m)],
        )
    }

    fn moved_by(
        &self,
        context: &ExperimentContext<'_>,
        moved: f64,
        finding: &mut Finding,
    ) -> Result<(), RunError> {
        let loaded = context.load(&self.place(context, moved, 1), finding)?;
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
                let method = self.map(context, within_m)?;
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
                let (time, error) = weigh(
                    (&case, backend, software),
                    ("reused", kept),
                    ("fresh", fresh),
                    finding,
                );
                finding.judge("C2", [time]);
                finding.judge("C3", (moved <= self.near_m).then_some(error));
            }
        }
        finding.pictures.push(row);
        Ok(())
    }

    /// One map between the objects, against a map in the middle of each that shades the object's own points alone.
    fn shared(
        &self,
        context: &ExperimentContext<'_>,
        backend: Backend,
        finding: &mut Finding,
    ) -> Result<(), RunError> {
        let quantity = Quantity::Irradiance;
        let scene = context.scene(&self.place(context, 0.0, self.objects), finding)?;
        let middle = |mesh: &interreflect_scene::Mesh| {
            let (low, high) = mesh.bounds().unwrap_or_default();
            0.5 * (low + high)
        };
        let receivers = scene.objects_of(Role::Receiver);
        let middles: Vec<Vec3> = receivers.map(|o| middle(&o.mesh)).collect();
        let loaded = context.set_up(&scene)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        let mut references = context.references(&loaded, quantity, &points);
        let truth = references.truth();
        let judge = Judge::new(truth, &points);
        let method = self.map(context, 0.0)?;
        let one = context.run_timed(&loaded, backend, &*method, quantity, &points)?;
        let (mut each, mut each_ms) = (Estimate::new(points.len()), Amount::exact(0.0));
        for (own, &at) in of_each(&points, &middles).iter().zip(&middles) {
            let mut there = scene.clone();
            (there.reference_point, there.captured_at) = (at, None);
            let there = context.set_up(&there)?;
            let its = Points::new(points.layout(), own.iter().map(|&i| points.get(i)));
            let measured = context.run_timed(&there, backend, &*method, quantity, &its)?;
            for (k, &i) in own.iter().enumerate() {
                each.set(i, measured.estimate.get(k));
            }
            each_ms = each_ms.plus(measured.frame_ms());
            finding.runs.push(measured.run);
        }
        let case = format!("{} objects", self.objects);
        let one_cost = (one.frame_ms(), judge.error(&one.estimate));
        let at = (&*case, backend, context.software(backend));
        let each_cost = (each_ms, judge.error(&each));
        let (time, error) = weigh(
            at,
            ("one map", one_cost),
            ("a map each", each_cost),
            finding,
        );
        finding.judge("C1", [time, error]);
        if backend == context.backends()[0] {
            let row = pictures(&case, &view, &truth.values, [&one.estimate, &each]);
            finding.pictures.push(row);
        }
        finding.runs.push(one.run);
        Ok(())
    }
}

fn pictures(case: &str, view: &View, truth: &Estimate, [one, each]: [&Estimate; 2]) -> Row {
    let mut row = Row::rendered(case, "truth", view, truth);
    row.add("one map", view.image(one));
    row.add("a map each", view.image(each));
    row
}

/// For each of the places the indices of the points that no other place is nearer to.
fn of_each(points: &Points, places: &[Vec3]) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new(); places.len()];
    for (i, point) in points.iter().enumerate() {
        let Some(point) = point else { continue };
        let distance = |p: &Vec3| point.position.distance_squared(*p);
        let ranked = places.iter().enumerate();
        let nearest = ranked.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        if let Some((place, _)) = nearest {
            all[place].push(i);
        }
    }
    all
}

/// That the first way takes less time, and that its error is less than twice the other's.
fn weigh(
    (case, backend, software): (&str, Backend, bool),
    (cheap, (cheap_ms, cheap_error)): (&str, Cost),
    (dear, (dear_ms, dear_error)): (&str, Cost),
    finding: &mut Finding,
) -> (Trial, Trial) {
    for (label, ms, error) in [(cheap, cheap_ms, cheap_error), (dear, dear_ms, dear_error)] {
        let name = format!("frame, {label}");
        finding.time((case, name), backend, ms, ("ms", software));
        finding.measure((case, format!("{ERROR}, {label}")), backend, error, "");
    }
    let time = format!("{case}: frame of {cheap} below that of {dear}, ms");
    let error = format!("{case}: error of {cheap} below {WORSE} times that of {dear}");
    (
        Trial::less(time, backend, cheap_ms, dear_ms),
        Trial::less(error, backend, cheap_error, dear_error.times(WORSE)),
    )
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;
    use interreflect_scene::{Point, PointLayout};

    #[test]
    fn one_map_has_to_be_faster_and_not_twice_as_wrong() {
        let weighed = |cheap: Cost, dear: Cost| {
            let mut finding = Finding::default();
            let at = ("case", Backend::Cpu, false);
            let (time, error) = weigh(at, ("reused", cheap), ("fresh", dear), &mut finding);
            assert_eq!(finding.measured.len(), 4);
            assert_eq!(finding.measured[0].value, cheap.0.value);
            assert_eq!(finding.measured[3].value, dear.1.value);
            signs([&time, &error])
        };
        let cost = |ms: f64, error: f64| (about(ms), Amount::exact(error));
        assert_eq!(weighed(cost(1.0, 1.9), cost(2.0, 1.0)), "++");
        assert_eq!(weighed(cost(2.0, 2.1), cost(1.0, 1.0)), "--");
        assert_eq!(weighed(cost(2.0, 0.1), cost(2.1, 1.0)), "?+");
    }

    #[test]
    fn each_point_is_shaded_with_the_nearest_map_alone() {
        let at = |x: f32| {
            Some(Point {
                position: Vec3::X * x,
                normal: Vec3::Y,
                ..Point::default()
            })
        };
        let points = Points::new(PointLayout::Surface, [at(-0.9), at(0.2), None, at(-0.2)]);
        assert_eq!(
            of_each(&points, &[-Vec3::X, Vec3::X]),
            [vec![0, 3], vec![1]]
        );
        assert_eq!(
            of_each(&points, &[Vec3::X, -Vec3::X]),
            [vec![1], vec![0, 3]]
        );
    }
}
