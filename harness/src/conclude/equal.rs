//! Methods held against each other, and against the baselines, at equal time and at equal error.

use super::baseline::{Baseline, Curve, Interpolated, Reach};
use super::candidate::{Candidate, Choice, FrameTime, grouped};
use super::{Measured, Metric, series};
use crate::record::{Backend, Run};
use serde::Serialize;

/// What a table asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Question {
    /// The least error within a frame time in milliseconds.
    EqualTime,
    /// The least frame time to an error.
    EqualError,
}

/// The answers for one scene, quantity and backend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    /// What is asked.
    pub question: Question,
    /// By which error.
    pub metric: Metric,
    /// Name of the scene.
    pub scene: String,
    /// Name of the estimated quantity, in snake case.
    pub quantity: String,
    /// Where the methods ran. Baselines run on the CPU always.
    pub backend: Backend,
    /// It was a software adapter: its times say nothing about a GPU.
    pub software: bool,
    /// Who is held against each other.
    pub contestants: Vec<Contestant>,
    /// One for each limit of the 1-2-5 series; the same limits on every backend.
    pub rows: Vec<Row>,
}

/// A method with a fidelity, or a baseline.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Contestant {
    /// Its name in words.
    pub name: String,
    /// Which baseline it is; `None` for a method.
    pub baseline: Option<Baseline>,
}

/// What all contestants reach within one limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Milliseconds, or an error.
    pub limit: f64,
    /// One for each contestant.
    pub cells: Vec<Cell>,
    /// Index of the contestant that does best; `None` if none is within the limit.
    pub winner: Option<usize>,
    /// Indices of the contestants that can't be told apart from the winner.
    pub alike: Vec<usize>,
}

/// What a contestant reaches within a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Cell {
    /// The best of a method's runs.
    Run(Choice),
    /// A baseline between measured sample counts.
    Interpolated(Interpolated),
    /// A baseline would need fewer samples than were measured.
    Below {
        /// The fewest that were measured.
        samples: u32,
    },
    /// A baseline would need more samples than were measured.
    Beyond {
        /// The most that were measured.
        samples: u32,
    },
    /// None of the method's runs is within the limit.
    Missed,
}

impl Cell {
    /// Frame time and error, where there are numbers.
    pub fn numbers(&self) -> Option<(FrameTime, Measured)> {
        match self {
            Self::Run(choice) => Some((choice.frame, choice.error)),
            Self::Interpolated(at) => Some((at.frame, at.error)),
            Self::Below { .. } | Self::Beyond { .. } | Self::Missed => None,
        }
    }
}

impl From<Reach> for Cell {
    fn from(reach: Reach) -> Self {
        match reach {
            Reach::At(at) => Self::Interpolated(at),
            Reach::Below(samples) => Self::Below { samples },
            Reach::Beyond(samples) => Self::Beyond { samples },
        }
    }
}

impl Question {
    /// The limited number and the one to be made small.
    fn ordered(self, time: f64, error: f64) -> (f64, f64) {
        match self {
            Self::EqualTime => (time, error),
            Self::EqualError => (error, time),
        }
    }

    fn of_run(self, run: &Candidate<'_>) -> (f64, f64) {
        self.ordered(run.time.ms, run.error.value)
    }

    fn reach(self, curve: &Curve, limit: f64) -> Reach {
        match self {
            Self::EqualTime => curve.at_time(limit),
            Self::EqualError => curve.at_error(limit),
        }
    }

    fn alike(self, a: (FrameTime, Measured), b: (FrameTime, Measured)) -> bool {
        match self {
            Self::EqualTime => a.1.alike(b.1),
            Self::EqualError => a.0.alike(b.0),
        }
    }
}

/// The least error of each method, and of the baselines, within frame times that span the methods'.
pub fn equal_time(runs: &[Run], baselines: &[Run], metric: Metric) -> Vec<Table> {
    tables(Question::EqualTime, runs, baselines, metric)
}

/// The least frame time of each method, and of the baselines, to errors that span the methods'.
pub fn equal_error(runs: &[Run], baselines: &[Run], metric: Metric) -> Vec<Table> {
    tables(Question::EqualError, runs, baselines, metric)
}

fn tables(question: Question, runs: &[Run], baselines: &[Run], metric: Metric) -> Vec<Table> {
    let candidates = Candidate::all(runs, metric);
    let mut tables = Vec::new();
    for ((scene, quantity), of_both) in grouped(&candidates, |r| (&r.scene, &r.quantity)) {
        let limits = series::spanning(of_both.iter().map(|c| question.of_run(c).0));
        let curves = Curve::all(baselines, scene, quantity, metric);
        for ((backend, software), group) in grouped(&of_both, |r| (r.backend, r.software)) {
            let methods = grouped(&group, Run::label);
            tables.push(Table {
                question,
                metric,
                scene: scene.clone(),
                quantity: quantity.clone(),
                backend,
                software,
                contestants: contestants(&methods, &curves),
                rows: limits
                    .iter()
                    .map(|limit| row(question, *limit, &methods, &curves))
                    .collect(),
            });
        }
    }
    tables
}

type Methods<'a> = [(String, Vec<Candidate<'a>>)];

fn contestants(methods: &Methods<'_>, curves: &[Curve]) -> Vec<Contestant> {
    let methods = methods.iter().map(|(name, _)| Contestant {
        name: name.clone(),
        baseline: None,
    });
    let baselines = curves.iter().map(|curve| Contestant {
        name: curve.baseline.to_string(),
        baseline: Some(curve.baseline),
    });
    methods.chain(baselines).collect()
}

fn row(question: Question, limit: f64, methods: &Methods<'_>, curves: &[Curve]) -> Row {
    let methods = methods.iter().map(|(_, runs)| best(question, limit, runs));
    let baselines = curves.iter().map(|c| question.reach(c, limit).into());
    let cells: Vec<Cell> = methods.chain(baselines).collect();
    let numbers: Vec<_> = cells.iter().map(Cell::numbers).collect();
    let sought = |n: &(FrameTime, Measured)| question.ordered(n.0.ms, n.1.value).1;
    let standing = numbers
        .iter()
        .enumerate()
        .filter_map(|(i, n)| Some((i, (*n)?)));
    let winner = standing
        .clone()
        .min_by(|(_, a), (_, b)| sought(a).total_cmp(&sought(b)));
    Row {
        limit,
        winner: winner.map(|(i, _)| i),
        alike: standing
            .filter(|(i, n)| winner.is_some_and(|(w, best)| *i != w && question.alike(best, *n)))
            .map(|(i, _)| i)
            .collect(),
        cells,
    }
}

/// The best of a method's runs within a limit; of runs that tie, the one furthest inside it.
fn best(question: Question, limit: f64, runs: &[Candidate<'_>]) -> Cell {
    let order = |c: &Candidate<'_>| {
        let (limited, sought) = question.of_run(c);
        (sought, limited)
    };
    let within = runs.iter().filter(|c| question.of_run(c).0 <= limit);
    let best = within.min_by(|a, b| {
        let ((a, a_limited), (b, b_limited)) = (order(a), order(b));
        a.total_cmp(&b).then(a_limited.total_cmp(&b_limited))
    });
    best.map_or(Cell::Missed, |c| Cell::Run(Choice::of(c, runs)))
}
