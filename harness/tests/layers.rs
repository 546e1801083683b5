//! Modules import one way: between the layers of the crate, and between the parts of every module.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The layers, each of which may import those before it.
const LAYERS: [&str; 4] = ["domain", "running", "presenting", "command_line"];

/// A module's path within the crate, such as `running`, `campaign`, `plan`.
type Module = Vec<String>;

/// What a file imports.
struct File {
    path: PathBuf,
    module: Module,
    imports: Vec<Module>,
}

#[test]
fn layers_import_those_below_alone() {
    let mut wrong = Vec::new();
    for file in files() {
        let Some(own) = layer(&file.module) else {
            continue;
        };
        for import in &file.imports {
            if layer(import).is_none_or(|of_import| of_import > own) {
                wrong.push(format!(
                    "{} imports {}",
                    file.path.display(),
                    import.join("::")
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn parts_of_a_module_import_one_way() {
    let files = files();
    let parents: BTreeSet<&[String]> = files
        .iter()
        .flat_map(|file| (1..file.module.len()).map(|end| &file.module[..end]))
        .collect();
    assert!(parents.len() > LAYERS.len(), "{parents:?}");
    let mut wrong = Vec::new();
    for parent in parents {
        let part = |module: &Module| Some(module.strip_prefix(parent)?.first()?.clone());
        let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for file in &files {
            let Some(own) = part(&file.module) else {
                continue;
            };
            let imported = file.imports.iter().filter_map(part);
            let others = imported.filter(|other| *other != own);
            edges.entry(own.clone()).or_default().extend(others);
        }
        let cyclic = cyclic(edges);
        if !cyclic.is_empty() {
            wrong.push(format!("{}: a cycle among {cyclic:?}", parent.join("::")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_file_belongs_to_a_layer() {
    for file in files() {
        let root = ["lib.rs", "main.rs"]
            .iter()
            .any(|name| file.path.ends_with(name));
        assert!(
            root || layer(&file.module).is_some(),
            "{}",
            file.path.display()
        );
    }
}

/// The parts that are left when those that import no other part are taken away, again and again.
fn cyclic(mut edges: BTreeMap<String, BTreeSet<String>>) -> Vec<String> {
    loop {
        let known: BTreeSet<String> = edges.keys().cloned().collect();
        let before = edges.len();
        edges.retain(|_, imports| !imports.is_disjoint(&known));
        if edges.len() == before {
            return edges.into_keys().collect();
        }
    }
}

fn layer(module: &[String]) -> Option<usize> {
    let first = module.first()?;
    LAYERS.iter().position(|layer| layer == first)
}

fn files() -> Vec<File> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    collect(&root, &root, &mut files);
    assert!(files.len() > 100, "{} files", files.len());
    files
}

fn collect(root: &Path, folder: &Path, files: &mut Vec<File>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(root, &path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let path = path.strip_prefix(root).unwrap().to_owned();
            let module = module_of(&path);
            let text = fs::read_to_string(root.join(&path)).unwrap();
            let imports = imports(&text, &module);
            files.push(File {
                path,
                module,
                imports,
            });
        }
    }
}

/// The module that a file holds: `a/b.rs` and `a/b/mod.rs` are `a::b`, `lib.rs` and `main.rs` the root.
fn module_of(path: &Path) -> Module {
    let stem = path.with_extension("");
    let parts = stem.iter().map(|part| part.to_str().unwrap().to_owned());
    parts
        .filter(|part| !["lib", "main", "mod"].contains(&&**part))
        .collect()
}

/// All paths from `crate` or `super` in a file, from the crate's root; what stands after a module's name
/// may be a thing in it.
fn imports(text: &str, module: &[String]) -> Vec<Module> {
    let lines = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    let mut found = Vec::new();
    let code: Vec<&str> = lines.collect();
    for (number, line) in code.iter().enumerate() {
        for (at, word) in words(line) {
            let begins = ["crate", "super"].contains(&word) && !line[..at].ends_with("::");
            if !begins || !line[at + word.len()..].starts_with("::") {
                continue;
            }
            let rest = std::iter::once(&line[at..]).chain(code[number + 1..].iter().copied());
            let rest: String = rest.take(40).flat_map(|line| line.trim().chars()).collect();
            let mut base = module.to_vec();
            // A module within the file is one level deeper.
            base.extend(in_module_within(&code[..number]).then(|| "within".to_owned()));
            expand(&rest, &[], &mut |path| found.push(resolved(path, &base)));
        }
    }
    found
}

/// Whether code stands in a module that its file holds, such as `mod tests { … }`.
fn in_module_within(before: &[&str]) -> bool {
    let opens = |line: &&&str| line.starts_with("mod ") && line.trim_end().ends_with('{');
    let open = before.iter().rposition(|line| opens(&line));
    open.is_some_and(|open| !before[open..].contains(&"}"))
}

/// Identifiers of a line and where they begin.
fn words(line: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let starts = line
        .char_indices()
        .filter(move |&(at, c)| is_part(c) && !line[..at].chars().next_back().is_some_and(is_part));
    starts.map(move |(at, _)| {
        let rest = &line[at..];
        (
            at,
            &rest[..rest.find(|c| !is_part(c)).unwrap_or(rest.len())],
        )
    })
}

/// Calls back for every path of a tree such as `a::{b, c::d}`; the rest of the text behind the tree.
fn expand<'t>(text: &'t str, before: &[String], each: &mut impl FnMut(Vec<String>)) -> &'t str {
    let text = text.trim_start();
    let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_'));
    let (word, rest) = text.split_at(end.unwrap_or(text.len()));
    let mut path = before.to_vec();
    path.extend(Some(word.to_owned()).filter(|w| !w.is_empty()));
    let Some(rest) = rest.strip_prefix("::") else {
        each(path);
        return rest;
    };
    let Some(mut rest) = rest.strip_prefix('{') else {
        return expand(rest, &path, each);
    };
    loop {
        rest = expand(rest, &path, each).trim_start();
        // Past `as name`.
        rest = rest.trim_start_matches(|c: char| !",}".contains(c));
        match rest.strip_prefix(',') {
            Some(more) if !more.trim_start().starts_with('}') => rest = more,
            Some(end) => return end.trim_start().trim_start_matches('}'),
            None => return rest.trim_start_matches('}'),
        }
    }
}

fn resolved(path: Vec<String>, base: &[String]) -> Module {
    let mut module = base.to_vec();
    for word in path {
        match word.as_str() {
            "crate" => module.clear(),
            "super" => drop(module.pop()),
            "self" => {}
            _ => module.push(word),
        }
    }
    module
}

#[test]
fn paths_are_found_in_groups_lines_and_modules_within() {
    let text = "use crate::{domain::record::{Run, Timing as T},\n    running::view};\nuse super::plan;\n\
                // use crate::comment;\nfn f() { crate::presenting::table::runs(); }\n\
                mod tests {\n    use super::super::journal;\n}\n";
    let module = ["running", "campaign", "axis"].map(str::to_owned);
    let found: Vec<String> = imports(text, &module)
        .iter()
        .map(|p| p.join("::"))
        .collect();
    let expected = [
        "domain::record::Run",
        "domain::record::Timing",
        "running::view",
        "running::campaign::plan",
        "presenting::table::runs",
        "running::campaign::journal",
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_cycle_is_found_and_what_leads_to_it_is_named_too() {
    let edges = |pairs: &[(&str, &[&str])]| {
        let owned = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect();
        pairs
            .iter()
            .map(|(a, b)| ((*a).to_owned(), owned(b)))
            .collect()
    };
    assert!(cyclic(edges(&[("a", &["b"]), ("b", &[]), ("c", &["a", "b"])])).is_empty());
    assert_eq!(
        cyclic(edges(&[("a", &["b"]), ("b", &["a"]), ("c", &[])])),
        ["a", "b"]
    );
}
