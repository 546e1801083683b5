//! Table 1: the figures' frame rates, row by row.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::steps::{BALLS, BOX, CAVE, CAVE_WITHOUT_MIRRORS, GRID, Grid, Step, take};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.table1",
    paper: Paper::Frisvad,
    item: Item::Table(1),
    title: "frame rates of the figures' scenes and of a large dragon",
    setup: &FrameRates {
        rows: &[
            Rates {
                scene: BOX,
                steps: &[Step::BlinnPhong, Step::Direct, Step::Eq15],
                rates: &[769.231, 137.3, 48.622],
            },
            Rates {
                scene: BOX,
                steps: &[Step::Eq11, Step::Eq15, Step::Eq14],
                rates: &[48.622, 48.622, 20.87],
            },
            Rates {
                scene: BALLS,
                steps: &[
                    Step::Eq14WithoutMirrored,
                    Step::Eq14MirrorsAsDiffuse,
                    Step::Eq14,
                ],
                rates: &[15.178, 15.178, 9.898],
            },
            Rates {
                scene: CAVE,
                steps: &[Step::Direct, Step::Eq15, Step::Eq14],
                rates: &[20.761, 11.888, 7.695],
            },
            Rates {
                scene: CAVE_WITHOUT_MIRRORS,
                steps: &[Step::Direct, Step::Eq15, Step::Eq14],
                rates: &[48.0, 18.4, 10.3],
            },
            Rates {
                scene: SceneSetup::of("cornell-box")
                    .with(&["dragon_871k"])
                    .set(&[("light", "area"), ("receiver.size", "0.25")]),
                steps: &[Step::Eq15, Step::Eq14],
                rates: &[1.8, 0.92],
            },
        ],
        grid: GRID,
    },
    claims: &[Claim {
        id: "C1",
        says: "In each row times stand in the ratios of the table.",
        rule: "A trial is a bound, a picture beside the first of its row, and a backend: the ratio of their \
            frames' times is within a factor of 2 of the paper's, beyond the spread of both.",
    }],
};

/// How far a ratio of times may be from the paper's, as a factor either way.
const FACTOR: f64 = 2.0;

/// A row of the table, or of the text beside it.
#[derive(Serialize)]
pub(super) struct Rates {
    pub(super) scene: SceneSetup,
    pub(super) steps: &'static [Step],
    /// Frames a second in the paper.
    pub(super) rates: &'static [f64],
}

/// Rows of frame rates.
#[derive(Serialize)]
pub(super) struct FrameRates {
    pub(super) rows: &'static [Rates],
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl Runs for FrameRates {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for row in self.rows {
            let name = row.scene.to_string();
            let loaded = context.load(&context.place(&row.scene), &mut finding)?;
            for backend in context.backends() {
                let taken = take(
                    context,
                    (&name, &loaded),
                    (row.steps, self.grid, backend),
                    &mut finding,
                )?;
                let first = taken.first().map(|taken| taken.frame_ms);
                for (taken, rate) in taken.iter().zip(row.rates).skip(1) {
                    let Some(first) = first else { continue };
                    let ours = taken.frame_ms.over(first);
                    let theirs = row.rates[0] / rate;
                    let what = format!(
                        "{name}: {} over {}",
                        taken.step.caption(),
                        row.steps[0].caption()
                    );
                    let software = context.software(backend);
                    finding.time(
                        (what.as_str(), "times as long"),
                        backend,
                        ours,
                        ("", software),
                    );
                    let paper = Amount::exact(theirs);
                    finding.measure((what.as_str(), "in the paper"), backend, paper, "");
                    finding.judge("C1", within(&what, backend, (ours, theirs)));
                }
            }
        }
        Ok(finding)
    }
}

/// That a ratio is within a factor of the paper's.
fn within(what: &str, backend: Backend, (ours, theirs): (Amount, f64)) -> [Trial; 2] {
    let bound = |by: f64| Amount::exact(theirs * by);
    let (least, most) = (bound(1.0 / FACTOR), bound(FACTOR));
    let above = format!("{what}: half of the paper's ratio below ours");
    let below = format!("{what}: ours below twice the paper's");
    [
        Trial::less(above, backend, least, ours).of_times(),
        Trial::less(below, backend, ours, most).of_times(),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn ratios_may_be_off_by_a_factor_of_two() {
        let within = |ours| signs(&within("", Backend::Cpu, (Amount::exact(ours), 3.0)));
        assert_eq!([within(1.4), within(2.0), within(6.1)], ["-+", "++", "+-"]);
    }
}
