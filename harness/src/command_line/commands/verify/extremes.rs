//! `verify --extremes`: a table and a plot of what float32 costs where numbers are extreme.

mod plot;

use super::super::{print_json, print_line};
use super::{Variant, table, under_test};
use crate::command_line::cli::Verify;
use crate::command_line::error::CommandError;
use crate::domain::files::{FileError, write_atomically};
use crate::domain::record::Backend;
use crate::running::context::Context;
use interreflect_conformance::verify::{Extreme, Verdict, extremes};
use serde::Serialize;

/// One method at one place of an axis.
#[derive(Clone, Serialize)]
struct Row {
    estimator: &'static str,
    fidelity: Option<&'static str>,
    quantity: &'static str,
    backend: Backend,
    axis: &'static str,
    unit: &'static str,
    value: f64,
    /// Against the same formula in float64 on the same captures.
    relative_error: Option<f64>,
    /// Largest estimate over what surroundings of the greatest radiance give.
    largest: Option<f64>,
    verdict: &'static str,
    note: String,
}

/// What `verify --extremes --json` prints.
#[derive(Serialize)]
struct Extremes<'a> {
    extremes: &'a [Row],
}

pub(super) fn run(
    context: &Context,
    command: &Verify,
    methods: &[Variant],
) -> Result<(), CommandError> {
    let backends = command.backend.list();
    let bar =
        crate::command_line::progress::bar("extremes", (methods.len() * backends.len()) as u64);
    let mut rows = Vec::new();
    for (method, quantity) in methods {
        for &backend in backends {
            bar.set_message(format!("{} on {backend}", method.info().id));
            // A device that is not there, or a method without an implementation on it, has no rows.
            if let Ok(under_test) = under_test(context, command, (&**method, *quantity), backend)
                && under_test.backend.opens(&**method).is_ok()
            {
                let row = |extreme: Extreme| Row {
                    estimator: method.info().id,
                    fidelity: method.fidelity(),
                    quantity: quantity.name(),
                    backend,
                    axis: extreme.axis,
                    unit: extreme.unit,
                    value: extreme.value,
                    relative_error: extreme.relative_error,
                    largest: extreme.largest,
                    verdict: extreme.verdict.name(),
                    note: extreme.note,
                };
                rows.extend(extremes(&under_test).into_iter().map(row));
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    if let Some(folder) = &command.out {
        write_atomically(&folder.join("extremes.csv"), &csv(&rows)?)?;
        let svg = plot::svg(&rows).map_err(|e| FileError::Write {
            path: folder.join("extremes.svg"),
            source: std::io::Error::other(e),
        })?;
        write_atomically(&folder.join("extremes.svg"), svg.as_bytes())?;
    }
    match command.json {
        true => print_json(&Extremes { extremes: &rows })?,
        false => print_line(&text(&rows))?,
    }
    let failed = rows.iter().filter(|r| r.verdict == Verdict::Failed.name());
    match failed.count() {
        0 => Ok(()),
        failed => Err(CommandError::Falsified {
            failed,
            checks: rows.len(),
        }),
    }
}

fn csv(rows: &[Row]) -> Result<Vec<u8>, CommandError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).map_err(std::io::Error::from)?;
    }
    let bytes = writer.into_inner().map_err(|e| e.into_error())?;
    Ok(bytes)
}

/// For each method and backend, the worst on each axis; then what failed.
fn text(rows: &[Row]) -> String {
    let mut axes: Vec<&str> = Vec::new();
    for row in rows {
        if !axes.contains(&row.axis) {
            axes.push(row.axis);
        }
    }
    let named = axes.iter().map(|axis| axis.replace('_', "\n"));
    let mut header = vec!["estimator".to_owned(), "on".to_owned()];
    header.extend(named);
    let mut lines = table::plain(&header);
    let key = |r: &Row| (r.estimator, r.fidelity, r.backend);
    let mut keys = Vec::new();
    for row in rows {
        if !keys.contains(&key(row)) {
            keys.push(key(row));
        }
    }
    for group in keys {
        let (estimator, fidelity, backend) = group;
        let fidelity = fidelity.map(|f| format!("\n  {f}"));
        let name = estimator.to_owned() + &fidelity.unwrap_or_default();
        let mut cells = vec![name, backend.to_string()];
        let of_group: Vec<&Row> = rows.iter().filter(|r| key(r) == group).collect();
        cells.extend(axes.iter().map(|axis| worst(&of_group, axis)));
        lines.add_row(cells);
    }
    let mut text = format!(
        "largest relative error against the same formula in float64 (at which value: --out)\n{lines}"
    );
    for row in rows.iter().filter(|r| r.verdict == Verdict::Failed.name()) {
        let fidelity = row.fidelity.unwrap_or_default();
        text += &format!(
            "\nfailed: {} {fidelity} {} on {} at {} = {:e}: largest {:?}, {}",
            row.estimator, row.quantity, row.backend, row.axis, row.value, row.largest, row.note
        );
    }
    text
}

/// The largest error of a group on an axis; with a mark where something failed.
fn worst(group: &[&Row], axis: &str) -> String {
    let on_axis = || group.iter().filter(|r| r.axis == axis);
    let worst = on_axis().filter_map(|r| r.relative_error).reduce(f64::max);
    let failed = on_axis().any(|r| r.verdict == Verdict::Failed.name());
    let mark = if failed { "!" } else { "" };
    match worst {
        Some(error) => format!("{error:.0e}{mark}"),
        None if on_axis().any(|r| r.largest.is_some()) => format!("finite{mark}"),
        None if on_axis().any(|r| r.verdict == Verdict::Passed.name()) => format!("refused{mark}"),
        None => format!("–{mark}"),
    }
}
