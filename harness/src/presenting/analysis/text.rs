//! Conclusions as text for the terminal.

use super::Sheet;
use super::notes::notes;
use super::tables::{error, time};
use crate::domain::analysis::{Advice, Answer, Budget, Choice, Conclusions};
use crate::domain::format;
use crate::presenting::terminal;
use std::fmt::Write as _;

/// Columns of numbers beside each other; more start a new table.
const ABREAST: usize = 7;

impl Conclusions {
    /// All of them, by kind. `width` is in characters; `None` takes the terminal's, or 120 where there is
    /// none.
    pub fn text(&self, width: Option<u16>) -> String {
        with_notes(in_text(&self.sheets(), width))
    }
}

/// Tables one after the other.
fn in_text(sheets: &[Sheet], width: Option<u16>) -> String {
    let mut text = String::new();
    for Sheet {
        problem,
        table,
        numbers,
    } in sheets
    {
        let _ = writeln!(text, "\n{problem}{}", table.caption);
        let (names, cells) = table.head.split_at(*numbers);
        for (i, abreast) in cells.chunks(ABREAST).enumerate() {
            let from = numbers + i * ABREAST;
            let mut sheet = terminal::plain(width);
            sheet.set_header(names.iter().chain(abreast));
            for row in &table.rows {
                sheet.add_row(
                    row[..*numbers]
                        .iter()
                        .chain(&row[from..from + abreast.len()]),
                );
            }
            terminal::align(&mut sheet, *numbers);
            let _ = writeln!(text, "{sheet}");
        }
        for line in table.note.lines() {
            let _ = writeln!(text, "  {line}");
        }
    }
    text
}

/// Answers one after the other.
pub fn advice_in_text(advice: &[Advice]) -> String {
    with_notes(advice.iter().map(Advice::text).collect())
}

fn with_notes(text: String) -> String {
    let notes = notes(&text);
    match notes.is_empty() {
        true => text,
        false => format!("{text}\n{notes}"),
    }
}

impl Advice {
    fn text(&self) -> String {
        let device = terminal::device(self.backend, self.software);
        let problem = &self.problem;
        let mut text = format!("\n{problem} on {device}, {}\n", self.budget);
        let metric = self.budget.metric;
        let mut line = |choice: &Choice, before: &str| {
            let (frame, error) = (time(choice.frame), error(choice.error));
            let label = choice.label();
            let _ = writeln!(text, "  {before}{label}: {frame} ms, {metric} {error}");
            let _ = writeln!(text, "    {}", choice.options);
        };
        match &self.answer {
            Answer::Use {
                choice,
                sure,
                alike,
            } => {
                line(choice, "");
                if !sure {
                    text += "    the result lies within noise of the limit\n";
                }
                if !alike.is_empty() {
                    let _ = writeln!(text, "    within noise of {}", named(alike));
                }
            }
            Answer::Nothing { by_time, by_error } => {
                line(by_time, "no run is within the limits; nearest: ");
                if by_error != by_time {
                    line(by_error, "or: ");
                }
            }
        }
        text
    }
}

impl std::fmt::Display for Budget {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ms = self
            .ms
            .map(|ms| format!("at most {} ms", format::number(ms)));
        let error = self
            .max_error
            .map(|e| format!("error at most {}", format::number(e)));
        let limits: Vec<String> = ms.into_iter().chain(error).collect();
        match limits.is_empty() {
            true => f.write_str("most accurate"),
            false => f.write_str(&limits.join(", ")),
        }
    }
}

/// Runs on a line: the best of each method, then how many more there are.
fn named(choices: &[Choice]) -> String {
    let method = |c: &Choice| (c.estimator.clone(), c.fidelity.clone());
    let mut seen = Vec::new();
    let first = choices.iter().filter(|c| {
        let new = !seen.contains(&method(c));
        seen.push(method(c));
        new
    });
    let mut names: Vec<String> = first.map(Choice::label).collect();
    let more = choices.len() - names.len();
    if more > 0 {
        names.push(format!("{more} more of these"));
    }
    names.join("; ")
}
