//! Conclusions as tables of words and numbers, for the terminal and the report alike.

use super::notes::notes;
use crate::domain::analysis::{
    Cell, Conclusions, Floor, FrameTime, Front, Measured, Metric, Numbers, Problem, Question, Row,
    Standing, Table,
};
use crate::domain::format;
use crate::presenting::{table, terminal};
use std::fmt::Write as _;

/// A table of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// Where its runs took place.
    pub problem: Problem,
    /// What it says.
    pub table: table::Table,
    /// Number of the first column of numbers.
    pub numbers: usize,
}

impl Conclusions {
    /// All of them, by kind.
    pub fn sheets(&self) -> Vec<Sheet> {
        let fronts = self.fronts.iter().map(|front| front.sheet(self.metric));
        let equal = self
            .equal_time
            .iter()
            .chain(&self.equal_error)
            .map(Table::sheet);
        let floors = self.floors.chunk_by(|a, b| a.problem == b.problem);
        let floors = floors.map(|group| floor_sheet(group, self.metric));
        fronts.chain(equal).chain(floors).collect()
    }

    /// The tables of each scene and quantity, with what their marks mean.
    pub fn tables(&self) -> Vec<table::Tables> {
        let of_sheet = |mut sheet: Sheet| {
            let cells: String = sheet
                .table
                .rows
                .iter()
                .flatten()
                .map(|c| format!("{c} "))
                .collect();
            let marks = notes(&cells);
            if !sheet.table.note.is_empty() && !marks.is_empty() {
                sheet.table.note += "\n";
            }
            sheet.table.note += marks.trim_end();
            sheet.table.caption = capitalised(sheet.table.caption.trim_start_matches([':', ' ']));
            table::Tables {
                scene: sheet.problem.scene,
                quantity: sheet.problem.quantity,
                tables: vec![sheet.table],
            }
        };
        self.sheets().into_iter().map(of_sheet).collect()
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

impl Front {
    fn sheet(&self, metric: Metric) -> Sheet {
        let row = |standing: &Standing, place: &str| {
            let choice = &standing.choice;
            vec![
                choice.label(),
                place.into(),
                terminal::device(choice.backend, choice.software),
                time(choice.frame),
                error(choice.error),
            ]
        };
        let members = self.members.iter().map(|member| match member.certain() {
            true => row(member, "front"),
            false => row(member, "front (within noise)"),
        });
        let contenders = self.contenders.iter();
        let contenders = contenders.map(|c| row(c, "possible front (within noise)"));
        Sheet {
            problem: self.problem.clone(),
            table: table::Table {
                caption: format!(": front of {metric} and time"),
                head: words(["run", "place", "on", "frame ms", "error"]),
                rows: members.chain(contenders).collect(),
                note: String::new(),
            },
            numbers: 3,
        }
    }
}

fn words<const N: usize>(words: [&str; N]) -> Vec<String> {
    words.map(String::from).into()
}

impl Table {
    /// Contestants below, limits beside each other.
    fn sheet(&self) -> Sheet {
        let (asked, unit) = match self.question {
            Question::EqualTime => (format!("{} within a frame's ms", self.metric), " ms"),
            Question::EqualError => (format!("frame ms up to {}", self.metric), ""),
        };
        let limits = self
            .rows
            .iter()
            .map(|r| format!("≤ {}", format::number(r.limit)));
        let mut note = String::new();
        let mut last = None;
        for row in &self.rows {
            let words = self.winner(row);
            if words.is_some() && words != last {
                let words = words.as_deref().unwrap_or_default();
                let _ = writeln!(note, "≤ {}{unit}: {words}", format::number(row.limit));
            }
            last = words;
        }
        let device = terminal::device(self.backend, self.software);
        Sheet {
            problem: self.problem.clone(),
            table: table::Table {
                caption: format!(" on {device}: {asked}"),
                head: std::iter::once(String::new()).chain(limits).collect(),
                rows: (0..self.contestants.len()).map(|i| self.row(i)).collect(),
                note: note.trim_end().into(),
            },
            numbers: 1,
        }
    }

    /// A contestant and what it reaches within each limit.
    fn row(&self, contestant: usize) -> Vec<String> {
        let named = &self.contestants[contestant];
        let name = match named.baseline {
            Some(_) if self.backend != crate::domain::record::Backend::Cpu => {
                format!("{} on cpu", named.name)
            }
            _ => named.name.clone(),
        };
        let cells = self.rows.iter().map(|row| {
            let mark = match row.winner {
                Some(winner) if winner == contestant => "* ",
                _ if row.alike.contains(&contestant) => "≈ ",
                _ if row.open.contains(&contestant) => "? ",
                _ => "",
            };
            format!("{mark}{}", self.cell(&row.cells[contestant]))
        });
        std::iter::once(name).chain(cells).collect()
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

fn floor_sheet(floors: &[Floor], metric: Metric) -> Sheet {
    let row = |floor: &Floor| {
        vec![
            floor.soonest.label(),
            if floor.reached { "reached" } else { "open" }.into(),
            terminal::device(floor.least.backend, floor.least.software),
            time(floor.soonest.frame),
            error(floor.least.error),
        ]
    };
    let open = floors.iter().any(|f| !f.reached);
    let note = "open: no slower run was measured; more time may lower the error";
    Sheet {
        problem: floors[0].problem.clone(),
        table: table::Table {
            caption: format!(": least {metric} of each method"),
            head: words([
                "fastest run at floor",
                "floor",
                "on",
                "frame ms",
                "least error",
            ]),
            rows: floors.iter().map(row).collect(),
            note: if open { note.into() } else { String::new() },
        },
        numbers: 3,
    }
}

/// A time, with its interval where there is one.
pub(super) fn time(frame: FrameTime) -> String {
    let ms = format::number(frame.ms);
    let (low, high) = (format::number(frame.low), format::number(frame.high));
    match low == high {
        true => ms,
        false => format!("{ms} ({low}–{high})"),
    }
}

pub(super) fn error(measured: Measured) -> String {
    format::error(measured.value, measured.conclusive)
}
