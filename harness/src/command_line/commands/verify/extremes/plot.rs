//! Relative errors over each axis, both logarithmic: a panel an axis.

use super::Row;
use crate::domain::record::Backend;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;

/// Size of a panel, panels in a row, and room for the legend, in SVG units.
const PANEL: (u32, u32) = (420, 300);
const COLUMNS: u32 = 3;
const LEGEND: u32 = 60;

/// Where errors that are too small to show are drawn.
const FLOOR: f64 = 1e-9;

type Failure = Box<dyn Error + Send + Sync>;

/// The plot as an SVG. An axis of kinds instead of numbers has no panel.
pub(super) fn svg(rows: &[Row]) -> Result<String, Failure> {
    let axes = axes(rows);
    let estimators = names(rows);
    let lines = (axes.len() as u32).div_ceil(COLUMNS);
    let size = (COLUMNS * PANEL.0, lines * PANEL.1 + LEGEND);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        let (legend, panels) = root.split_vertically(LEGEND);
        draw_legend(&legend, &estimators)?;
        let areas = panels.split_evenly((lines.max(1) as usize, COLUMNS as usize));
        for (area, axis) in areas.iter().zip(&axes) {
            let on_axis: Vec<&Row> = rows.iter().filter(|r| r.axis == *axis).collect();
            panel(area, &on_axis, &estimators)?;
        }
        root.present()?;
    }
    Ok(svg)
}

/// Axes that have errors at more than a few places: those of numbers.
fn axes(rows: &[Row]) -> Vec<&str> {
    let mut axes: Vec<(&str, Vec<f64>)> = Vec::new();
    for row in rows.iter().filter(|r| r.relative_error.is_some()) {
        match axes.iter_mut().find(|(axis, _)| *axis == row.axis) {
            Some((_, values)) if !values.contains(&row.value) => values.push(row.value),
            Some(_) => {}
            None => axes.push((row.axis, vec![row.value])),
        }
    }
    let long = axes.into_iter().filter(|(_, values)| values.len() > 4);
    long.map(|(axis, _)| axis).collect()
}

fn names(rows: &[Row]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for row in rows {
        if !names.contains(&row.estimator) {
            names.push(row.estimator);
        }
    }
    names
}

fn colour(index: usize) -> RGBColor {
    let (r, g, b) = Palette99::pick(index).to_rgba().rgb();
    RGBColor(r, g, b)
}

fn draw_legend(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    estimators: &[&str],
) -> Result<(), Failure> {
    let style = |size: u32| ("sans-serif", size).into_font();
    let title = "Relative error against the same formula in float64; circles CPU, crosses GPU; \
                 filled corrected or only fidelity, open published; at the left edge: 0";
    area.draw(&Text::new(title, (10, 8), style(14)))?;
    for (i, name) in estimators.iter().enumerate() {
        let (x, y) = (10 + 205 * (i as i32 % 6), 30 + 15 * (i as i32 / 6));
        area.draw(&Circle::new((x + 4, y + 5), 4, colour(i).filled()))?;
        area.draw(&Text::new((*name).to_owned(), (x + 14, y), style(12)))?;
    }
    Ok(())
}

fn panel(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    rows: &[&Row],
    estimators: &[&str],
) -> Result<(), Failure> {
    let Some(first) = rows.first() else {
        return Ok(());
    };
    let values = || rows.iter().map(|r| r.value).filter(|v| *v > 0.0);
    let least = values().fold(f64::INFINITY, f64::min);
    let (from, to) = (least / 10.0, values().fold(0.0, f64::max) * 3.0);
    let unit = match first.unit {
        "" => String::new(),
        unit => format!(" / {unit}"),
    };
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption(format!("{}{unit}", first.axis), ("sans-serif", 15))
        .x_label_area_size(26)
        .y_label_area_size(52)
        .build_cartesian_2d(
            (from / 3.0..to).log_scale(),
            (FLOOR / 3.0..10.0).log_scale(),
        )?;
    let power = |v: &f64| format!("{v:.0e}");
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .x_labels(7)
        .y_labels(6)
        .x_label_formatter(&power)
        .y_label_formatter(&power)
        .draw()?;
    for row in rows {
        let Some(error) = row.relative_error else {
            continue;
        };
        let index = estimators.iter().position(|name| *name == row.estimator);
        let colour = colour(index.unwrap_or(0));
        let place = (row.value.max(from), error.clamp(FLOOR, 5.0));
        let open = row.fidelity == Some("published");
        let style = if open {
            colour.stroke_width(1)
        } else {
            colour.filled()
        };
        match row.backend {
            Backend::Cpu => chart.draw_series([Circle::new(place, 3, style)])?,
            Backend::Gpu => chart.draw_series([Cross::new(place, 3, style)])?,
        };
    }
    Ok(())
}
