//! The list of experiments, and how they are named.
#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;

#[test]
fn every_figure_and_table_is_there_once() {
    let ids: Vec<_> = experiments().iter().map(|e| e.id).collect();
    let of = |paper: &str, items: &[&str]| -> Vec<String> {
        items.iter().map(|item| format!("{paper}.{item}")).collect()
    };
    let expected = [
        of("szirmay-kalos", &["3", "6", "7", "8", "amortised"]),
        of("kautz", &["3", "4", "5", "6"]),
        of(
            "frisvad",
            &["3", "4", "5", "6", "7", "8", "9", "table1", "flashing"],
        ),
        of("umenhoffer", &["4", "5", "6"]),
        of(
            "sattler",
            &["4", "5", "6", "7", "8", "9", "table1", "frame-rate"],
        ),
    ]
    .concat();
    assert_eq!(ids, expected);
    assert_eq!(ids.len(), 26 + 3);
}

#[test]
fn an_experiment_belongs_to_the_paper_that_its_id_names() {
    for e in experiments() {
        let item =
            e.id.strip_prefix(e.paper.id())
                .and_then(|rest| rest.strip_prefix('.'));
        assert!(item.is_some_and(|item| !item.is_empty()), "{}", e.id);
        assert!(
            !e.claim.is_empty() && !e.rule.is_empty(),
            "{} says too little",
            e.id
        );
    }
}

#[test]
fn names_choose_experiments_papers_or_all() {
    let count = |names: &[&str]| {
        let names: Vec<String> = names.iter().map(|n| (*n).to_owned()).collect();
        chosen(&names).map(|e| e.len())
    };
    assert_eq!(count(&["all"]).unwrap(), 29);
    assert_eq!(count(&["kautz"]).unwrap(), 4);
    assert_eq!(count(&["kautz.3", "kautz", "kautz.3"]).unwrap(), 4);
    let refused = count(&["kautz.33"]).unwrap_err();
    assert!(matches!(refused, RunError::Usage(_)));
    assert!(
        refused.to_string().contains("did you mean `kautz.3`?"),
        "{refused}"
    );
}
