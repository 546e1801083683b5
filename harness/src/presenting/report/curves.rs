//! Curves over a parameter: what happens to error and time where runs differ in nothing else.

use super::mark::{Mark, Numbered};
use super::plot::{Axis, Chart, Failure, Ink, draw};
use crate::domain::record::{Comparison, ParamMap, ParamValue, Run, Verdict};
use crate::presenting::error::PresentError;
use plotters::prelude::*;
use serde::Serialize;

/// Size of a panel in SVG units.
const SIZE: (u32, u32) = (440, 320);

/// All curves over one parameter.
#[derive(Serialize)]
pub(super) struct Curves {
    parameter: String,
    width: u32,
    height: u32,
    panels: Vec<Panel>,
    /// Whether a time is a software adapter's.
    software: bool,
}

/// Curves of one number.
#[derive(Serialize)]
struct Panel {
    what: &'static str,
    svg: String,
    marks: Vec<Mark>,
}

/// Runs that differ in one parameter only, in the order of its values.
struct Line<'a>(Vec<(f64, &'a Numbered<'a>)>);

/// What a panel shows of a run, and whether the number can be trusted.
type Number = fn(&Run) -> Option<(f64, bool)>;

/// Curves for each numeric parameter in which some runs differ and agree in the rest.
pub(super) fn curves(runs: &[Numbered<'_>]) -> Result<Vec<Curves>, PresentError> {
    let mut names: Vec<&str> = Vec::new();
    for (name, value) in runs.iter().flat_map(|r| &r.run.params.0) {
        if number(value).is_some() && !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let mut found = Vec::new();
    for parameter in names {
        let lines = lines(runs, parameter);
        if !lines.is_empty() {
            found.push(Curves {
                parameter: parameter.into(),
                width: SIZE.0,
                height: SIZE.1,
                panels: panels(&lines, parameter)?,
                software: lines.iter().flat_map(|l| &l.0).any(|(_, r)| r.run.software),
            });
        }
    }
    Ok(found)
}

/// Runs of one method and backend that agree in all but `parameter`, where at least two values of it
/// occur.
fn lines<'a>(runs: &'a [Numbered<'a>], parameter: &str) -> Vec<Line<'a>> {
    let rest = |run: &Run| -> ParamMap {
        let others = run.params.0.iter().filter(|(name, _)| name != parameter);
        ParamMap(others.cloned().collect())
    };
    let mut groups: Vec<(&Run, ParamMap, Line<'a>)> = Vec::new();
    for of in runs.iter().filter(|r| r.run.skipped.is_none()) {
        let Some(value) = of.run.params.get(parameter).and_then(number) else {
            continue;
        };
        let others = rest(of.run);
        let same = |(first, params, _): &&mut (&Run, ParamMap, Line<'_>)| {
            first.label() == of.run.label() && first.backend == of.run.backend && *params == others
        };
        match groups.iter_mut().find(same) {
            Some((_, _, line)) => line.0.push((value, of)),
            None => groups.push((of.run, others, Line(vec![(value, of)]))),
        }
    }
    let mut lines: Vec<_> = groups.into_iter().map(|(_, _, line)| line).collect();
    for line in &mut lines {
        line.0.sort_by(|a, b| a.0.total_cmp(&b.0));
        line.0.dedup_by(|a, b| a.0 == b.0);
    }
    lines.retain(|line| line.0.len() > 1);
    lines
}

fn number(value: &ParamValue) -> Option<f64> {
    match value {
        ParamValue::U32(v) => Some(f64::from(*v)),
        ParamValue::F32(v) => Some(f64::from(*v)),
        ParamValue::Bool(_) | ParamValue::Name(_) => None,
    }
}

fn relmse(comparison: Option<&Comparison>) -> Option<(f64, bool)> {
    let comparison = comparison?;
    let error = comparison.relmse.filter(|e| *e > 0.0)?;
    Some((error, comparison.verdict == Verdict::Conclusive))
}

fn panels(lines: &[Line<'_>], parameter: &str) -> Result<Vec<Panel>, PresentError> {
    let truth: Number = |run| relmse(run.truth.as_ref());
    let own: Number = |run| relmse(run.own_model.as_ref());
    let time: Number = |run| {
        let frame = run.phases_ms.frame_ms().filter(|t| *t > 0.0);
        frame.map(|t| (t, true))
    };
    let all: [(&'static str, Number); 3] = [
        ("relMSE against the truth", truth),
        ("relMSE against the own model", own),
        ("capture + prepare + shade, ms", time),
    ];
    let drawn = all
        .into_iter()
        .map(|(what, number)| panel(lines, parameter, what, number));
    let drawn: Result<Vec<_>, _> = drawn.collect();
    Ok(drawn?.into_iter().flatten().collect())
}

fn panel(
    lines: &[Line<'_>],
    parameter: &str,
    what: &'static str,
    number: Number,
) -> Result<Option<Panel>, PresentError> {
    let points = || lines.iter().flat_map(|l| &l.0);
    let shown = || points().filter_map(|(_, of)| number(of.run));
    if shown().next().is_none() {
        return Ok(None);
    }
    let mut values: Vec<f64> = points().map(|(value, _)| *value).collect();
    values.sort_by(f64::total_cmp);
    let (x, y) = (Axis::at_values(&values), Axis::log(shown().map(|(v, _)| v)));
    let (svg, marks) = draw(SIZE, [&x, &y], [parameter, what], |chart| {
        let mut marks = Vec::new();
        for line in lines {
            marks.extend(content(chart, line, number)?);
        }
        Ok(marks)
    })?;
    Ok(Some(Panel { what, svg, marks }))
}

/// A line; dashed where the method is as published, so that it can be told from its correction.
fn content(
    chart: &mut Chart<'_, '_>,
    line: &Line<'_>,
    number: Number,
) -> Result<Vec<Mark>, Failure> {
    let place = |(value, of): &(f64, &Numbered<'_>)| {
        let (shown, _) = number(of.run)?;
        Some((*value, shown))
    };
    let places: Vec<_> = line.0.iter().filter_map(place).collect();
    let first = line.0.first();
    let colour = Ink::Hue(first.map_or(0, |(_, of)| of.hue)).colour();
    let published = first.is_some_and(|(_, of)| of.run.fidelity.as_deref() == Some("published"));
    if published {
        chart.draw_series(DashedLineSeries::new(places, 6, 4, colour.into()))?;
    } else {
        chart.draw_series(LineSeries::new(places, colour.stroke_width(2)))?;
    }
    let mark = |(value, of): &(f64, &Numbered<'_>)| {
        let (shown, conclusive) = number(of.run)?;
        let at = chart.backend_coord(&(*value, shown));
        Some(Mark::new(at, of, conclusive))
    };
    Ok(line.0.iter().filter_map(mark).collect())
}
