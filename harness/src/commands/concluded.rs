//! What a sweep ends with: its results on disk, what they say, and the report.

use super::{print_json, print_line};
use crate::cli::Asked;
use crate::error::HarnessError;
use crate::gallery::write_pictures;
use crate::output::write_results;
use crate::record::{Comparison, Results, Run, Split};
use crate::report::Report;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;

/// The JSON of a sweep.
#[derive(Serialize)]
struct Concluded<'a> {
    records: &'a [Run],
    /// Indices of the records that no other of their scene, quantity and machine beats in both time and error.
    pareto: Vec<usize>,
    /// By `scene/quantity/estimator`.
    bias_floor: BTreeMap<String, &'a Comparison>,
    baselines: &'a [Run],
    splits: &'a [Split],
}

/// Writes results, conclusions and report, and prints what was asked for.
pub(super) fn conclude(
    results: &Results,
    out: &Path,
    _asked: Asked,
    json: bool,
) -> Result<(), HarnessError> {
    write_results(out, results)?;
    let report = Report::of_folder(out)?;
    write_pictures(out, &report.rows, &results.runs)?;
    let page = out.join("report.html");
    report.write(&page)?;
    let concluded = Concluded {
        records: &results.runs,
        pareto: Vec::new(),
        bias_floor: floors(results),
        baselines: &results.baselines,
        splits: &results.splits,
    };
    if json {
        return print_json(&concluded);
    }
    print_line(&crate::table::runs(&results.runs, None))?;
    print_line(&page.display().to_string())
}

/// The floors by scene, quantity and estimator; by model too, where an estimator has several.
fn floors(results: &Results) -> BTreeMap<String, &Comparison> {
    let mut floors = BTreeMap::new();
    for floor in &results.floors {
        let key = format!("{}/{}/{}", floor.scene, floor.quantity, floor.estimator);
        let key = match floors.contains_key(&key) {
            true => format!("{key}/{}", floor.model),
            false => key,
        };
        floors.insert(key, &floor.against_truth);
    }
    floors
}
