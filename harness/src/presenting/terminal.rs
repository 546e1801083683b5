//! Runs as a table on the terminal.

use crate::domain::format;
use crate::domain::record::{Backend, Comparison, Run};
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, LineStyle, Table, presets};

/// Width of the table where there is no terminal to ask.
const WIDTH_IN_A_PIPE: u16 = 120;

/// A table of runs, grouped by scene and quantity, followed by what was skipped and why.
///
/// `width` is in characters; `None` takes the terminal's, or 120 where there is none.
pub fn runs(runs: &[Run], width: Option<u16>) -> String {
    let mut text = String::new();
    let mut groups: Vec<(&str, &str)> = Vec::new();
    for run in runs {
        let group = (run.scene.as_str(), run.quantity.as_str());
        if !groups.contains(&group) {
            groups.push(group);
        }
    }
    for (scene, quantity) in groups {
        let of_group = || {
            runs.iter()
                .filter(move |r| r.scene == scene && r.quantity == quantity)
        };
        let ran: Vec<&Run> = of_group().filter(|r| r.skipped.is_none()).collect();
        let points = ran
            .first()
            .map_or(String::new(), |r| format!(", {} points", r.points));
        text += &format!("\n{scene}: {}{points}\n", quantity.replace('_', " "));
        if !ran.is_empty() {
            text += &format!("{}\n", table(&ran, width));
        }
        for run in of_group() {
            if let Some(reason) = &run.skipped {
                text += &format!("  {} on {} skipped: {reason}\n", run.estimator, run.backend);
            }
        }
    }
    text + &notes(runs)
}

/// A table without lines but the one under its header.
///
/// `width` is in characters; `None` takes the terminal's, or 120 where there is none.
pub(crate) fn plain(width: Option<u16>) -> Table {
    let mut table = Table::new();
    let rule = LineStyle::none().fill('─').junction('─');
    table.load_style(presets::NOTHING.header_separator(rule));
    table.set_content_arrangement(ContentArrangement::Dynamic);
    if let Some(width) = width {
        table.set_width(width);
    } else if !table.is_tty() {
        table.set_width(WIDTH_IN_A_PIPE);
    }
    table
}

/// Columns of numbers to the right, from this one on. Only the first column gives way on a narrow
/// terminal: a broken number can't be read.
pub(crate) fn align(table: &mut Table, first_number: usize) {
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 1));
        if i >= 1 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
        if i >= first_number {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
}

fn table(runs: &[&Run], width: Option<u16>) -> Table {
    let mut table = plain(width);
    let solved = runs.iter().any(|r| r.phases_ms.solve.is_some());
    table.set_header(HEADER.iter().filter(|h| solved || **h != SOLVE));
    for run in runs {
        table.add_row(row(run, solved));
    }
    align(&mut table, 2);
    table
}

/// A column that is there only if some run has this phase.
const SOLVE: &str = "solve\nms";

const HEADER: [&str; 11] = [
    "estimator",
    "on",
    SOLVE,
    "capture\nms",
    "compile\nms",
    "prepare\nms",
    "shade\nms",
    "readback\nms",
    "own model\nrelMSE",
    "truth\nrelMSE",
    "energy\nratio",
];

fn row(run: &Run, solved: bool) -> Vec<String> {
    let relmse = |c: &Option<Comparison>| c.as_ref().map_or_else(|| "–".into(), format::relmse);
    let judged = run.truth.as_ref().or(run.own_model.as_ref());
    let mut cells = vec![run.label(), device(run.backend, run.software)];
    cells.extend(
        run.phases_ms
            .named()
            .iter()
            .filter(|(name, _)| solved || *name != "solve")
            .map(|(_, t)| format::optional(t.map(|t| t.median))),
    );
    cells.extend([relmse(&run.own_model), relmse(&run.truth)]);
    cells.push(format::optional(judged.and_then(|c| c.energy_ratio)));
    cells
}

/// A backend in a table, with a mark if it was a software adapter that [`SOFTWARE`] explains.
pub(crate) fn device(backend: Backend, software: bool) -> String {
    match software {
        true => format!("{backend} sw"),
        false => backend.to_string(),
    }
}

/// What is said under a table with a software adapter's times.
pub(crate) const SOFTWARE: &str =
    "sw: software adapter, runs on the CPU; its times say nothing about a GPU\n";

/// What is said under a table with upper bounds.
pub(crate) const UPPER_BOUND: &str = "≲: an upper bound, within the reference's noise\n";

fn notes(runs: &[Run]) -> String {
    let mut notes = String::new();
    if runs.iter().any(|r| r.software) {
        notes += SOFTWARE;
    }
    let inconclusive = |c: &Comparison| c.verdict == crate::domain::record::Verdict::Inconclusive;
    if runs
        .iter()
        .flat_map(|r| r.own_model.iter().chain(&r.truth))
        .any(inconclusive)
    {
        notes += UPPER_BOUND;
    }
    let frames = || runs.iter().filter_map(|r| r.phases_ms.frame());
    let unsettled = frames().filter(|t| t.settled == Some(false)).count();
    if unsettled > 0 {
        let all = frames().count();
        notes += &format!("{unsettled} of {all} frame times did not settle; raise --patience\n");
    }
    if notes.is_empty() {
        notes
    } else {
        format!("\n{notes}")
    }
}

#[cfg(test)]
mod tests;
