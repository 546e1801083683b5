//! `report.html`: one file that shows what was measured, without scripts or other files.
//!
//! A summary table of all runs by scene and quantity, the trade of time for error as a plot for
//! each, and rows of images: reference, estimates, and maps of their signed errors on one scale.

mod pictures;
mod plot;
mod summary;

use crate::{
    machine::Machine,
    output::{HdrImage, OutputError, colour_stops, write_atomically},
    record::Run,
};
use minijinja::{syntax::SyntaxConfig, value::Serde};
use serde::Serialize;
use std::path::Path;

/// Everything that a report shows.
#[derive(Clone, Debug)]
pub struct Report {
    /// The heading.
    pub title: String,
    /// The command that made it, so that anyone can make it again.
    pub command: String,
    /// Where it was measured, and with which build.
    pub machine: Machine,
    /// All runs; they are grouped by scene and quantity in the order in which these first appear.
    pub runs: Vec<Run>,
    /// Images, a row per scene and quantity.
    pub rows: Vec<ImageRow>,
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
    /// Linear radiance or irradiance.
    pub image: HdrImage,
}

impl Report {
    /// Writes the report as one HTML file.
    ///
    /// # Errors
    /// [`ReportError`] if the images don't fit together or the file can't be written.
    pub fn write(&self, path: &Path) -> Result<(), ReportError> {
        Ok(write_atomically(path, self.html()?.as_bytes())?)
    }

    /// The report as HTML.
    ///
    /// # Errors
    /// [`ReportError`] if the images of a row don't fit together or can't be encoded.
    pub fn html(&self) -> Result<String, ReportError> {
        let rows: Result<Vec<_>, _> = self.rows.iter().map(pictures::row).collect();
        let page = Page {
            title: &self.title,
            command: &self.command,
            machine: &self.machine,
            adapter: self.machine.adapter_label(),
            commit: self.machine.commit_label(),
            dev_build: self.machine.versions.profile == "dev",
            software: self.runs.iter().any(|r| r.software),
            counts: summary::Counts::of(&self.runs),
            sections: summary::sections(&self.runs, rows?),
            colour_stops: colour_stops().collect::<Vec<_>>().join(", "),
        };
        let mut environment = minijinja::Environment::new();
        environment.set_syntax(
            SyntaxConfig::builder()
                .trim_blocks(true)
                .lstrip_blocks(true)
                .build()?,
        );
        environment.add_template("report.html", include_str!("report.html"))?;
        Ok(environment
            .get_template("report.html")?
            .render(Serde(page))?)
    }
}

/// What the template sees.
#[derive(Serialize)]
struct Page<'a> {
    title: &'a str,
    command: &'a str,
    machine: &'a Machine,
    adapter: String,
    commit: String,
    dev_build: bool,
    software: bool,
    counts: summary::Counts,
    sections: Vec<summary::Section>,
    colour_stops: String,
}

/// Why a report could not be made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// An image of a row has another size than the row's reference.
    #[error(
        "{scene}: `{label}` is {width} × {height} pixels, its reference is not: render both alike"
    )]
    Size {
        /// The scene.
        scene: String,
        /// The image.
        label: String,
        /// Its width.
        width: usize,
        /// Its height.
        height: usize,
    },
    /// The file or one of the pictures can't be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The template is at fault.
    #[error("can't lay out the report: {0}")]
    Template(#[from] minijinja::Error),
}

#[cfg(test)]
mod tests;
