//! `report.html`: one file that shows what was measured, and asks no other file or machine for anything.
//!
//! A table of scenes and methods whose small images open in a viewer, and for each scene and quantity:
//! the trade of time for error as a plot, curves over parameters, what was concluded, all runs, and the
//! command that makes it again. The viewer (`js/`) decodes the pixels when they are first shown and does
//! the rest from them: exposure, comparison, error maps. Without scripts all but the viewer is there.

mod command;
mod curves;
mod folder;
mod mark;
mod names;
mod page;
mod pareto;
mod pictures;
mod pixels;
mod plot;
mod summary;

use super::error::PresentError;
use crate::domain::analysis::{Conclusions, Metric};
use crate::domain::files::write_atomically;
use crate::domain::image::HdrImage;
use crate::domain::machine::Machine;
use crate::domain::record::{Invocation, Results, Run};
use crate::presenting::analysis::{bias_floors, splits};
use crate::presenting::output::{Tev, TevError};
use crate::presenting::table::Tables;
use std::path::Path;

/// Everything that a report shows.
#[derive(Clone, Debug)]
pub struct Report {
    /// The heading.
    pub title: String,
    /// The command that made it, so that anyone can make it again.
    pub command: String,
    /// The same, taken apart; `None` if it is not known.
    pub invocation: Option<Invocation>,
    /// Where it was measured, and with which build.
    pub machine: Machine,
    /// Seed of everything random; `None` if it is not known.
    pub seed: Option<u64>,
    /// All runs; they are grouped by scene and quantity in the order in which these first appear.
    pub runs: Vec<Run>,
    /// Images, a row per scene and quantity.
    pub rows: Vec<ImageRow>,
    /// What was concluded from the runs.
    pub conclusions: Vec<Tables>,
}

/// The program and the command's name.
fn title(invocation: Option<&Invocation>) -> String {
    let name = invocation.map_or("bench", |i| &i.verb);
    format!("interreflect {name}")
}

/// All that results say beyond their numbers.
fn conclusions(results: &Results) -> Vec<Tables> {
    let concluded = Conclusions::of(&results.runs, &results.baselines, Metric::Truth);
    let mut tables = concluded.tables();
    tables.extend(bias_floors(&results.floors));
    tables.extend(splits(&results.splits));
    tables
}

/// A reference image beside its estimates: one scene, one quantity, one camera.
#[derive(Clone, Debug)]
pub struct ImageRow {
    /// Name of the scene.
    pub scene: String,
    /// Name of the quantity, in snake case.
    pub quantity: String,
    /// The reference.
    pub reference: LabelledImage,
    /// The estimates, each of the reference's size.
    pub estimates: Vec<LabelledImage>,
    /// Which pixels show a surface; `None` if all do.
    pub surfaces: Option<Vec<bool>>,
}

/// An image with what is written under it.
#[derive(Clone, Debug)]
pub struct LabelledImage {
    /// What it is, such as `localized_cubemap, corrected`.
    pub label: String,
    /// What else matters: backend, sample count, error. May be empty.
    pub note: String,
    /// The run that it is the estimate of, as an index into [`Report::runs`].
    pub run: Option<usize>,
    /// Linear radiance or irradiance.
    pub image: HdrImage,
}

impl Report {
    /// The report of a bench.
    pub fn new(results: &Results, rows: Vec<ImageRow>) -> Self {
        Self {
            title: title(results.invocation.as_ref()),
            command: results.command.clone(),
            invocation: results.invocation.clone(),
            machine: results.machine.clone(),
            seed: results.seed,
            runs: results.runs.clone(),
            rows,
            conclusions: conclusions(results),
        }
    }

    /// Writes the report as one HTML file.
    ///
    /// # Errors
    /// [`PresentError`] if the images don't fit together or the file can't be written.
    pub fn write(&self, path: &Path) -> Result<(), PresentError> {
        Ok(write_atomically(path, self.html()?.as_bytes())?)
    }

    /// The report as HTML.
    ///
    /// # Errors
    /// [`PresentError`] if the images of a row don't fit together or can't be encoded.
    pub fn html(&self) -> Result<String, PresentError> {
        page::html(self)
    }

    /// Shows all images in tev, each row under the name of its scene and quantity.
    ///
    /// # Errors
    /// [`TevError`] if tev went away.
    pub fn show_in(&self, tev: &mut Tev) -> Result<(), TevError> {
        for row in &self.rows {
            let place = format!("{}/{}", row.scene, row.quantity);
            tev.show(&format!("{place}/truth"), &row.reference.image)?;
            for estimate in &row.estimates {
                let run = estimate.run.and_then(|i| self.runs.get(i));
                let variant = run.map(|run| names::variant(run, &self.runs));
                let variant = variant.as_ref().unwrap_or(&estimate.note);
                tev.show(
                    &format!("{place}/{}, {variant}", estimate.label),
                    &estimate.image,
                )?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
