//! Pictures over the Fresnel term and the bias on the mip level.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::measured_run::amount_of;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::biased;
use super::studio;
use super::{GLOSSY, PIXELS, RESOLUTION};
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use crate::running::view::{Look, View};
use glam::Vec3;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Estimate, Point, PointLayout, Points, SurfaceMaterial};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.6",
    paper: Paper::Kautz,
    item: Item::Figure(6),
    title: "a grid over f_λ and b",
    setup: &Grid {
        scene: studio(&["buddha"], GLOSSY),
        f_lambda: [0.03, 0.09, 0.26, 0.42],
        bias: [0.0, 0.8, 1.7, 2.4],
        resolution: RESOLUTION,
        pixels: PIXELS,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "A larger f_λ is more reflective.",
            rule: "A trial is a step of f_λ, a b and a backend: the picture is farther from that of \
                f_λ = 0, rms.",
        },
        Claim {
            id: "C2",
            says: "A larger b is blurrier.",
            rule: "A trial is a step of b, an f_λ and a backend: neighbouring pixels differ less, over \
                their mean, in a picture of the mirrored light alone.",
        },
        Claim {
            id: "C3",
            says: "The frame rate is the same over the grid.",
            rule: "A trial is a picture and a backend: a frame under light that stays takes less than \
                1.25 times the median over the grid, beyond the spread of both. All pictures' frames \
                are taken in turns.",
        },
    ],
};

/// A model under an environment, and the grid.
#[derive(Serialize)]
pub(super) struct Grid {
    pub(super) scene: SceneSetup,
    /// f_λ, across.
    pub(super) f_lambda: [f64; 4],
    /// b, down.
    pub(super) bias: [f64; 4],
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
    /// Pixels along a picture's edge, whatever the effort: the hardware's level rises where pixels are larger.
    pub(super) pixels: u32,
}

/// Nothing moves.
const RESTING: Moves = Moves {
    geometry: false,
    camera: false,
    lights: false,
    environment: false,
};

/// Largest factor between frame times that are the same.
const SAME: f64 = 1.25;

/// A picture of the grid with its session and the times of its frames.
struct Cell {
    case: String,
    method: Box<dyn Configured>,
    running: Sequence,
    ms: Vec<f64>,
    picture: Estimate,
}

impl Runs for Grid {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = context.whole_view(&loaded, self.pixels, Look::default())?;
        let points = view.points(PointLayout::Material);
        let mirroring = mirroring(&points);
        let quantity = Quantity::GlossyRadiance;
        for backend in context.backends() {
            let mut cells = self.cells(context, points.len())?;
            // In turns, so that other load meets all alike; the first frame warms up.
            for frame in 0..=context.pick(4, 12) {
                for cell in &mut cells {
                    let on = (&mut cell.running, backend);
                    let seen = (&points, None, RESTING);
                    let shaded = context.frame(&loaded, on, &*cell.method, quantity, seen)?;
                    if frame > 0 {
                        cell.ms.push(shaded.ms);
                    }
                    cell.picture = shaded.estimate;
                }
            }
            let unit = ("ms", context.software(backend));
            for cell in &cells {
                finding.time((&*cell.case, "frame"), backend, amount_of(&cell.ms), unit);
            }
            let times: Vec<_> = cells.iter().map(|c| (&*c.case, amount_of(&c.ms))).collect();
            finding.judge("C3", alike(backend, &times));
            let (mut sharp, mut gloss) = (Vec::new(), Vec::new());
            for (row, bias) in cells.chunks(self.f_lambda.len()).zip(self.bias) {
                let method = biased(context, self.resolution, bias, 0.0)?;
                let plain = context.run_once(&loaded, backend, &*method, quantity, &points)?;
                let from = Judge::at(&plain.estimate, None, (0..points.len()).collect());
                let away = |cell: &Cell| from.relative_rms(&cell.picture).value;
                let (mut sharp_row, away): (Vec<f64>, Vec<f64>) =
                    (Vec::new(), row.iter().map(away).collect());
                for (cell, away) in row.iter().zip(&away) {
                    let mirrored =
                        context.run_once(&loaded, backend, &*cell.method, quantity, &mirroring)?;
                    let sharpness = sharpness(&view.surfaces(), &view.image(&mirrored.estimate));
                    for (name, value) in [
                        ("difference of neighbours / mean, mirrored light", sharpness),
                        ("rms from f_λ = 0 / mean", *away),
                    ] {
                        finding.measure((&*cell.case, name), backend, Amount::exact(value), "");
                    }
                    sharp_row.push(sharpness);
                    finding.runs.push(mirrored.run);
                }
                sharp.push(sharp_row);
                gloss.push(away);
                if backend == context.backends()[0] {
                    let direct = context.direct_light(&loaded, backend, &view)?;
                    finding.pictures.push(self.row((&view, &direct), bias, row));
                }
            }
            let (stronger, blurrier) = self.judged(backend, &sharp, &gloss);
            finding.judge("C1", stronger);
            finding.judge("C2", blurrier);
        }
        Ok(finding)
    }
}

