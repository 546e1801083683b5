//! What the documents name must exist.

#![allow(clippy::unwrap_used, reason = "tests")]

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
        let found = ["fn", "const"]
            .iter()
            .any(|kind| source.contains(&format!("pub {kind} {function}")));
        assert!(
            found,
            "PAPERS.md names {file}::{function}, which is not there"
        );
    }
}

#[test]
fn every_estimator_has_a_readme() {
    for entry in interreflect_estimators::Registry::builtin().entries() {
        let id = entry.info().id;
        let readme = root().join(format!("estimators/src/{id}/README.md"));
        assert!(readme.exists(), "{} is missing", readme.display());
    }
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
