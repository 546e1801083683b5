//! Checks as text.

use super::Record;
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, LineStyle, Table, presets};
use interreflect_conformance::verify::Verdict;

/// Width of the table where there is no terminal to ask.
const WIDTH_IN_A_PIPE: u16 = 140;

/// A line for each estimator, fidelity, quantity and backend, or for each of their checks; then what
/// failed, with the command that shows it.
pub(super) fn of(records: &[Record], detailed: bool) -> String {
    let mut text = String::new();
    let mut rest = records;
    let mut summary = plain(&[
        "estimator",
        "quantity",
        "on",
        "passed",
        "failed",
        "unclaimed",
        "falsified",
        "n/a",
    ]);
    while let Some(first) = rest.first() {
        let same = |r: &&Record| key(r) == key(first);
        let count = rest.iter().take_while(same).count();
        let (group, others) = rest.split_at(count);
        rest = others;
        if detailed {
            let (name, quantity, backend) = key(first);
            text += &format!(
                "\n{name}: {} on {backend}\n{}\n",
                quantity.replace('_', " "),
                checks(group)
            );
        } else {
            summary.add_row(line(group));
        }
    }
    if !detailed {
        text += &summary.to_string();
    }
    for record in records
        .iter()
        .filter(|r| r.verdict == Verdict::Failed.name())
    {
        let command = record.command.as_deref().unwrap_or_default();
        text += &format!("\n{}: {}\n  {command}", record.check, record.note);
    }
    text
}

fn key(record: &Record) -> (String, &'static str, String) {
    let fidelity = record.fidelity.map(|f| format!(" {f}"));
    let name = record.estimator.to_owned() + &fidelity.unwrap_or_default();
    (name, record.quantity, record.backend.to_string())
}

/// How many checks of a group came to what.
fn line(group: &[Record]) -> Vec<String> {
    let (name, quantity, backend) = key(&group[0]);
    let verdicts = [
        Verdict::Passed,
        Verdict::Failed,
        Verdict::Unclaimed,
        Verdict::UnclaimedFalsified,
        Verdict::NotApplicable,
    ];
    let count = |verdict: Verdict| {
        let with = group.iter().filter(|r| r.verdict == verdict.name());
        with.count().to_string()
    };
    let names = [name, quantity.to_owned(), backend];
    names.into_iter().chain(verdicts.map(count)).collect()
}

/// Every check of a group.
fn checks(group: &[Record]) -> Table {
    let mut table = plain(&["check", "verdict", "value", "bound", "cases", "note"]);
    for record in group {
        let number = |value: Option<f64>| value.map_or("–".into(), |v| format!("{v:.3e}"));
        table.add_row([
            record.check.to_owned(),
            record.verdict.replace('_', " "),
            number(record.value),
            number(record.bound),
            record.cases.to_string(),
            record.note.clone(),
        ]);
    }
    for (i, column) in table.column_iter_mut().enumerate() {
        if i < 5 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
        if (2..5).contains(&i) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// An empty table with a header.
pub(super) fn plain<T: ToString>(header: &[T]) -> Table {
    let mut table = Table::new();
    let rule = LineStyle::none().fill('─').junction('─');
    table.load_style(presets::NOTHING.header_separator(rule));
    table.set_content_arrangement(ContentArrangement::Dynamic);
    if !table.is_tty() {
        table.set_width(WIDTH_IN_A_PIPE);
    }
    table.set_header(header.iter().map(T::to_string));
    table
}
