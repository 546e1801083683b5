//! The list of experiments, how they are named, and that they are what the papers show.
#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use serde::Deserialize;
use serde_json::{Map, Value};

/// A row of `papers.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    id: String,
    item: String,
    subject: String,
    scene: Option<String>,
    scenes: Option<Vec<String>>,
    #[serde(default)]
    parameters: Map<String, Value>,
    #[serde(default)]
    claims: Map<String, Value>,
    missing: Option<String>,
}

#[derive(Deserialize)]
struct Table {
    row: Vec<Row>,
}

fn rows() -> Vec<Row> {
    toml::from_str::<Table>(include_str!("papers.toml"))
        .unwrap()
        .row
}

#[test]
fn experiments_of_a_paper_are_those_of_the_table() {
    let (rows, experiments) = (rows(), experiments());
    let mut wrong = Vec::new();
    for row in &rows {
        let experiment = experiments.iter().find(|e| e.id == row.id);
        match (&row.missing, experiment) {
            (None, Some(experiment)) => wrong.extend(differences(row, experiment)),
            (None, None) => wrong.push(format!("{}: no experiment", row.id)),
            (Some(_), Some(_)) => wrong.push(format!("{} is there, not missing", row.id)),
            (Some(why), None) if why.is_empty() => wrong.push(format!("{}: why?", row.id)),
            (Some(_), None) => (),
        }
        if row.subject.is_empty() || rows.iter().filter(|r| r.id == row.id).count() != 1 {
            wrong.push(format!("{} has no subject, or several rows", row.id));
        }
    }
    for experiment in &experiments {
        let listed = rows.iter().any(|row| row.id == experiment.id);
        if listed != (experiment.item != Item::NotInThePaper) {
            wrong.push(format!(
                "{}: {}, but listed: {listed}",
                experiment.id, experiment.item
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What an experiment does otherwise than its row says.
fn differences(row: &Row, experiment: &Experiment) -> Vec<String> {
    let mut expected = row.parameters.clone();
    if let Some(scene) = &row.scene {
        expected.insert("scene".into(), scene.as_str().into());
    }
    if let Some(scenes) = &row.scenes {
        expected.insert("scenes".into(), scenes.clone().into());
    }
    let claims: Map<String, Value> = experiment
        .claims
        .iter()
        .map(|claim| (claim.id.into(), claim.says.into()))
        .collect();
    let pairs = [
        (
            "item",
            row.item.as_str().into(),
            experiment.item.to_string().into(),
        ),
        ("setup", Value::Object(expected), experiment.described()),
        (
            "claims",
            Value::Object(row.claims.clone()),
            Value::Object(claims),
        ),
    ];
    let differ = |(what, expected, found): &(&str, Value, Value)| {
        (!same(expected, found))
            .then(|| format!("{}: {what} is {found}, in the table {expected}", row.id))
    };
    pairs.iter().filter_map(differ).collect()
}

/// Equal, with 5 and 5.0 alike.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => a.as_f64() == b.as_f64(),
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
        }
        (Value::Object(a), Value::Object(b)) => {
            let found = |(name, a): (&String, &Value)| b.get(name).is_some_and(|b| same(a, b));
            a.len() == b.len() && a.iter().all(found)
        }
        _ => a == b,
    }
}

#[test]
fn a_wrong_item_scene_value_or_claim_is_found() {
    let row = |item: &str, scene: &str, samples: u32, says: &str| Row {
        id: "frisvad.flashing".into(),
        item: item.into(),
        subject: "flashing".into(),
        scene: None,
        scenes: Some(vec![scene.into(), "cave light.angle=95".into()]),
        parameters: [("texels", 16), ("samples", samples)]
            .map(|(name, value)| (name.to_owned(), value.into()))
            .into_iter()
            .collect(),
        claims: [
            ("C1", says),
            ("C2", "Averaged radiance lessens the flashing."),
        ]
        .map(|(id, says)| (id.to_owned(), says.into()))
        .into_iter()
        .collect(),
        missing: None,
    };
    let all = experiments();
    let flashing = all.iter().find(|e| e.id == "frisvad.flashing").unwrap();
    let count = |row: Row| differences(&row, flashing).len();
    let (scene, says) = (
        "cornell-box light.angle=95",
        "Few samples make the light flash while it moves.",
    );
    assert_eq!(count(row("§5", scene, 3, says)), 0);
    assert_eq!(count(row("§6", scene, 3, says)), 1);
    assert_eq!(count(row("§5", "cornell-box light.angle=90", 3, says)), 1);
    assert_eq!(count(row("§5", scene, 4, says)), 1);
    assert_eq!(count(row("§5", scene, 3, "Many samples.")), 1);
}

#[test]
fn an_id_names_its_paper_and_carries_a_number_only_of_its_own_figure_table_or_section() {
    let all = experiments();
    for e in &all {
        let name = e.id.strip_prefix(e.paper.id()).unwrap_or_default();
        let name = name.strip_prefix('.').unwrap_or_default();
        assert!(!name.is_empty(), "{}", e.id);
        assert_eq!(all.iter().filter(|o| o.id == e.id).count(), 1, "{}", e.id);
        let fits = match e.item {
            Item::Figure(number) => name == number.to_string(),
            Item::Table(number) => name == format!("table{number}"),
            Item::Section(number) => !numbered(name) || name == format!("s{number}"),
            Item::NotInThePaper => !numbered(name),
        };
        assert!(fits, "{} is {}", e.id, e.item);
        let described = !e.described().is_null();
        assert!(described || e.item == Item::NotInThePaper, "{}", e.id);
    }
}

/// Whether a name is a number, or one after `table` or `s`.
fn numbered(name: &str) -> bool {
    let rest = ["table", "s"]
        .iter()
        .find_map(|word| name.strip_prefix(word));
    [Some(name), rest]
        .into_iter()
        .flatten()
        .any(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
}

#[test]
fn claims_are_numbered_and_have_rules() {
    for e in experiments() {
        for (index, claim) in e.claims.iter().enumerate() {
            assert_eq!(claim.id, format!("C{}", index + 1), "{}", e.id);
            assert!(!claim.says.is_empty() && !claim.rule.is_empty(), "{}", e.id);
        }
    }
}

#[test]
fn names_choose_experiments_papers_or_all() {
    let count = |names: &[&str]| {
        let names: Vec<String> = names.iter().map(|n| (*n).to_owned()).collect();
        chosen(&names).map(|e| e.len())
    };
    let of = |paper| experiments().iter().filter(|e| e.paper == paper).count();
    assert_eq!(count(&["all"]).unwrap(), experiments().len());
    assert_eq!(count(&["kautz"]).unwrap(), of(Paper::Kautz));
    assert_eq!(
        count(&["kautz.seams", "kautz", "kautz.seams"]).unwrap(),
        of(Paper::Kautz)
    );
    let refused = count(&["kautz.seam"]).unwrap_err();
    assert!(matches!(refused, RunError::Usage(_)));
    assert!(
        refused.to_string().contains("did you mean `kautz.seams`?"),
        "{refused}"
    );
}
