//! The tables: runs by scene and quantity.

use super::command::Commands;
use super::mark::Numbered;
use super::{Report, curves, names, pareto};
use crate::domain::format;
use crate::domain::record::{Comparison, Run, Timing, Verdict};
use crate::presenting::error::PresentError;
use crate::presenting::table::Table;
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
    /// Hash of the scene, where it is known.
    scene_hash: Option<String>,
    /// The command that makes this section again.
    command: String,
    /// The ε of relMSE against the truth, in the quantity's unit squared.
    epsilon: Option<String>,
    runs: Vec<Line>,
    plot: Option<pareto::Plot>,
    legend: Vec<Method>,
    curves: Vec<curves::Curves>,
    tables: Vec<Table>,
}

/// A method in the legend of plots.
#[derive(Serialize)]
struct Method {
    hue: usize,
    label: String,
    /// Numbers of its runs.
    numbers: Vec<usize>,
}

/// One run in words.
#[derive(Serialize)]
pub(super) struct Line {
    number: usize,
    hue: usize,
    command: String,
    estimator: String,
    fidelity: Option<String>,
    params: String,
    /// The parameters in which it differs from other runs of its method.
    varied: String,
    backend: String,
    software: bool,
    time_source: String,
    points: usize,
    /// Each phase, and the frame.
    times: Vec<Time>,
    memory: String,
    /// What the processor did meanwhile, if it is worth a remark.
    slowed: Option<String>,
    /// How far the backends are apart, if that is more than captures explain.
    backends_apart: Option<String>,
    truth: Cell,
    own_model: Cell,
    skipped: Option<String>,
}

/// One time in words.
#[derive(Serialize)]
struct Time {
    median: String,
    /// Median absolute deviation; `None` for a single time.
    spread: Option<String>,
    /// How it was taken, and how far it can be believed.
    how: String,
    /// Something speaks against it: it did not settle, or drifted, or another clock had to do.
    doubtful: bool,
}

