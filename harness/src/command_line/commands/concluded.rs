//! What a sweep ends with: its results on disk, what they say, and the report.

use super::{print_json, print_line};
use crate::command_line::cli::Asked;
use crate::command_line::error::CommandError;
use crate::domain::analysis::{Advice, Budget, Conclusions, Metric, advise, fronts};
use crate::domain::record::{Comparison, ErrorBreakdown, Results, Run};
use crate::presenting::analysis::advice_in_text;
use crate::presenting::output::write_results;
use crate::presenting::overview::write_pictures;
use crate::presenting::report::Report;
use crate::presenting::terminal;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The JSON of a sweep.
#[derive(Serialize)]
struct Concluded<'a> {
    runs: &'a [Run],
    /// Indices of the runs that no other of their scene, quantity and machine beats in both frame time
    /// and relMSE.
    pareto: Vec<usize>,
    /// What each model leaves out, by `scene/quantity/estimator`.
    bias_floor: BTreeMap<String, &'a Comparison>,
    baselines: &'a [Run],
    splits: &'a [ErrorBreakdown],
    #[serde(flatten)]
    conclusions: &'a Conclusions,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    advice: Vec<Advice>,
}

/// Writes results, conclusions and report, and prints what was asked for.
pub(super) fn conclude(
    results: &Results,
    out: &Path,
    asked: Asked,
    json: bool,
) -> Result<(), CommandError> {
    let page = write(results, out)?.1;
    let runs = &results.runs;
    let conclusions = Conclusions::of(runs, &results.baselines, Metric::Truth);
    let advice = match asked == Asked::default() {
        true => Vec::new(),
        false => advise(runs, asked.budget()),
    };
    if json {
        return print_json(&Concluded {
            runs,
            pareto: fronts(runs),
            bias_floor: floors(results),
            baselines: &results.baselines,
            splits: &results.splits,
            conclusions: &conclusions,
            advice,
        });
    }
    print_line(&terminal::runs(runs, None))?;
    print_line(&conclusions.text(None))?;
    if !advice.is_empty() {
        print_line(&advice_in_text(&advice))?;
    }
    print_line(&page.display().to_string())
}

/// Writes results, pictures and report into a folder that the images are in; the report and its file.
pub(super) fn write(results: &Results, out: &Path) -> Result<(Report, PathBuf), CommandError> {
    write_results(out, results)?;
    let report = Report::of_folder(out)?;
    write_pictures(out, &report.rows, &results.runs)?;
    let page = out.join("report.html");
    report.write(&page)?;
    Ok((report, page))
}

impl Asked {
    fn budget(self) -> Budget {
        Budget {
            ms: self.budget_ms,
            max_error: self.max_error,
            metric: Metric::Truth,
        }
    }
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
