//! The trade itself: time of a frame against error, both logarithmic, and what no other run betters.

use super::mark::{Mark, Numbered, frame_interval_ms};
use super::plot::{Axis, Chart, Failure, Ink, draw};
use crate::domain::record::{Backend, Comparison, Verdict};
use crate::presenting::error::PresentError;
use plotters::prelude::*;
use serde::Serialize;
use std::ops::Range;

/// Size in SVG units.
const SIZE: (u32, u32) = (560, 420);

/// Most runs whose numbers are all written; of more, only those that no other run betters.
const NAMED: usize = 24;

/// A plot of a section's runs.
#[derive(Serialize)]
pub(super) struct Plot {
    width: u32,
    height: u32,
    svg: String,
    /// What the vertical axis shows.
    error_of: &'static str,
    marks: Vec<Mark>,
    /// Runs without a time or an error above 0, which no logarithmic axis can show.
    left_out: usize,
    /// Whether some time was measured more than once.
    intervals: bool,
}

/// A run where the plot has it.
struct PlotPoint<'a> {
    of: &'a Numbered<'a>,
    time: f64,
    interval: [f64; 2],
    error: f64,
    comparison: &'a Comparison,
}

impl Plot {
    /// The plot; `None` if there are fewer than two points to show. The error is the truth's, or the
    /// own model's where no run has a truth.
    pub(super) fn of(runs: &[Numbered<'_>]) -> Result<Option<Self>, PresentError> {
        let has_truth = runs.iter().any(|r| r.run.truth.is_some());
        let points: Vec<_> = runs.iter().filter_map(|of| point(of, has_truth)).collect();
        if points.len() < 2 {
            return Ok(None);
        }
        let error_of = if has_truth {
            "the truth"
        } else {
            "the own model"
        };
        let floor = noise_floor(&points);
        let times = Axis::log(points.iter().flat_map(|p| [p.interval[0], p.interval[1]]));
        let errors = Axis::log(points.iter().map(|p| p.error).chain(floor));
        let y_title = format!("relMSE against {error_of}");
        let titles = ["capture + prepare + shade, ms", y_title.as_str()];
        let (svg, mut marks) = draw(SIZE, [&times, &errors], titles, |chart| {
            content(chart, &points, &times, floor)
        })?;
        name(&mut marks, &points);
        Ok(Some(Self {
            width: SIZE.0,
            height: SIZE.1,
            svg,
            error_of,
            intervals: points.iter().any(|p| p.interval[0] < p.interval[1]),
            left_out: runs.iter().filter(|r| r.run.skipped.is_none()).count() - marks.len(),
            marks,
        }))
    }
}

fn point<'a>(of: &'a Numbered<'a>, has_truth: bool) -> Option<PlotPoint<'a>> {
    let comparison = if has_truth {
        &of.run.truth
    } else {
        &of.run.own_model
    };
    let comparison = comparison.as_ref()?;
    let error = comparison.relmse.filter(|e| *e > 0.0)?;
    let time = of.run.phases_ms.frame_ms().filter(|t| *t > 0.0)?;
    let [low, high] = frame_interval_ms(&of.run.phases_ms)?;
    Some(PlotPoint {
        of,
        time,
        // A spread as wide as the time itself would leave the axis.
        interval: [low.max(0.1 * time), high],
        error,
        comparison,
    })
}

/// Has numbers written where there is room: those of the fronts first.
fn name(marks: &mut [Mark], points: &[PlotPoint<'_>]) {
    let mut order: Vec<usize> = fronts(points).into_iter().flatten().collect();
    if points.len() <= NAMED {
        order.extend(0..points.len());
    }
    for i in order {
        let free = |other: &Mark| !other.named || !other.hides(&marks[i]);
        marks[i].named |= marks.iter().all(free);
    }
}

/// The largest noise floor: below it no run's error can be told.
fn noise_floor(points: &[PlotPoint<'_>]) -> Option<f64> {
    let floors = points.iter().filter_map(|p| p.comparison.noise_floor);
    floors.filter(|f| *f > 0.0).max_by(f64::total_cmp)
}

/// Indices of the runs that no other of their backend betters in time and error, from the fastest; the
/// CPU's and the GPU's apart, since a time on the one says nothing about the other.
fn fronts(points: &[PlotPoint<'_>]) -> [Vec<usize>; 2] {
    [Backend::Cpu, Backend::Gpu].map(|backend| {
        let on_backend = |i: &usize| points[*i].of.run.backend == backend;
        let mut order: Vec<usize> = (0..points.len()).filter(on_backend).collect();
        order.sort_by(|a, b| {
            let (a, b) = (&points[*a], &points[*b]);
            a.time.total_cmp(&b.time).then(a.error.total_cmp(&b.error))
        });
        let mut best = f64::INFINITY;
        order.retain(|i| {
            let better = points[*i].error < best;
            best = best.min(points[*i].error);
            better
        });
        order
    })
}

fn content(
    chart: &mut Chart<'_, '_>,
    points: &[PlotPoint<'_>],
    times: &Axis,
    floor: Option<f64>,
) -> Result<Vec<Mark>, Failure> {
    let Range {
        start: left,
        end: right,
    } = times.range();
    if let Some(floor) = floor {
        let line = [left, right].map(|x| (x, floor));
        chart.draw_series(DashedLineSeries::new(line, 3, 4, Ink::Text.colour().into()))?;
        let words = ("sans-serif", 13).into_font().color(&Ink::Text.colour());
        let at = (left, floor);
        let text = EmptyElement::at(at) + Text::new("noise floor", (4, -15), words);
        chart.draw_series([text])?;
    }
    for front in fronts(points) {
        let mut steps: Vec<(f64, f64)> = Vec::new();
        for point in front.iter().map(|i| &points[*i]) {
            let (x, y) = (point.time, point.error);
            if let Some((_, before)) = steps.last().copied() {
                steps.push((x, before));
            }
            steps.push((x, y));
        }
        chart.draw_series(LineSeries::new(steps, Ink::Text.colour().mix(0.45)))?;
    }
    for point in points {
        let y = point.error;
        let bar = point.interval.map(|t| (t, y));
        chart.draw_series(LineSeries::new(bar, Ink::Hue(point.of.hue).colour()))?;
    }
    let mark = |p: &PlotPoint<'_>| {
        let at = chart.backend_coord(&(p.time, p.error));
        Mark::new(at, p.of, p.comparison.verdict == Verdict::Conclusive)
    };
    Ok(points.iter().map(mark).collect())
}
