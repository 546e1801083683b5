//! What a frame of glossy objects in a room takes, with everything that it needs.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::measured_run::amount_of;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::{Experiment, Item, Paper};
use super::CAPTURE;
use super::room;
use super::room::localized;
use crate::running::error::RunError;
use crate::running::view::Look;
use interreflect_estimators::Quantity;
use interreflect_scene::ReflectionLaw;
use serde::Serialize;
use std::time::Instant;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "szirmay-kalos.9",
    paper: Paper::SzirmayKalos,
    item: Item::Figure(9),
    title: "time of a frame of glossy objects",
    setup: &Game {
        scene: room(
            &["dragon"],
            &[
                ("ceiling", "green"),
                ("divider", "0.7"),
                ("block", "false"),
                ("reference.place", "room"),
                ("reference.offset", "0"),
                ("receivers", "2"),
                ("receiver.size", "0.5"),
                ("receiver.diffuse", "0.4"),
                ("receiver.specular", "0.4"),
                ("receiver.shininess", "5"),
            ],
        ),
        pixels: 700,
        resolution: 4,
        capture_resolution: CAPTURE,
        frames: 10,
    },
    claims: &[],
};

/// A scene, and the size of its picture.
#[derive(Serialize)]
pub(super) struct Game {
    pub(super) scene: SceneSetup,
    /// Pixels along the picture's edge.
    pub(super) pixels: u32,
    /// M, texels along a face's edge.
    pub(super) resolution: u32,
    /// Texels along a face's edge of the capture.
    pub(super) capture_resolution: u32,
    /// Frames that share a map.
    pub(super) frames: u32,
}

impl Runs for Game {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::GlossyRadiance;
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let width = context.pick(self.pixels / 2, self.pixels);
        let (mut times, mut view) = (Vec::new(), None);
        for _ in 0..3 {
            let start = Instant::now();
            view = Some(context.whole_view(&loaded, width, Look::default())?);
            times.push(1e3 * start.elapsed().as_secs_f64());
        }
        let Some(view) = view else {
            return Ok(finding);
        };
        let scale = f64::from(self.pixels / width).powi(2);
        let surfaces = amount_of(&times).times(scale);
        if scale > 1.0 {
            finding.note(format!(
                "shading and direct light are those of {width}×{width} pixels, times {scale}"
            ));
        }
        finding.note("surfaces seen are found by rays on the CPU, for both backends");
        finding.note(
            "the paper's reflectance has no factor 1/π, so that objects are brighter than the room, which is shown \
             in direct light alone",
        );
        let points = view.points(quantity.layout());
        let mut row = Row::plain("glossy objects");
        for backend in context.backends() {
            let texels = (self.resolution, self.capture_resolution);
            let method = localized(context, texels, "shader", &[])?;
            let run = context.run_timed(&loaded, backend, &*method, quantity, &points)?;
            let map = run.capture_ms().plus(run.prepare_ms());
            let by_lambert = (&view.seen(), ReflectionLaw::Lambert.into());
            let (light, direct) = context.direct_light_timed(&loaded, backend, by_lambert)?;
            let (shade, direct) = (run.shade_ms().times(scale), direct.times(scale));
            let rest = shade.plus(direct).plus(surfaces);
            let case = format!("{0}×{0} pixels", self.pixels);
            let unit = ("ms", context.software(backend));
            for (name, ms) in [
                ("capture".to_owned(), run.capture_ms()),
                ("prepare".to_owned(), run.prepare_ms()),
                ("shade".to_owned(), shade),
                ("surfaces seen".to_owned(), surfaces),
                ("direct light and shadows".to_owned(), direct),
                ("frame with a new map".to_owned(), rest.plus(map)),
                (
                    format!("frame with a map for {} frames", self.frames),
                    rest.plus(map.times(1.0 / f64::from(self.frames))),
                ),
            ] {
                finding.time((&*case, name), backend, ms, unit);
            }
            row.add(
                format!("direct and indirect light, {backend}"),
                view.lit(&run.estimate, &light),
            );
            finding.runs.push(run.run);
        }
        finding.pictures.push(row);
        Ok(finding)
    }
}