/// One comparison in words; `missing` says why there is none.
#[derive(Default, Serialize)]
pub(super) struct Cell {
    present: bool,
    relmse: String,
    rmse: String,
    energy: String,
    flip: Option<String>,
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

/// Runs, plots and tables by scene and quantity, in the order in which these first appear.
pub(super) fn sections(report: &Report) -> Result<Vec<Section>, PresentError> {
    let all = names::named(&report.runs);
    let commands = report.invocation.as_ref().and_then(Commands::of);
    let mut keys: Vec<(&str, &str)> = Vec::new();
    let of_runs = report.runs.iter().map(|r| (&r.scene, &r.quantity));
    let of_rows = report.rows.iter().map(|r| (&r.scene, &r.quantity));
    for (scene, quantity) in of_runs.chain(of_rows) {
        if !keys.contains(&(scene.as_str(), quantity.as_str())) {
            keys.push((scene, quantity));
        }
    }
    let section = |(scene, quantity): (&str, &str)| {
        let runs: Vec<Numbered<'_>> = all
            .iter()
            .filter(|n| n.run.scene == scene && n.run.quantity == quantity)
            .cloned()
            .collect();
        let truths = || runs.iter().filter_map(|n| n.run.truth.as_ref());
        let concluded = report.conclusions.iter();
        let concluded = concluded.filter(|t| t.scene == scene && t.quantity == quantity);
        Ok(Section {
            scene: scene.into(),
            quantity: quantity.replace('_', " "),
            scene_hash: runs.iter().find_map(|n| n.run.scene_hash.clone()),
            command: match &commands {
                Some(commands) => commands.section(scene, quantity),
                None => report.command.clone(),
            },
            epsilon: truths().next().map(|c| format::number(c.epsilon)),
            plot: pareto::Plot::of(&runs)?,
            legend: legend(&runs),
            curves: curves::curves(&runs)?,
            tables: concluded.flat_map(|t| t.tables.clone()).collect(),
            runs: runs.iter().map(|n| line(n, commands.as_ref())).collect(),
        })
    };
    keys.into_iter().map(section).collect()
}

/// Methods in the order in which they first appear, with the numbers of the runs that took place.
fn legend(runs: &[Numbered<'_>]) -> Vec<Method> {
    let mut methods: Vec<Method> = Vec::new();
    for n in runs.iter().filter(|n| n.run.skipped.is_none()) {
        let label = n.run.label();
        match methods.iter_mut().find(|m| m.label == label) {
            Some(method) => method.numbers.push(n.number),
            None => methods.push(Method {
                hue: n.hue,
                label,
                numbers: vec![n.number],
            }),
        }
    }
    methods
}

fn line(of: &Numbered<'_>, commands: Option<&Commands<'_>>) -> Line {
    let run = of.run;
    let params = run.params.0.iter().filter(|(name, _)| name != FIDELITY);
    let params: Vec<String> = params
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    let phases = run.phases_ms.named().into_iter().map(|(_, t)| t);
    Line {
        number: of.number,
        hue: of.hue,
        command: commands.and_then(|c| c.run(run)).unwrap_or_default(),
        estimator: run.estimator.clone(),
        fidelity: run.fidelity.clone(),
        params: params.join(", "),
        varied: of.varied().to_owned(),
        backend: run.backend.to_string(),
        software: run.software,
        time_source: run.time_source.to_string(),
        points: run.points,
        times: phases.chain([run.phases_ms.frame()]).map(time).collect(),
        memory: memory(run),
        slowed: run
            .slowed
            .map(|by| format!("the processor was {by:.2} times slower than at its best")),
        backends_apart: run
            .backends_apart
            .map(|apart| format!("{:.1} % away from the other backend", 100.0 * apart)),
        truth: cell(run.truth.as_ref(), run.truth_missing.as_deref()),
        own_model: cell(run.own_model.as_ref(), run.own_model_missing.as_deref()),
        skipped: run.skipped.clone(),
    }
}

fn time(timing: Option<Timing>) -> Time {
    let doubts = timing.map_or(Vec::new(), |t| doubts(&t));
    Time {
        median: format::optional(timing.map(|t| t.median)),
        spread: timing.filter(|t| t.n > 1).map(|t| format::deviation(t.mad)),
        how: timing.map_or(String::new(), |t| how(&t, &doubts)),
        doubtful: !doubts.is_empty(),
    }
}

fn how(timing: &Timing, doubts: &[String]) -> String {
    let interval = match timing.low < timing.high {
        true => format!(
            ", median between {} and {} (95 %)",
            format::number(timing.low),
            format::number(timing.high)
        ),
        false => String::new(),
    };
    let mut words = vec![format!("{} times by {}{interval}", timing.n, timing.source)];
    words.extend_from_slice(doubts);
    words.join("; ")
}

fn doubts(timing: &Timing) -> Vec<String> {
    let settled = (timing.settled == Some(false)).then(|| "not settled".to_owned());
    let drift = timing
        .drift
        .map(|drift| format!("drifted by {:+.0} %", 100.0 * drift));
    let fallback = timing.fallback.map(|why| why.to_string());
    settled.into_iter().chain(drift).chain(fallback).collect()
}

/// Captures and own data in MiB.
fn memory(run: &Run) -> String {
    let mebibytes = |bytes: u64| format::number(bytes as f64 / f64::from(1 << 20));
    let own = |own: Option<u64>| own.map_or_else(|| "?".into(), mebibytes);
    run.bytes.map_or(String::new(), |b| {
        format!("{} + {}", mebibytes(b.captures), own(b.own))
    })
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
        flip: c.flip.map(format::number),
        p999: format::number(c.p999),
        max: format::number(c.max),
        floor: format::optional(c.noise_floor),
        conclusive: c.verdict == Verdict::Conclusive,
        reference: c.reference.clone().unwrap_or_default(),
        missing: String::new(),
    }
}
