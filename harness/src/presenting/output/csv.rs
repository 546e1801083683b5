//! Runs as a table for other programs: a column for every value that some run has.

use crate::domain::files::{FileError, write_atomically};
use crate::domain::record::Run;
use serde_json::Value;
use std::{io, path::Path};

/// Writes one line for each run under the names of its JSON: what lies in an object is
/// `object.name`, such as `params.resolution` or `truth.relmse`. What a run does not have is empty.
///
/// # Errors
/// [`FileError::Write`] with the path if the file can't be written.
pub fn write_csv(path: &Path, runs: &[Run]) -> Result<(), FileError> {
    let bytes = table(runs).map_err(|source| FileError::Write {
        path: path.into(),
        source,
    })?;
    write_atomically(path, &bytes)
}

/// A line's values under their columns' names.
type Line = Vec<(String, String)>;

fn table(runs: &[Run]) -> io::Result<Vec<u8>> {
    let mut lines = Vec::new();
    let mut columns: Vec<String> = Vec::new();
    for run in runs {
        let mut line = Line::new();
        flatten("", &serde_json::to_value(run)?, &mut line);
        let mut after = 0;
        for (name, _) in &line {
            // A new column stands behind the one that comes before it in the run.
            match columns.iter().position(|c| c == name) {
                Some(at) => after = at + 1,
                None => {
                    columns.insert(after, name.clone());
                    after += 1;
                }
            }
        }
        lines.push(line);
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&columns)?;
    for line in &lines {
        let value = |column: &String| {
            let found = line.iter().find(|(name, _)| name == column);
            found.map_or("", |(_, value)| value.as_str())
        };
        writer.write_record(columns.iter().map(value))?;
    }
    writer.into_inner().map_err(|e| e.into_error())
}

/// Appends a value's leaves; nulls and empty objects have none.
fn flatten(name: &str, value: &Value, line: &mut Line) {
    match value {
        Value::Null => {}
        Value::Object(entries) => {
            for (key, value) in entries {
                let dot = if name.is_empty() { "" } else { "." };
                flatten(&format!("{name}{dot}{key}"), value, line);
            }
        }
        Value::String(text) => line.push((name.into(), text.clone())),
        other => line.push((name.into(), other.to_string())),
    }
}
