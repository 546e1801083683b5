//! Time of a frame over directions and vertices: with and without filtering, at rest and deforming.

use super::super::desk::{Desk, amount_of};
use super::super::finding::Finding;
use super::super::place::Place;
use super::super::verdict::{Amount, Trial};
use super::directions;
use super::sequence::{DEFORMING, Moment, RESTING};
use crate::error::HarnessError;
use crate::record::Backend;
use crate::stages::Running;
use interreflect_estimators::Quantity;
use interreflect_scene::Scene;
use interreflect_scene::motion::Moves;

/// Levels of the table.
const LEVELS: [u32; 2] = [1, 2];

/// Times of one model and level.
struct Times {
    deforming: Amount,
    filtered: Amount,
    resting: Amount,
}

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    for backend in desk.backends() {
        let mut table = Vec::new();
        for model in ["dragon", "buddha", "bunny"] {
            let model = desk.mesh(model);
            let place = Place::of("studio")
                .with(&model)
                .set("receiver.deformation", "wave")
                .set("environment.turn_deg_per_s", 30);
            let rest = desk.scene(&place, &mut finding)?;
            let vertices: usize = rest.objects.iter().map(|o| o.mesh.positions.len()).sum();
            let mut of_model = Vec::new();
            for &level in levels(desk) {
                let times = measure(desk, &rest, (backend, level))?;
                note(
                    (&model.name, vertices),
                    (desk, backend, level),
                    &times,
                    &mut finding,
                );
                of_model.push(times);
            }
            table.push((model.name, vertices, of_model));
        }
        judge(desk, backend, &table, &mut finding);
    }
    Ok(finding)
}

fn levels(desk: &Desk<'_>) -> &'static [u32] {
    desk.pick(&LEVELS[..], &[0, 1, 2, 3])
}

fn measure(
    desk: &Desk<'_>,
    rest: &Scene,
    (backend, level): (Backend, u32),
) -> Result<Times, HarnessError> {
    let resolution = desk.pick(96, 256);
    let method = |filter: bool| {
        desk.method(
            "directional_ao",
            &[
                ("level", &level),
                ("map_resolution", &resolution),
                ("filter", &filter),
            ],
        )
    };
    let (plain, with_lists) = (method(false)?, method(true)?);
    let frames = desk.pick(4_u8, 12);
    let mut running: [Running; 3] = Default::default();
    let [all, filtered, still] = &mut running;
    let (mut plain_ms, mut filtered_ms, mut still_ms) = (Vec::new(), Vec::new(), Vec::new());
    let resting = Moment::of(desk, rest, 0.0)?;
    let turning = Moves {
        environment: true,
        ..RESTING
    };
    for index in 0..=frames {
        let moment = Moment::of(desk, rest, f32::from(index) / 15.0)?;
        let of = Quantity::Irradiance;
        let a = moment.shade_as(desk, (all, backend), (&*plain, of), DEFORMING)?;
        let b = moment.shade_as(desk, (filtered, backend), (&*with_lists, of), DEFORMING)?;
        let c = resting.shade_as(desk, (still, backend), (&*plain, of), turning)?;
        // The first frames warm up, and the resting model's has all its directions to do.
        if index > 0 {
            plain_ms.push(a.ms);
            filtered_ms.push(b.ms);
            still_ms.push(c.ms);
        }
    }
    Ok(Times {
        deforming: amount_of(&plain_ms),
        filtered: amount_of(&filtered_ms),
        resting: amount_of(&still_ms),
    })
}

fn note(
    (model, vertices): (&str, usize),
    (desk, backend, level): (&Desk<'_>, Backend, u32),
    times: &Times,
    finding: &mut Finding,
) {
    let case = format!("{model}, {vertices} vertices, k = {}", directions(level));
    for (name, ms) in [
        ("animated", times.deforming),
        ("animated, filtered", times.filtered),
        ("static", times.resting),
    ] {
        finding.time((&*case, name), backend, ms, ("ms", desk.software(backend)));
    }
}

fn judge(
    desk: &Desk<'_>,
    backend: Backend,
    table: &[(String, usize, Vec<Times>)],
    finding: &mut Finding,
) {
    for (model, _, times) in table {
        for (pair, level) in times.windows(2).zip(levels(desk)) {
            let (fewer, more) = (directions(*level), directions(level + 1));
            let what = format!("{model}: {fewer} directions below {more}, ms");
            finding.trials.push(Trial::less(
                what,
                backend,
                pair[0].deforming,
                pair[1].deforming,
            ));
        }
        for (t, level) in times.iter().zip(levels(desk)) {
            let k = directions(*level);
            let what = format!("{model}, k = {k}: filtered below unfiltered, ms");
            finding
                .trials
                .push(Trial::less(what, backend, t.filtered, t.deforming));
            let what = format!("{model}, k = {k}: static below animated, ms");
            finding
                .trials
                .push(Trial::less(what, backend, t.resting, t.deforming));
        }
    }
    let fewest = table.iter().min_by_key(|t| t.1);
    let most = table.iter().max_by_key(|t| t.1);
    if let (Some(fewest), Some(most)) = (fewest, most) {
        for ((a, b), level) in fewest.2.iter().zip(&most.2).zip(levels(desk)) {
            let (k, few, many) = (directions(*level), fewest.1, most.1);
            let what = format!("k = {k}: {few} vertices below {many}, ms");
            finding
                .trials
                .push(Trial::less(what, backend, a.deforming, b.deforming));
        }
    }
}
