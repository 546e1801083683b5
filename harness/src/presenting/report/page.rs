//! The page: templates, style and scripts put together.

use super::{Report, pictures, summary};
use crate::domain::machine::Machine;
use crate::domain::metrics::{FORMULAS, Formula};
use crate::presenting::error::PresentError;
use crate::presenting::output::colour_stops;
use minijinja::{syntax::SyntaxConfig, value::Serde};
use serde::Serialize;

/// The page's parts; the first is the whole that names the others.
const TEMPLATES: [(&str, &str); 7] = [
    ("page.html", include_str!("html/page.html")),
    ("provenance.html", include_str!("html/provenance.html")),
    ("matrix.html", include_str!("html/matrix.html")),
    ("viewer.html", include_str!("html/viewer.html")),
    ("plots.html", include_str!("html/plots.html")),
    ("runs.html", include_str!("html/runs.html")),
    ("formulas.html", include_str!("html/formulas.html")),
];

/// The scripts, in the order in which they build on each other; together they are one module.
const SCRIPTS: [&str; 5] = [
    include_str!("js/pixels.js"),
    include_str!("js/colour.js"),
    include_str!("js/canvas.js"),
    include_str!("js/viewer.js"),
    include_str!("js/page.js"),
];

/// What the templates see.
#[derive(Serialize)]
struct Page<'a> {
    title: &'a str,
    command: &'a str,
    machine: &'a Machine,
    seed: Option<u64>,
    adapter: String,
    commit: String,
    dev_build: bool,
    software: bool,
    counts: summary::Counts,
    sections: Vec<summary::Section>,
    matrix: pictures::Matrix,
    blocks: Vec<pictures::Block>,
    viewer: String,
    formulas: &'static [Formula],
    colour_stops: String,
    style: &'static str,
    scripts: String,
}

/// The report as HTML.
pub(super) fn html(report: &Report) -> Result<String, PresentError> {
    let images = pictures::images(report)?;
    let viewer = serde_json::to_string(&images.viewer).unwrap_or_default();
    let page = Page {
        title: &report.title,
        command: &report.command,
        machine: &report.machine,
        seed: report.seed,
        adapter: report.machine.adapter_label(),
        commit: report.machine.commit_label(),
        dev_build: report.machine.versions.profile == "dev",
        software: report.runs.iter().any(|r| r.software),
        counts: summary::Counts::of(&report.runs),
        sections: summary::sections(report)?,
        matrix: images.matrix,
        blocks: images.blocks,
        // A name can hold the end of a script element.
        viewer: viewer.replace('<', "\\u003c"),
        formulas: FORMULAS,
        colour_stops: colour_stops().collect::<Vec<_>>().join(", "),
        style: include_str!("page.css"),
        scripts: SCRIPTS.concat(),
    };
    let mut environment = minijinja::Environment::new();
    environment.set_syntax(
        SyntaxConfig::builder()
            .trim_blocks(true)
            .lstrip_blocks(true)
            .build()?,
    );
    for (name, source) in TEMPLATES {
        environment.add_template(name, source)?;
    }
    let whole = environment.get_template(TEMPLATES[0].0)?;
    Ok(whole.render(Serde(page))?)
}
