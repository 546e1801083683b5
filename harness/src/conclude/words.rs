//! Conclusions as text for the terminal.

use super::{
    Advice, Answer, Budget, Cell, Choice, Conclusions, Floor, FrameTime, Front, Measured, Metric,
    Numbers, Question, Row, Standing, Table,
};
use crate::{format, table};
use std::fmt::Write as _;

/// Limits beside each other; more start a new table.
const LIMITS_ABREAST: usize = 7;

impl Conclusions {
    /// All of them, by kind. `width` is in characters; `None` takes the terminal's, or 120 where there is
    /// none.
    pub fn words(&self, width: Option<u16>) -> String {
        let mut text = String::new();
        for front in &self.fronts {
            text += &front.words(self.metric, width);
        }
        for table in self.equal_time.iter().chain(&self.equal_error) {
            text += &table.words(width);
        }
        text += &floors_in_words(&self.floors, self.metric, width);
        with_notes(text)
    }
}

/// Answers one after the other.
pub fn advice_in_words(advice: &[Advice]) -> String {
    with_notes(advice.iter().map(Advice::words).collect())
}

/// Marks with what they mean.
const NOTES: [(&[&str], &str); 7] = [
    (&["* "], "*: the best within this limit\n"),
    (&["≈ "], "≈: can't be told apart from the best\n"),
    (
        &["? "],
        "?: might be better, with a sample count that was not measured\n",
    ),
    (
        &[" < "],
        "<: this or better; it is the end of the sample counts that were measured\n",
    ),
    (
        &["n<", "n>"],
        "n<, n>: would take fewer or more samples than were measured; nothing is extrapolated\n",
    ),
    (&[" sw"], table::SOFTWARE),
    (&["≲ "], table::UPPER_BOUND),
];

/// Explains the marks that a text has.
fn with_notes(text: String) -> String {
    let has = |marks: &[&str]| marks.iter().any(|m| text.contains(m));
    let of_text = NOTES.iter().filter(|(marks, _)| has(marks));
    let notes: String = of_text.map(|(_, note)| *note).collect();
    match notes.is_empty() {
        true => text,
        false => format!("{text}\n{notes}"),
    }
}

impl Front {
    fn words(&self, metric: Metric, width: Option<u16>) -> String {
        let mut rows = table::plain(width);
        rows.set_header(["run", "place", "on", "frame ms", "error"]);
        let mut add = |standing: &Standing, place: &str| {
            let choice = &standing.choice;
            rows.add_row([
                choice.label(),
                place.into(),
                table::device(choice.backend, choice.software),
                time(choice.frame),
                error(choice.error),
            ]);
        };
        for member in &self.members {
            let place = match member.certain() {
                true => "front",
                false => "front, inside the noise",
            };
            add(member, place);
        }
        for contender in &self.contenders {
            add(contender, "behind it, inside the noise");
        }
        table::align(&mut rows, 3);
        format!("\n{}: front of {metric} and time\n{rows}\n", self.place)
    }
}

impl Table {
    fn words(&self, width: Option<u16>) -> String {
        let (asked, unit) = match self.question {
            Question::EqualTime => (format!("{} within a frame's ms", self.metric), " ms"),
            Question::EqualError => (format!("frame ms up to {}", self.metric), ""),
        };
        let device = table::device(self.backend, self.software);
        let place = &self.place;
        let mut text = format!("\n{place} on {device}: {asked}\n");
        for rows in self.rows.chunks(LIMITS_ABREAST) {
            let _ = writeln!(text, "{}", self.abreast(rows, width));
        }
        let mut last = None;
        for row in &self.rows {
            let words = self.winner(row);
            if words.is_some() && words != last {
                let words = words.as_deref().unwrap_or_default();
                let _ = writeln!(text, "  ≤ {}{unit}: {words}", format::number(row.limit));
            }
            last = words;
        }
        text
    }

