//! Runs as plots and tables know them, and the marks that stand for them.

use crate::domain::record::{Backend, Phases, Run};
use serde::Serialize;

/// A run in a plot: a mark that leads to its image.
#[derive(Clone, Serialize)]
pub(super) struct Mark {
    x: i32,
    y: i32,
    /// Number of the run in the report, from 1.
    number: usize,
    label: String,
    hue: usize,
    gpu: bool,
    software: bool,
    conclusive: bool,
    /// Whether its number is written beside it.
    pub(super) named: bool,
}

impl Mark {
    /// A mark at a place in SVG units.
    pub(super) fn new((x, y): (i32, i32), of: &Numbered<'_>, conclusive: bool) -> Self {
        Self {
            x,
            y,
            number: of.number,
            label: of.label.clone(),
            hue: of.hue,
            gpu: of.run.backend == Backend::Gpu,
            software: of.run.software,
            conclusive,
            named: false,
        }
    }

    /// Whether the number of this mark would cover another's.
    pub(super) fn hides(&self, other: &Self) -> bool {
        (self.x - other.x).abs() < 22 && (self.y - other.y).abs() < 13
    }
}

/// A run with what plots and tables call it.
#[derive(Clone)]
pub(super) struct Numbered<'a> {
    /// Its number in the report, from 1.
    pub(super) number: usize,
    /// The run.
    pub(super) run: &'a Run,
    /// Method, backend, and the parameters that tell it from others of the method.
    pub(super) label: String,
    /// Backend, and those parameters.
    pub(super) variant: String,
    /// Its estimator's hue.
    pub(super) hue: usize,
}

impl Numbered<'_> {
    /// The parameters that tell it from others of the method; empty where none does.
    pub(super) fn varied(&self) -> &str {
        self.variant
            .split_once(", ")
            .map_or("", |(_, params)| params)
    }
}

/// Least and greatest time of a frame in milliseconds, the ends of its median's 95 % interval; `None` if
/// nothing was shaded.
pub(super) fn frame_interval_ms(phases: &Phases) -> Option<[f64; 2]> {
    phases.frame().map(|frame| [frame.low, frame.high])
}
