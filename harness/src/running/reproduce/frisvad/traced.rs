//! Figure 5: the Cornell box by path tracing and by eq. 14.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::{Judge, scaled};
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::places::Places;
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
    fn each_rule_can_fail() {
        let sign = |claim, values| signs([&judged(claim, Backend::Cpu, "", values)]);
        let both = |claim| sign(claim, [1.0, 2.0]) + &sign(claim, [2.0, 1.0]);
        assert_eq!(["C1", "C2", "C3", "C4"].map(both), ["+-", "-+", "+-", "-+"]);
        let faster = |times| signs([&faster(Backend::Cpu, Amount::exact(times))]);
        assert_eq!([faster(999.0), faster(1001.0)], ["-", "+"]);
    }
}
