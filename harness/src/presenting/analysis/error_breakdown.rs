//! What models leave out, and what errors are made of, as tables.

use crate::domain::format;
use crate::domain::record::{Backend, ErrorBreakdown, Floor, Part, Run};
use crate::presenting::table::{Table, Tables};
use interreflect_scene::params::FIDELITY;

/// The bias floor of each estimator: its model against the truth.
pub fn bias_floors(floors: &[Floor]) -> Vec<Tables> {
    let groups = floors.chunk_by(|a, b| (&a.scene, &a.quantity) == (&b.scene, &b.quantity));
    let row = |floor: &Floor| {
        let found = &floor.against_truth;
        let energy = found.energy_ratio.map_or("–".into(), format::number);
        vec![
            floor.estimator.clone(),
            floor.model.clone(),
            format::relmse(found),
            energy,
        ]
    };
    let table = |group: &[Floor]| Tables {
        scene: group[0].scene.clone(),
        quantity: group[0].quantity.clone(),
        tables: vec![Table {
            caption: "Bias floor: error of each own model against the ground truth".into(),
            head: ["estimator", "its model", "relMSE", "energy"]
                .map(Into::into)
                .into(),
            rows: group.iter().map(row).collect(),
            note: "The error that would remain if the method computed its own model exactly."
                .into(),
        }],
    };
    groups.map(table).collect()
}

/// The steps from the truth to each estimate, a table for all methods that leave out the same.
pub fn splits(splits: &[ErrorBreakdown]) -> Vec<Tables> {
    let mut groups: Vec<Vec<&ErrorBreakdown>> = Vec::new();
    let key = |s: &ErrorBreakdown| {
        let parts: Vec<String> = s.parts.iter().map(|p| p.name.clone()).collect();
        (s.scene.clone(), s.quantity.clone(), parts)
    };
    for split in splits.iter().filter(|s| !s.parts.is_empty()) {
        match groups.iter_mut().find(|g| key(g[0]) == key(split)) {
            Some(group) => group.push(split),
            None => groups.push(vec![split]),
        }
    }
    groups.iter().map(|group| split_table(group)).collect()
}

fn split_table(group: &[&ErrorBreakdown]) -> Tables {
    let parts = group[0].parts.iter().map(|p| p.name.clone());
    let row = |split: &&ErrorBreakdown| {
        let cells = split.parts.iter().map(cell);
        std::iter::once(label(split, group)).chain(cells).collect()
    };
    Tables {
        scene: group[0].scene.clone(),
        quantity: group[0].quantity.clone(),
        tables: vec![Table {
            caption: "Error breakdown, from the ground truth to the estimate".into(),
            head: std::iter::once("estimator".into()).chain(parts).collect(),
            rows: group.iter().map(row).collect(),
            note: "Each cell: mean of the step over the truth's mean (the steps add up to the total bias), \
                   and its relMSE in brackets. ≈: within the references' noise."
                .into(),
        }],
    }
}

fn cell(part: &Part) -> String {
    let mark = if part.above_noise { "" } else { "≈ " };
    let mean = part
        .mean
        .map_or("–".into(), |mean| format!("{:+.1} %", 100.0 * mean));
    format!("{mark}{mean} ({})", format::number(part.relmse))
}

/// Estimator, fidelity and what varies among those beside it.
fn label(split: &ErrorBreakdown, group: &[&ErrorBreakdown]) -> String {
    let mut run = Run::new("", &*split.estimator, Backend::Cpu, "");
    run.fidelity.clone_from(&split.fidelity);
    let same = || group.iter().filter(|s| s.estimator == split.estimator);
    let varied = split.params.0.iter().filter(|(name, value)| {
        name != FIDELITY && same().any(|s| s.params.get(name) != Some(value))
    });
    varied.fold(run.label(), |label, (name, value)| {
        format!("{label}, {name}={value}")
    })
}
