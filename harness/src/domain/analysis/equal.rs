//! Methods held against each other, and against the baselines, at equal time and at equal error.

use super::baseline::{Baseline, Curve, Interpolated, Reach};
use super::candidate::{Candidate, Choice, FrameTime, grouped};
use super::{Measured, Metric, Problem, nice_numbers};
use crate::domain::record::{Backend, Run};
use serde::Serialize;

/// Frame time and error.
pub type Numbers = (FrameTime, Measured);

/// What a table asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Question {
    /// The least error within a frame time in milliseconds.
    EqualTime,
    /// The least frame time to an error.
    EqualError,
}

/// The answers for one place and backend.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Table {
    /// What is asked.
    pub question: Question,
    /// By which error.
    pub metric: Metric,
    /// What is estimated.
    #[serde(flatten)]
    pub problem: Problem,
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
    /// Indices of the baselines that might do better with a sample count that was not measured.
    pub open: Vec<usize>,
}

/// What a contestant reaches within a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Cell {
    /// The best of a method's runs.
    Run(Choice),
    /// A baseline between measured sample counts.
    Interpolated(Interpolated),
    /// A baseline with all that was measured within the limit: at least as good as this end of it.
    Bound(Interpolated),
    /// A baseline with nothing that was measured within the limit; this end of it comes nearest.
    Outside(Interpolated),
    /// None of the method's runs is within the limit.
    Missed,
}

impl Cell {
    /// Frame time and error that are within the limit, where there are such.
    pub fn numbers(&self) -> Option<Numbers> {
        match self {
            Self::Run(choice) => Some((choice.frame, choice.error)),
            Self::Interpolated(at) | Self::Bound(at) => Some((at.frame, at.error)),
            Self::Outside(_) | Self::Missed => None,
        }
    }
}

impl From<Reach> for Cell {
    fn from(reach: Reach) -> Self {
        match reach {
            Reach::At(at) => Self::Interpolated(at),
            Reach::Within(end) => Self::Bound(end),
            Reach::Outside(end) => Self::Outside(end),
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

    fn sought(self, (time, error): Numbers) -> f64 {
        self.ordered(time.ms, error.value).1
    }

    fn alike(self, a: Numbers, b: Numbers) -> bool {
        match self {
            Self::EqualTime => a.1.alike(b.1),
            Self::EqualError => a.0.alike(b.0),
        }
    }

    /// Whether a sample count that was not measured might do better than the best of a row.
    fn open(self, cell: &Cell, best: Numbers) -> bool {
        match cell {
            Cell::Bound(_) => true,
            // Fewer than one sample there are not. Fewer than others have a larger error than these, and
            // more take a longer time.
            Cell::Outside(end) if self == Self::EqualTime && end.samples <= 1.0 => false,
            Cell::Outside(end) => self.sought((end.frame, end.error)) < self.sought(best),
            Cell::Run(_) | Cell::Interpolated(_) | Cell::Missed => false,
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
    for (problem, of_both) in grouped(&candidates, Problem::of) {
        let limits = nice_numbers::spanning(of_both.iter().map(|c| question.of_run(c).0));
        let curves = Curve::all(baselines, &problem, metric);
        for ((backend, software), group) in grouped(&of_both, |r| (r.backend, r.software)) {
            let methods = grouped(&group, Run::label);
            tables.push(Table {
                question,
                metric,
                problem: problem.clone(),
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
    let standing: Vec<(usize, Numbers)> = (0..)
        .zip(&cells)
        .filter_map(|(i, cell)| Some((i, cell.numbers()?)))
        .collect();
    let of = |(_, numbers): &(usize, Numbers)| question.sought(*numbers);
    let winner = standing.iter().min_by(|a, b| of(a).total_cmp(&of(b)));
    let others = |counts: &dyn Fn(usize, Numbers) -> bool| match winner {
        None => Vec::new(),
        Some(&(winner, best)) => (0..cells.len())
            .filter(|&i| i != winner && counts(i, best))
            .collect(),
    };
    let alike = |i: usize, best| {
        let numbers = cells[i].numbers();
        numbers.is_some_and(|n| question.alike(best, n))
    };
    Row {
        limit,
        winner: winner.map(|(i, _)| *i),
        alike: others(&alike),
        open: others(&|i, best| question.open(&cells[i], best)),
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
