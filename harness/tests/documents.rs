//! What the documents name must exist.

#![allow(clippy::unwrap_used, reason = "tests")]

use interreflect_estimators::{Reference, Registry, leaves};
use interreflect_scene::params::{FieldInfo, Value};
use std::collections::BTreeSet;
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
    let registry = Registry::builtin();
    let of_methods = registry.entries().iter().map(|entry| entry.leaves());
    let folders = leaves::shared().into_iter().chain(of_methods);
    let leaves: BTreeSet<String> = folders
        .flat_map(|folder| {
            let functions = folder.functions.iter();
            functions.map(|leaf| format!("{}/{}", folder.folder, leaf.name))
        })
        .collect();
    let mut rows_checked = 0;
    for row in rows {
        let column = row.trim_end_matches([' ', '|']).rsplit('|').next().unwrap();
        let names: Vec<_> = column.split('`').skip(1).step_by(2).collect();
        assert!(!names.is_empty(), "PAPERS.md names no test in: {row}");
        for name in names {
            let exists = match name.split_once('/') {
                Some(("leaf_parity", leaf)) => leaves.contains(leaf),
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

/// Set to 1 to write what is made from the registry instead of comparing it.
const WRITE: &str = "INTERREFLECT_WRITE_TABLES";

/// Checks, or writes, the part of a document between its marks.
fn made(document: &str, part: &str, expected: &str) {
    let path = root().join(document);
    let text = std::fs::read_to_string(&path)
        .unwrap_or_else(|e| panic!("{} is missing: {e}", path.display()));
    let (begin, end) = (format!("<!-- {part} -->\n"), format!("<!-- /{part} -->"));
    let (before, rest) = text
        .split_once(&begin)
        .unwrap_or_else(|| panic!("{document} has no place for its {part}"));
    let (found, after) = rest.split_once(&end).unwrap();
    if std::env::var_os(WRITE).is_some_and(|v| v == "1") {
        let whole = [before, &begin, expected, &end, after].concat();
        std::fs::write(&path, whole).unwrap();
        return;
    }
    assert!(
        found == expected,
        "{document}: its {part} are not as the methods' folders have them; {WRITE}=1 cargo test \
         -p interreflect --test documents writes them"
    );
}

/// Every estimator has a README, with the table of its parameters as they are declared.
#[test]
fn readmes_have_the_parameters_as_declared() {
    for entry in Registry::builtin().entries() {
        let id = entry.info().id;
        let readme = format!("estimators/src/{id}/README.md");
        made(&readme, "parameters", &table(&entry.configure().values()));
    }
}

#[test]
fn the_readme_has_a_row_for_each_estimator() {
    let mut rows = String::from("| estimator | what it is | from |\n|---|---|---|\n");
    for entry in Registry::builtin().entries() {
        let info = entry.info();
        let from = info.references.iter().map(|r| {
            let first = r.authors.split(',').next().unwrap_or_default();
            let surname = first.rsplit(' ').next().unwrap_or_default();
            match r.doi {
                Some(doi) => format!("[{surname} {}](https://doi.org/{doi})", r.year),
                None => format!("{surname} {}", r.year),
            }
        });
        let from: Vec<String> = from.collect();
        rows += &format!(
            "| [`{0}`](estimators/src/{0}/README.md) | {1} | {2} |\n",
            info.id,
            info.summary,
            from.join(", ")
        );
    }
    made("README.md", "estimators", &rows);
}

/// PAPERS.md has the section of each method's PAPER.md, and the publications that methods name.
#[test]
fn papers_has_the_sections_and_the_references_of_all_methods() {
    let (mut sections, mut references) = (String::from("\n"), BTreeSet::<Reference>::new());
    for entry in Registry::builtin().entries() {
        let info = entry.info();
        let paper = root().join(format!("estimators/src/{}/PAPER.md", info.id));
        if let Ok(section) = std::fs::read_to_string(paper) {
            sections += &format!("{section}\n");
        }
        references.extend(info.references);
    }
    made("PAPERS.md", "methods", &sections);
    let mut list = String::from("\n## References\n\n");
    for reference in references {
        let doi = reference.doi.map(|doi| format!(". https://doi.org/{doi}"));
        list += &format!("- {reference}{}\n", doi.unwrap_or_default());
    }
    made("PAPERS.md", "references", &format!("{list}\n"));
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
        "GLOSSARY.md",
        "SWEEPS.md",
        "CHANGELOG.md",
    ];
    for document in documents {
        let text = std::fs::read_to_string(root().join(document)).unwrap();
        for target in text
            .split("](")
            .skip(1)
            .filter_map(|rest| rest.split(')').next())
        {
            if target.starts_with("https://") {
                continue;
            }
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
