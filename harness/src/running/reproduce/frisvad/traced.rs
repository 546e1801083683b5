//! Figure 5: the Cornell box by path tracing and by eq. 14.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::steps::{BOX, GRID, Grid, Step, take, view};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::lambertian;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Point, PointLayout};
use serde::Serialize;
use std::time::Instant;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.5",
    paper: Paper::Frisvad,
    item: Item::Figure(5),
    title: "Cornell box by path tracing and by eq. 14",
    setup: &AgainstPathTracing {
        scene: BOX,
        grid: GRID,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "The map is cruder, its bleeding more mixed over floor, ceiling and back wall.",
            rule: "A trial is a backend: red less green over their sum has a smaller standard deviation over \
                these walls than path tracing's.",
        },
        Claim {
            id: "C2",
            says: "Regions in shadow are too bright.",
            rule: "A trial is a backend: the floor's mean irradiance where no direct light falls, over that \
                where it does, is larger than path tracing's.",
        },
        Claim {
            id: "C3",
            says: "There is no bright spot above the tall box.",
            rule: "A trial is a backend: the ceiling within 8 cm above the tall box, over all of the ceiling, is \
                less bright than path tracing's.",
        },
        Claim {
            id: "C4",
            says: "The tall box is greener in front.",
            rule: "A trial is a backend: green over red on the tall box's front is larger than path tracing's.",
        },
        Claim {
            id: "C5",
            says: "The map is thousands of times faster.",
            rule: "A trial is a backend: a frame, direct light included, is more than 1000 times as fast as \
                path tracing the indirect light on all processors, beyond its spread.",
        },
    ],
};

/// How many times faster at least.
const FASTER: f64 = 1000.0;

/// Path tracing stands in for radiosity and for the photon map.
#[derive(Serialize)]
pub(super) struct AgainstPathTracing {
    pub(super) scene: SceneSetup,
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl Runs for AgainstPathTracing {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        finding.note("path tracing stands in for radiosity and for the photon map");
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = view(context, &loaded, Step::Eq14)?;
        let points = view.points(Quantity::Irradiance.layout());
        let start = Instant::now();
        let mut references = context.references(&loaded, Quantity::Irradiance, &points);
        let truth = references.truth();
        let traced_ms = start.elapsed().as_secs_f64() * 1e3;
        let all: Vec<Point> = points.iter().map(Option::unwrap_or_default).collect();
        let materials = view.points(PointLayout::Material);
        let judge = Judge::new(truth, &points);
        let traced = Amount::exact(traced_ms);
        finding.time(
            ("path tracing", "frame"),
            Backend::Cpu,
            traced,
            ("ms", false),
        );
        for backend in context.backends() {
            let what = (&[Step::Eq14][..], self.grid, backend);
            let taken = take(context, ("Cornell box", &loaded), what, &mut finding)?;
            let Some(map) = taken.into_iter().next() else {
                continue;
            };
            let direct = context.direct_light(&loaded, backend, &view)?;
            let lit = |e: &Estimate| view.lit(&lambertian(&materials, e), &direct);
            let title = format!("Cornell box, {backend}");
            let mut row = Row::against(title, "path tracing", lit(&truth.values), view.surfaces());
            row.add("eq. 14", map.image);
            // The published areas lose light by themselves: shades are compared.
            let shades = scaled(&map.irradiance, judge.factor(&map.irradiance));
            row.add("eq. 14, as bright as the truth", lit(&shades));
            finding.pictures.push(row);
            let at_points = context.direct_light_at(&loaded, backend, &materials)?;
            let dark: Vec<bool> = at_points.iter().map(|v| v == Vec3::ZERO).collect();
            let places = Places {
                points: &all,
                dark: &dark,
            };
            for (claim, what, [ours, theirs]) in
                places.compared(&shades, (&truth.values, &truth.error))
            {
                for (whose, value) in [("eq. 14", ours), ("path tracing", theirs)] {
                    let amount = Amount::exact(value);
                    finding.measure((whose, what), backend, amount, "");
                }
                finding.judge(claim, [judged(claim, backend, what, [ours, theirs])]);
            }
            let times = traced.over(map.frame_ms);
            let software = context.software(backend);
            finding.time(("eq. 14", "times as fast"), backend, times, ("", software));
            finding.judge("C5", [faster(backend, times)]);
        }
        Ok(finding)
    }
}