    /// Contestants below, limits beside each other.
    fn abreast(&self, rows: &[Row], width: Option<u16>) -> comfy_table::Table {
        let mut abreast = table::plain(width);
        let limits = rows
            .iter()
            .map(|r| format!("≤ {}", format::number(r.limit)));
        abreast.set_header([String::new()].into_iter().chain(limits));
        for (i, contestant) in self.contestants.iter().enumerate() {
            let name = match contestant.baseline {
                Some(_) if self.backend != crate::record::Backend::Cpu => {
                    format!("{} on cpu", contestant.name)
                }
                _ => contestant.name.clone(),
            };
            let cells = rows.iter().map(|row| {
                let mark = match row.winner {
                    Some(winner) if winner == i => "* ",
                    _ if row.alike.contains(&i) => "≈ ",
                    _ if row.open.contains(&i) => "? ",
                    _ => "",
                };
                format!("{mark}{}", self.cell(&row.cells[i]))
            });
            abreast.add_row([name].into_iter().chain(cells));
        }
        table::align(&mut abreast, 1);
        abreast
    }

    fn cell(&self, cell: &Cell) -> String {
        let sought = |(frame, found): Numbers| match self.question {
            Question::EqualTime => error(found),
            Question::EqualError => format::number(frame.ms),
        };
        match (cell, cell.numbers()) {
            (Cell::Bound(_), Some(numbers)) => format!("< {}", sought(numbers)),
            (_, Some(numbers)) => sought(numbers),
            (Cell::Outside(end), _) => match self.question {
                Question::EqualTime => format!("n<{}", end.samples),
                Question::EqualError => format!("n>{}", end.samples),
            },
            (_, None) => "–".into(),
        }
    }

    /// The best of a row with its parameters, and who can't be told apart from it.
    fn winner(&self, row: &Row) -> Option<String> {
        let winner = row.winner?;
        let mut words = match &row.cells[winner] {
            Cell::Run(choice) => choice.label(),
            Cell::Interpolated(at) | Cell::Bound(at) => {
                let samples = format::number(at.samples);
                format!("{}, n = {samples}", self.contestants[winner].name)
            }
            Cell::Outside(_) | Cell::Missed => return None,
        };
        let alike = row.alike.iter().map(|&i| self.contestants[i].name.as_str());
        let alike: Vec<&str> = alike.collect();
        if !alike.is_empty() {
            let _ = write!(words, "; within noise of {}", alike.join("; "));
        }
        Some(words)
    }
}

fn floors_in_words(floors: &[Floor], metric: Metric, width: Option<u16>) -> String {
    let mut text = String::new();
    for group in floors.chunk_by(|a, b| a.place == b.place) {
        let mut rows = table::plain(width);
        rows.set_header(["soonest at", "floor", "on", "frame ms", "least error"]);
        for floor in group {
            rows.add_row([
                floor.soonest.label(),
                if floor.reached { "reached" } else { "open" }.into(),
                table::device(floor.least.backend, floor.least.software),
                time(floor.soonest.frame),
                error(floor.least.error),
            ]);
        }
        table::align(&mut rows, 3);
        let place = &group[0].place;
        let _ = writeln!(text, "\n{place}: floor of {metric}\n{rows}");
        if group.iter().any(|f| !f.reached) {
            text += "  open: nothing slower was measured; more time may lower it\n";
        }
    }
    text
}

impl Advice {
    fn words(&self) -> String {
        let device = table::device(self.backend, self.software);
        let place = &self.place;
        let mut text = format!("\n{place} on {device}, {}\n", self.budget);
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
                    text += "    a limit is inside its noise\n";
                }
                if !alike.is_empty() {
                    let _ = writeln!(text, "    within noise of {}", named(alike));
                }
            }
            Answer::Nothing { by_time, by_error } => {
                line(by_time, "nothing does; nearest: ");
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

/// A time, with its interval where there is one.
fn time(frame: FrameTime) -> String {
    let ms = format::number(frame.ms);
    let (low, high) = (format::number(frame.low), format::number(frame.high));
    match low == high {
        true => ms,
        false => format!("{ms} ({low}–{high})"),
    }
}

fn error(measured: Measured) -> String {
    format::error(measured.value, measured.conclusive)
}