impl Grid {
    fn cells(&self, context: &ExperimentContext<'_>, points: usize) -> Result<Vec<Cell>, RunError> {
        let pairs = self.bias.into_iter();
        let pairs = pairs.flat_map(|bias| self.f_lambda.into_iter().map(move |f| (bias, f)));
        pairs
            .map(|(bias, f_lambda)| {
                Ok(Cell {
                    case: format!("b = {bias}, f_λ = {f_lambda}"),
                    method: biased(context, self.resolution, bias, f_lambda)?,
                    running: Sequence::default(),
                    ms: Vec::new(),
                    picture: Estimate::new(points),
                })
            })
            .collect()
    }

    fn row(&self, (view, direct): (&View, &Estimate), bias: f64, row: &[Cell]) -> Row {
        let mut pictures = Row::plain(format!("b = {bias}"));
        for (cell, f) in row.iter().zip(self.f_lambda) {
            pictures.add(format!("f_λ = {f}"), view.lit(&cell.picture, direct));
        }
        pictures
    }

    /// That pictures gain distance from that of f_λ = 0 with each step of f_λ, and lose sharpness with each step of b; a
    /// list of both for each b, over f_λ.
    fn judged(
        &self,
        backend: Backend,
        sharp: &[Vec<f64>],
        gloss: &[Vec<f64>],
    ) -> (Vec<Trial>, Vec<Trial>) {
        let (mut stronger, mut blurrier) = (Vec::new(), Vec::new());
        for (row, b) in gloss.iter().zip(self.bias) {
            for (pair, f) in row.windows(2).zip(self.f_lambda.windows(2)) {
                let what = format!("b = {b}: f_λ = {} nearer to 0's than {}", f[0], f[1]);
                stronger.push(Trial::less_by(what, backend, (pair[0], pair[1]), 0.0));
            }
        }
        for (pair, b) in sharp.windows(2).zip(self.bias.windows(2)) {
            for (i, f) in self.f_lambda.into_iter().enumerate() {
                let what = format!(
                    "f_λ = {f}: neighbours at b = {} differ less than at {}",
                    b[1], b[0]
                );
                blurrier.push(Trial::less_by(what, backend, (pair[1][i], pair[0][i]), 0.0));
            }
        }
        (stronger, blurrier)
    }
}

/// That each frame takes less than a quarter more than the median of all.
fn alike(backend: Backend, times: &[(&str, Amount)]) -> Vec<Trial> {
    let all: Vec<f64> = times.iter().map(|(_, ms)| ms.value).collect();
    let usual = amount_of(&all);
    let below = |(case, ms): &(&str, Amount)| {
        let what = format!("{case}: frame below {SAME} times the median over the grid, ms");
        Trial::less(what, backend, *ms, usual.times(SAME))
    };
    times.iter().map(below).collect()
}

/// The same points without their diffuse part.
fn mirroring(points: &Points) -> Points {
    let mirroring = |point: Point| Point {
        material: SurfaceMaterial {
            diffuse: Vec3::ZERO,
            ..point.material
        },
        ..point
    };
    Points::new(
        points.layout(),
        points.iter().map(|point| point.map(mirroring)),
    )
}

/// Mean difference of neighbouring pixels that both show the surface, over their mean.
fn sharpness(surface: &[bool], image: &HdrImage) -> f64 {
    let (mut difference, mut sum) = (0.0, 0.0);
    for i in 0..image.pixels.len() {
        let right = ((i + 1) % image.width != 0).then_some(i + 1);
        let below = Some(i + image.width).filter(|b| *b < image.pixels.len());
        for j in [right, below]
            .into_iter()
            .flatten()
            .filter(|&j| surface[i] && surface[j])
        {
            let (a, b) = (image.pixels[i], image.pixels[j]);
            difference += f64::from((a - b).abs().element_sum());
            sum += f64::from((a + b).element_sum()) / 2.0;
        }
    }
    difference / sum
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn strength_rises_with_f_and_blur_with_b_in_the_same_time() {
        let grid = Grid {
            scene: SceneSetup::of("studio"),
            f_lambda: [0.03, 0.09, 0.26, 0.42],
            bias: [0.0, 0.8, 1.7, 2.4],
            resolution: 256,
            pixels: 512,
        };
        let rows = |value: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
            (0..4)
                .map(|b| (0..4).map(|f| value(b, f)).collect())
                .collect()
        };
        let judged = |up: f64| {
            let gloss = rows(&|_, f| 10.0 + up * f as f64);
            let sharp = rows(&|b, _| 10.0 - up * b as f64);
            let (stronger, blurrier) = grid.judged(Backend::Cpu, &sharp, &gloss);
            (signs(&stronger), signs(&blurrier))
        };
        assert_eq!(judged(1.0), ("+".repeat(12), "+".repeat(12)));
        assert_eq!(judged(-1.0), ("-".repeat(12), "-".repeat(12)));
        let times = [10.0, 10.0, 10.0, 12.0, 13.0].map(|ms| ("", Amount::exact(ms)));
        assert_eq!(signs(&alike(Backend::Cpu, &times)), "++++-");
    }

    /// 1 2 / 3 5, the last without a surface: |1 − 2| and |1 − 3| over 1.5 and 2.
    #[test]
    fn sharpness_is_the_difference_of_neighbours_on_the_surface() {
        let pixels = [1.0, 2.0, 3.0, 5.0].map(Vec3::splat).to_vec();
        let image = HdrImage {
            width: 2,
            height: 2,
            pixels,
        };
        let found = sharpness(&[true, true, true, false], &image);
        assert!((found - 3.0 / 3.5).abs() < 1e-6, "{found}");
    }
}