/// Points of the picture, by where they are in the box.
struct Places<'a> {
    points: &'a [Point],
    /// Without direct light.
    dark: &'a [bool],
}

/// In metres, of the measured box: how near to a wall is on it, where the tall block's front and top are.
const ON_WALL_M: f32 = 1e-3;
const BOX_M: Vec3 = Vec3::new(0.556, 0.5488, 0.5592);
const TALL_TOP_M: f32 = 0.33;
const TALL_MIDDLE_M: Vec3 = Vec3::new(0.3685, 0.165, 0.35125);
const SPOT_M: f32 = 0.08;

impl Places<'_> {
    /// Claim, what is measured, and its value for the map and for the truth.
    fn compared(
        &self,
        map: &Estimate,
        (truth, error): (&Estimate, &Estimate),
    ) -> [(&'static str, &'static str, [f64; 2]); 4] {
        let both = |measure: &dyn Fn(&Estimate) -> f64| [measure(map), measure(truth)];
        [
            (
                "C1",
                "spread of bleeding over floor, ceiling and back wall",
                [self.bleeding(map, None), self.bleeding(truth, Some(error))],
            ),
            (
                "C2",
                "irradiance out of direct light over that in it",
                both(&|e| self.in_shadow(e)),
            ),
            (
                "C3",
                "ceiling above the tall block over the ceiling",
                both(&|e| self.spot(e)),
            ),
            (
                "C4",
                "green of the tall block's front over red",
                both(&|e| self.green(e)),
            ),
        ]
    }

    /// Standard deviation of (red − green)/(red + green) over white walls, less what an estimate's own standard
    /// errors add to it.
    fn bleeding(&self, e: &Estimate, error: Option<&Estimate>) -> f64 {
        let on = |p: &Point| {
            let [y, z] = [p.position.y, p.position.z];
            let between = ON_WALL_M..=BOX_M.y - ON_WALL_M;
            !between.contains(&y) || z > BOX_M.z - ON_WALL_M
        };
        let shades: Vec<(f64, f64)> = self
            .at(on)
            .map(|i| {
                let noise = error.map_or(0.0, |error| balance_variance(e.get(i), error.get(i)));
                (balance(e.get(i)), noise)
            })
            .collect();
        let count = shades.len().max(1) as f64;
        let mean = shades.iter().map(|s| s.0).sum::<f64>() / count;
        let square: f64 = shades.iter().map(|s| (s.0 - mean).powi(2) - s.1).sum();
        (square.max(0.0) / count).sqrt()
    }

    /// Mean on the floor without direct light over that with it.
    fn in_shadow(&self, e: &Estimate) -> f64 {
        let floor = |p: &Point| p.position.y < ON_WALL_M;
        let mean = |dark: bool| mean(e, self.at(floor).filter(|&i| self.dark[i] == dark));
        mean(true) / mean(false)
    }

    /// Mean on the ceiling above the tall block over that on all of the ceiling.
    fn spot(&self, e: &Estimate) -> f64 {
        let ceiling = |p: &Point| p.position.y > BOX_M.y - ON_WALL_M;
        let above = |p: &Point| {
            let across = (p.position - TALL_MIDDLE_M) * Vec3::new(1.0, 0.0, 1.0);
            ceiling(p) && across.length() < SPOT_M
        };
        mean(e, self.at(above)) / mean(e, self.at(ceiling))
    }

    /// Green over red on the tall block's front.
    fn green(&self, e: &Estimate) -> f64 {
        let front = |p: &Point| {
            let across = (p.position - TALL_MIDDLE_M) * Vec3::new(1.0, 0.0, 1.0);
            let low = p.position.y > ON_WALL_M && p.position.y < TALL_TOP_M - ON_WALL_M;
            low && across.length() < 0.14 && p.normal.z < -0.5
        };
        let sum = self.at(front).fold(Vec3::ZERO, |sum, i| sum + e.get(i));
        f64::from(sum.y / sum.x)
    }

    fn at<'s>(&'s self, on: impl Fn(&Point) -> bool + 's) -> impl Iterator<Item = usize> + 's {
        let there = self.points.iter().enumerate();
        there.filter(move |(_, p)| on(p)).map(|(i, _)| i)
    }
}

