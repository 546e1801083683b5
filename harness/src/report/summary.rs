//! The tables: runs by scene and quantity.

use super::{pictures, plot};
use crate::{
    format,
    record::{Comparison, Run, Timing, Verdict},
};
use interreflect_scene::params::FIDELITY;
use serde::Serialize;

/// How many runs of each kind a report has.
#[derive(Serialize)]
pub(super) struct Counts {
    runs: usize,
    skipped: usize,
    comparisons: usize,
    conclusive: usize,
}

/// All that belongs to one scene and one quantity.
#[derive(Serialize)]
pub(super) struct Section {
    scene: String,
    quantity: String,
    runs: Vec<Line>,
    plot: Option<plot::Plot>,
    pictures: Vec<pictures::Row>,
}

/// One run in words.
#[derive(Serialize)]
pub(super) struct Line {
    number: usize,
    estimator: String,
    fidelity: Option<String>,
    params: String,
    backend: String,
    software: bool,
    time_source: String,
    points: usize,
    times: Vec<Time>,
    truth: Cell,
    own_model: Cell,
    skipped: Option<String>,
}

/// One phase in words.
#[derive(Serialize)]
struct Time {
    median: String,
    /// Median absolute deviation; `None` for a single time.
    spread: Option<String>,
}

/// One comparison in words; `missing` says why there is none.
#[derive(Default, Serialize)]
pub(super) struct Cell {
    present: bool,
    relmse: String,
    rmse: String,
    energy: String,
    p999: String,
    max: String,
    floor: String,
    conclusive: bool,
    reference: String,
    missing: String,
}

impl Counts {
    pub(super) fn of(runs: &[Run]) -> Self {
        let comparisons = || runs.iter().flat_map(|r| r.own_model.iter().chain(&r.truth));
        Self {
            runs: runs.len(),
            skipped: runs.iter().filter(|r| r.skipped.is_some()).count(),
            comparisons: comparisons().count(),
            conclusive: comparisons()
                .filter(|c| c.verdict == Verdict::Conclusive)
                .count(),
        }
    }
}

/// Runs and pictures by scene and quantity, in the order in which these first appear.
pub(super) fn sections(runs: &[Run], pictures: Vec<pictures::Row>) -> Vec<Section> {
    let mut keys: Vec<(&str, &str)> = Vec::new();
    let of_runs = runs.iter().map(|r| (r.scene.as_str(), r.quantity.as_str()));
    for key in of_runs.chain(pictures.iter().map(pictures::Row::key)) {
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    let section = |(scene, quantity): (&str, &str)| {
        let runs: Vec<&Run> = runs
            .iter()
            .filter(|r| r.scene == scene && r.quantity == quantity)
            .collect();
        Section {
            scene: scene.into(),
            quantity: quantity.replace('_', " "),
            plot: plot::Plot::of(&runs),
            runs: runs
                .iter()
                .enumerate()
                .map(|(i, run)| line(i + 1, run))
                .collect(),
            pictures: pictures
                .iter()
                .filter(|p| p.key() == (scene, quantity))
                .cloned()
                .collect(),
        }
    };
    keys.into_iter().map(section).collect()
}

fn line(number: usize, run: &Run) -> Line {
    let params = run.params.0.iter().filter(|(name, _)| name != FIDELITY);
    let params: Vec<String> = params
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    Line {
        number,
        estimator: run.estimator.clone(),
        fidelity: run.fidelity.clone(),
        params: params.join(", "),
        backend: run.backend.to_string(),
        software: run.software,
        time_source: run.time_source.to_string(),
        points: run.points,
        times: run.phases_ms.named().map(|(_, t)| time(t)).into(),
        truth: cell(run.truth.as_ref(), run.truth_missing.as_deref()),
        own_model: cell(run.own_model.as_ref(), run.own_model_missing.as_deref()),
        skipped: run.skipped.clone(),
    }
}

fn time(timing: Option<Timing>) -> Time {
    Time {
        median: format::optional(timing.map(|t| t.median)),
        spread: timing.filter(|t| t.n > 1).map(|t| format::deviation(t.mad)),
    }
}

fn cell(comparison: Option<&Comparison>, missing: Option<&str>) -> Cell {
    let Some(c) = comparison else {
        return Cell {
            missing: missing.unwrap_or("not compared").into(),
            ..Cell::default()
        };
    };
    Cell {
        present: true,
        relmse: format::relmse(c),
        rmse: format::number(c.rmse),
        energy: format::optional(c.energy_ratio),
        p999: format::number(c.p999),
        max: format::number(c.max),
        floor: format::optional(c.noise_floor),
        conclusive: c.verdict == Verdict::Conclusive,
        reference: c.reference.clone().unwrap_or_default(),
        missing: String::new(),
    }
}
