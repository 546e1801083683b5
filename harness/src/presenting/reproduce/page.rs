//! `reproduce.html`: one file with an entry an experiment, without scripts or other files.

use super::pictures::Shown;
use super::record::{Entry, Record, Reproduced};
use crate::domain::files::write_atomically;
use crate::domain::format;
use crate::domain::record::Backend;
use crate::presenting::error::PresentError;
use crate::presenting::output::colour_stops;
use crate::running::reproduce::{Measure, Paper, Verdict};
use minijinja::{syntax::SyntaxConfig, value::Serde};
use serde::Serialize;
use serde_json::Value;
use std::path::Path;

/// What the template sees.
#[derive(Serialize)]
pub struct Page<'a> {
    command: &'a str,
    results: &'a Reproduced<'a>,
    adapter: String,
    commit: String,
    dev_build: bool,
    software: bool,
    papers: Vec<Section<'a>>,
    colour_stops: String,
}

#[derive(Serialize)]
struct Section<'a> {
    id: &'static str,
    title: &'static str,
    entries: Vec<Shape<'a>>,
}

/// An experiment laid out.
#[derive(Serialize)]
struct Shape<'a> {
    record: &'a Record,
    /// For each claim, or once where nothing is claimed: `good`, `part`, `bad` or `none`.
    badges: Vec<&'static str>,
    /// Names and values of the setup's fields.
    setup: Vec<(String, String)>,
    table: Table,
    pictures: &'a [Shown],
    software: bool,
}

/// Numbers with a line for each case and backend, and a column for each name.
#[derive(Serialize)]
struct Table {
    columns: Vec<String>,
    lines: Vec<Line>,
}

#[derive(Serialize)]
struct Line {
    case: String,
    backend: Backend,
    software: bool,
    cells: Vec<String>,
}

impl<'a> Page<'a> {
    /// A page of what is over so far.
    pub fn new(command: &'a str, results: &'a Reproduced<'a>, entries: &'a [Entry]) -> Self {
        let section = |paper: Paper| Section {
            id: paper.id(),
            title: paper.title(),
            entries: entries
                .iter()
                .filter(|e| e.paper == paper)
                .map(shape)
                .collect(),
        };
        let papers = Paper::ALL.into_iter().map(section);
        Self {
            command,
            adapter: results.machine.adapter_label(),
            commit: results.machine.commit_label(),
            dev_build: results.machine.versions.profile == "dev",
            software: results.machine.software == Some(true),
            papers: papers.filter(|s| !s.entries.is_empty()).collect(),
            colour_stops: colour_stops().collect::<Vec<_>>().join(", "),
            results,
        }
    }

    /// Writes the page.
    ///
    /// # Errors
    /// [`PresentError`] if the file can't be written.
    pub fn write(&self, path: &Path) -> Result<(), PresentError> {
        let html = self.html().map_err(PresentError::from)?;
        Ok(write_atomically(path, html.as_bytes())?)
    }

    fn html(&self) -> Result<String, minijinja::Error> {
        let mut environment = minijinja::Environment::new();
        let syntax = SyntaxConfig::builder();
        environment.set_syntax({ syntax }.trim_blocks(true).lstrip_blocks(true).build()?);
        environment.add_template("reproduce.html", include_str!("page.html"))?;
        environment
            .get_template("reproduce.html")?
            .render(Serde(self))
    }
}

fn shape(entry: &Entry) -> Shape<'_> {
    let record = &entry.record;
    Shape {
        record,
        badges: entry.verdicts.iter().map(badge).collect(),
        setup: setup(&record.setup),
        table: table(&record.measured),
        pictures: &entry.pictures,
        software: record.measured.iter().any(|m| m.software),
    }
}

/// Names and values of an object's fields, lists with commas.
fn setup(described: &Value) -> Vec<(String, String)> {
    let fields = described.as_object().into_iter().flatten();
    fields
        .map(|(name, value)| (name.replace('_', " "), text(value)))
        .collect()
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(values) => values.iter().map(text).collect::<Vec<_>>().join(", "),
        other => other.to_string(),
    }
}

fn badge(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "good",
        Verdict::HoldsInPart => "part",
        Verdict::DoesNotHold => "bad",
        Verdict::Inconclusive | Verdict::NotRun(_) | Verdict::Shown => "none",
    }
}

fn table(measured: &[Measure]) -> Table {
    let (mut columns, mut keys): (Vec<String>, Vec<(&str, Backend)>) = Default::default();
    for m in measured {
        if !columns.contains(&heading(m)) {
            columns.push(heading(m));
        }
        if !keys.contains(&(&m.case, m.backend)) {
            keys.push((&m.case, m.backend));
        }
    }
    let line = |(case, backend): (&str, Backend)| {
        let of_line = || {
            measured
                .iter()
                .filter(|m| m.case == case && m.backend == backend)
        };
        let cell = |column: &String| {
            let found = of_line().find(|m| heading(m) == *column);
            found.map_or(String::new(), number)
        };
        Line {
            case: case.into(),
            backend,
            software: of_line().any(|m| m.software),
            cells: columns.iter().map(cell).collect(),
        }
    };
    Table {
        lines: keys.into_iter().map(line).collect(),
        columns,
    }
}

fn heading(measure: &Measure) -> String {
    match measure.unit {
        "" => measure.name.clone(),
        unit => format!("{}, {unit}", measure.name),
    }
}

fn number(measure: &Measure) -> String {
    let value = format::number(measure.value);
    match measure.spread {
        Some(spread) => format!("{value} ± {}", format::deviation(spread)),
        None => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setup_is_told_by_names_and_values() {
        let described = serde_json::json!({"scene": "room bunny", "f_lambda": [0.03, 0.9]});
        let told = setup(&described)
            .into_iter()
            .map(|(name, value)| format!("{name}: {value}"));
        assert_eq!(
            told.collect::<Vec<_>>(),
            ["scene: room bunny", "f lambda: 0.03, 0.9"]
        );
        assert!(setup(&Value::Null).is_empty());
    }

    #[test]
    fn numbers_of_a_case_and_backend_share_a_line() {
        let measure = |case: &str, name: &str, backend| Measure {
            case: case.into(),
            name: name.into(),
            backend,
            value: 1.5,
            spread: (name == "time").then_some(0.25),
            unit: if name == "time" { "ms" } else { "" },
            software: backend == Backend::Gpu,
        };
        let table = table(&[
            measure("a", "time", Backend::Cpu),
            measure("a", "time", Backend::Gpu),
            measure("a", "error", Backend::Cpu),
            measure("b", "error", Backend::Cpu),
        ]);
        assert_eq!(table.columns, ["time, ms", "error"]);
        let cells: Vec<_> = table.lines.iter().map(|l| l.cells.join("|")).collect();
        assert_eq!(cells, ["1.50 ± 0.25|1.50", "1.50 ± 0.25|", "|1.50"]);
        assert!(table.lines[1].software && !table.lines[0].software);
    }
}
