//! Models with a Fresnel term and a bias each, some of several parts.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::heights::heights;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::biased;
use super::studio;
use super::{GLOSSY, PIXELS, RESOLUTION};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::Look;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, PointLayout, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.3",
    paper: Paper::Kautz,
    item: Item::Figure(3),
    title: "three models, each of its own f_λ and b",
    setup: &Models {
        models: [
            Model {
                scene: studio(&["bunny"], GLOSSY),
                f_lambda: 0.05,
                biases: &[2.3],
            },
            Model {
                scene: studio(&["bust"], GLOSSY),
                f_lambda: 0.24,
                biases: &[1.5],
            },
            Model {
                scene: studio(&["car"], GLOSSY),
                f_lambda: 0.15,
                biases: &[0.2, 3.3],
            },
        ],
        pixels: PIXELS,
        resolution: RESOLUTION,
    },
    claims: &[Claim {
        id: "C1",
        says: "All models are shown at more than 100 Hz.",
        rule: "A trial is a model and a backend: preparing the maps and shading all points of the picture \
            takes less than 10 ms, beyond the spread of both. The picture has 512×512 pixels: the paper \
            does not say how many. Times on a software adapter say nothing of a graphics card.",
    }],
};

/// A model under an environment.
#[derive(Serialize)]
pub(super) struct Model {
    pub(super) scene: SceneSetup,
    /// f_λ.
    pub(super) f_lambda: f64,
    /// b of each of the model's parts, from below; parts are of equal height.
    pub(super) biases: &'static [f64],
}

/// The figure's models.
#[derive(Serialize)]
pub(super) struct Models {
    pub(super) models: [Model; 3],
    /// Pixels along a picture's edge.
    pub(super) pixels: u32,
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
}

/// Milliseconds of a frame at 100 Hz.
const FRAME_MS: f64 = 10.0;

impl Runs for Models {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for model in &self.models {
            self.show(context, model, &mut finding)?;
        }
        Ok(finding)
    }
}

impl Models {
    fn show(
        &self,
        context: &ExperimentContext<'_>,
        model: &Model,
        finding: &mut Finding,
    ) -> Result<(), RunError> {
        let loaded = context.load(&context.place(&model.scene), finding)?;
        let width = context.pick(self.pixels / 2, self.pixels);
        let scale = f64::from(self.pixels / width).powi(2);
        if scale > 1.0 {
            finding.note(format!(
                "shading is that of {width}×{width} pixels, times {scale}"
            ));
        }
        let view = context.whole_view(&loaded, width, Look::default())?;
        let points = view.points(PointLayout::Material);
        let parts = parts(&points, model.biases.len());
        let case = model.scene.models.join(" ");
        let mut row = Row::plain(format!("{case}, f_λ = {}", model.f_lambda));
        for backend in context.backends() {
            let mut all = Estimate::new(points.len());
            // The map is made once for all parts.
            let (mut prepare, mut shade) = (Amount::exact(0.0), Amount::exact(0.0));
            for (part, &bias) in parts.iter().zip(model.biases) {
                let own = Points::new(points.layout(), part.iter().map(|&i| points.get(i)));
                let method = biased(context, self.resolution, bias, model.f_lambda)?;
                let quantity = Quantity::GlossyRadiance;
                let run = context.run_timed(&loaded, backend, &*method, quantity, &own)?;
                for (k, &i) in part.iter().enumerate() {
                    all.set(i, run.estimate.get(k));
                }
                prepare = run.prepare_ms();
                shade = shade.plus(run.shade_ms().times(scale));
                finding.runs.push(run.run);
            }
            let frame = prepare.plus(shade);
            let unit = ("ms", context.software(backend));
            for (name, ms) in [("prepare", prepare), ("shade", shade), ("frame", frame)] {
                finding.time((&*case, name), backend, ms, unit);
            }
            finding.judge("C1", [fast(&case, backend, frame)]);
            let biases: Vec<_> = model.biases.iter().map(f64::to_string).collect();
            row.add(
                format!("b = {}, {backend}", biases.join(" and ")),
                view.lit(&all, &context.direct_light(&loaded, backend, &view)?),
            );
        }
        finding.pictures.push(row);
        Ok(())
    }
}

/// That a frame takes less than 10 ms.
fn fast(case: &str, backend: Backend, frame: Amount) -> Trial {
    let what = format!("{case}: frame below {FRAME_MS} ms");
    Trial::less(what, backend, frame, Amount::exact(FRAME_MS))
}

/// Indices of the points in so many parts of equal height, from below.
fn parts(points: &Points, count: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new(); count];
    for (i, share) in heights(points) {
        let part = (share * count as f64) as usize;
        all[part.min(count - 1)].push(i);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;
    use glam::Vec3;
    use interreflect_scene::Point;

    #[test]
    fn a_frame_has_to_take_less_than_ten_milliseconds() {
        let judged = |ms| signs([&fast("", Backend::Cpu, about(ms))]);
        assert_eq!(
            [8.0, 12.0, 10.5].map(judged),
            ["+".to_owned(), "-".to_owned(), "?".to_owned()]
        );
    }

    #[test]
    fn parts_are_of_equal_height() {
        let at = |y: f32| {
            Some(Point {
                position: Vec3::Y * y,
                ..Point::default()
            })
        };
        let points = Points::new(
            PointLayout::Surface,
            [at(-1.0), at(1.0), None, at(0.4), at(-0.2)],
        );
        assert_eq!(parts(&points, 2), [vec![0, 4], vec![1, 3]]);
        assert_eq!(parts(&points, 1), [vec![0, 1, 3, 4]]);
    }
}