/// (red − green)/(red + green).
fn balance(v: Vec3) -> f64 {
    f64::from((v.x - v.y) / (v.x + v.y).max(f32::MIN_POSITIVE))
}

/// Variance of [`balance`] that independent standard errors of red and green cause, to first order.
fn balance_variance(v: Vec3, error: Vec3) -> f64 {
    let (v, error) = (v.as_dvec3(), error.as_dvec3());
    let square = (v.x + v.y).powi(2).max(f64::MIN_POSITIVE);
    (2.0 * v.y * error.x / square).powi(2) + (2.0 * v.x * error.y / square).powi(2)
}

fn mean(e: &Estimate, at: impl Iterator<Item = usize>) -> f64 {
    let (mut sum, mut count) = (0.0, 0_usize);
    for i in at {
        sum += f64::from(e.get(i).element_sum()) / 3.0;
        count += 1;
    }
    sum / count.max(1) as f64
}

/// That shadows are brighter and the block greener by the map, bleeding more mixed and the spot weaker.
fn judged(claim: &str, backend: Backend, what: &str, [ours, theirs]: [f64; 2]) -> Trial {
    match claim {
        "C1" | "C3" => Trial::less_by(
            format!("{what}, map below truth"),
            backend,
            (ours, theirs),
            0.0,
        ),
        _ => Trial::less_by(
            format!("{what}, truth below map"),
            backend,
            (theirs, ours),
            0.0,
        ),
    }
}

fn faster(backend: Backend, times: Amount) -> Trial {
    let what = "1000 below how many times as fast as path tracing";
    Trial::less(what, backend, Amount::exact(FASTER), times).of_times()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn places_are_found_and_rules_can_fail() {
        let at = |x, y, z, normal| Point {
            position: Vec3::new(x, y, z),
            normal,
            ..Point::default()
        };
        let points = [
            at(0.1, 0.0, 0.1, Vec3::Y),
            at(0.2, 0.0, 0.1, Vec3::Y),
            at(0.37, BOX_M.y, 0.35, Vec3::NEG_Y),
            at(0.1, BOX_M.y, 0.1, Vec3::NEG_Y),
            at(0.34, 0.2, 0.27, Vec3::new(0.3, 0.0, -0.95)),
        ];
        let places = Places {
            points: &points,
            dark: &[true, false, true, true, false],
        };
        let mut e = Estimate::new(5);
        for (i, value) in [1.0, 4.0, 3.0, 1.0, 2.0].into_iter().enumerate() {
            e.set(i, Vec3::new(value, 2.0 * value, 0.0));
        }
        assert!((places.in_shadow(&e) - 0.25).abs() < 1e-6);
        assert!((places.spot(&e) - 1.5).abs() < 1e-6);
        assert!((places.green(&e) - 2.0).abs() < 1e-6);
        assert!(places.bleeding(&e, None) < 1e-6);
        e.set(0, Vec3::X);
        let spread = places.bleeding(&e, None);
        let mut error = Estimate::new(5);
        assert!(spread > 0.1 && places.bleeding(&e, Some(&error)) == spread);
        (0..5).for_each(|i| error.set(i, Vec3::splat(9.0)));
        assert_eq!(
            places.bleeding(&e, Some(&error)),
            0.0,
            "all of it may be noise"
        );
        let sign = |claim, values| signs([&judged(claim, Backend::Cpu, "", values)]);
        let both = |claim| sign(claim, [1.0, 2.0]) + &sign(claim, [2.0, 1.0]);
        assert_eq!(["C1", "C2", "C3", "C4"].map(both), ["+-", "-+", "+-", "-+"]);
        let faster = |times| signs([&faster(Backend::Cpu, Amount::exact(times))]);
        assert_eq!([faster(999.0), faster(1001.0)], ["-", "+"]);
    }
}
