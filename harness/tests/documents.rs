//! What the documents name must exist.

#![allow(clippy::unwrap_used, reason = "tests")]

use interreflect_scene::params::{FieldInfo, Value};
use std::path::Path;

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
}

#[test]
fn every_function_that_papers_names_exists() {
    let papers = std::fs::read_to_string(root().join("PAPERS.md")).unwrap();
    let quoted = papers.split('`').skip(1).step_by(2);
    let named: Vec<_> = quoted.filter_map(|text| text.split_once("::")).collect();
    assert!(named.len() > 10, "only {} functions are named", named.len());
    for (file, function) in named {
        let inside = root().join("estimators/src").join(file);
        let path = if inside.exists() {
            inside
        } else {
            root().join(file)
        };
        let source = std::fs::read_to_string(&path)
            .unwrap_or_else(|e| panic!("PAPERS.md names {}: {e}", path.display()));
        let found = ["(", "<"]
            .iter()
            .any(|end| source.contains(&format!("fn {function}{end}")));
        assert!(
            found,
            "PAPERS.md names {file}::{function}, which is not there"
        );
    }
}

/// The texts of all Rust files below a folder of the repository.
fn sources(below: &str) -> Vec<String> {
    let (mut texts, mut paths) = (Vec::new(), vec![root().join(below)]);
    while let Some(path) = paths.pop() {
        if path.is_dir() {
            let inside = std::fs::read_dir(path).unwrap();
            paths.extend(inside.map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|e| e == "rs") {
            texts.push(std::fs::read_to_string(path).unwrap());
        }
    }
    texts
}

/// Whether a text has a name that is not a part of a longer one.
fn has_word(text: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(word)
        .any(|(at, _)| !text[..at].ends_with(part) && !text[at + word.len()..].starts_with(part))
}

/// A name with a slash is a trial's: its first part begins a name there, the others are words of
/// the suite. Any other is that of a test function.
#[test]
fn every_test_that_papers_names_exists() {
    let papers = std::fs::read_to_string(root().join("PAPERS.md")).unwrap();
    let rows = papers
        .lines()
        .filter(|l| l.starts_with("| ") && l.contains("::"));
    let trials = sources("tests/tests/conformance").join("\n");
    let tests: Vec<String> = ["scene", "cpu", "estimators", "tests", "harness"]
        .iter()
        .flat_map(|c| ["src", "tests"].map(|part| format!("{c}/{part}")))
        .filter(|folder| root().join(folder).exists())
        .flat_map(|folder| sources(&folder))
        .collect();
    let mut rows_checked = 0;
    for row in rows {
        let column = row.trim_end_matches([' ', '|']).rsplit('|').next().unwrap();
        let names: Vec<_> = column.split('`').skip(1).step_by(2).collect();
        assert!(!names.is_empty(), "PAPERS.md names no test in: {row}");
        for name in names {
            let exists = match name.split_once('/') {
                Some((group, rest)) => {
                    trials.contains(&format!("\"{group}/"))
                        && rest.split('/').all(|part| has_word(&trials, part))
                }
                None => {
                    let function = format!("#[test]\nfn {name}() {{");
                    let inner = format!("#[test]\n    fn {name}() {{");
                    tests
                        .iter()
                        .any(|t| t.contains(&function) || t.contains(&inner))
                }
            };
            assert!(
                exists,
                "PAPERS.md names the test {name}, which is not there"
            );
        }
        rows_checked += 1;
    }
    assert!(rows_checked > 10, "only {rows_checked} rows name tests");
}

/// Set to 1 to write the tables of parameters instead of comparing them.
const WRITE: &str = "INTERREFLECT_WRITE_TABLES";

const TABLE: [&str; 2] = ["<!-- parameters -->\n", "<!-- /parameters -->"];

/// Every estimator has a README, with the table of its parameters as they are declared.
#[test]
fn readmes_have_the_parameters_as_declared() {
    for entry in interreflect_estimators::Registry::builtin().entries() {
        let id = entry.info().id;
        let path = root().join(format!("estimators/src/{id}/README.md"));
        let text = std::fs::read_to_string(&path)
            .unwrap_or_else(|e| panic!("{} is missing: {e}", path.display()));
        let (before, rest) = text
            .split_once(TABLE[0])
            .unwrap_or_else(|| panic!("{} has no place for its parameters", path.display()));
        let (found, after) = rest.split_once(TABLE[1]).unwrap();
        let declared = table(&entry.configure().values());
        if std::env::var_os(WRITE).is_some_and(|v| v == "1") {
            let whole = [before, TABLE[0], &declared, TABLE[1], after].concat();
            std::fs::write(&path, whole).unwrap();
            continue;
        }
        assert_eq!(
            found,
            declared,
            "{}: the parameters are declared otherwise; {WRITE}=1 cargo test -p interreflect \
             --test documents writes the table",
            path.display()
        );
    }
}

/// Parameters as a table in Markdown.
fn table(values: &[(FieldInfo, Value)]) -> String {
    let mut table =
        String::from("| parameter | default | values | what it is |\n|---|---|---|---|\n");
    for (field, default) in values {
        let symbol = match field.symbol {
            "" => String::new(),
            symbol => format!(" ({symbol})"),
        };
        let values = format!("{} {}", field.domain, field.unit);
        let row = [
            &format!("`{}`{symbol}", field.name),
            &default.to_string(),
            values.trim(),
            field.doc,
        ];
        table += &format!("| {} |\n", row.join(" | "));
    }
    table
}

#[test]
fn links_between_documents_lead_somewhere() {
    let documents = [
        "README.md",
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "PAPERS.md",
        "PERFORMANCE.md",
    ];
    for document in documents {
        let text = std::fs::read_to_string(root().join(document)).unwrap();
        for target in text
            .split("](")
            .skip(1)
            .filter_map(|rest| rest.split(')').next())
        {
            let target = root().join(target);
            assert!(target.exists(), "{document} links to {}", target.display());
        }
    }
    let lines = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    assert!(
        lines.lines().count() <= 150,
        "ARCHITECTURE.md is to stay short"
    );
}
