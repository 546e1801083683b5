//! Pictures over the bias on the mip level and the Fresnel term.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::View;
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, PointLayout};

const BIASES: [f32; 4] = [-2.0, 0.0, 2.0, 4.0];

const F_LAMBDAS: [f32; 3] = [0.1, 0.4, 0.9];

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let environment = context.assets().environment("blender_courtyard");
    if environment.is_none() {
        finding.note("blender_courtyard not found: the library's sky in its place");
    }
    let place = ExperimentScene::of("studio")
        .with(&context.mesh("buddha"))
        .under(environment)
        .set("receiver.diffuse", 0.4)
        .set("receiver.specular", 0.6);
    let loaded = context.load(&place, &mut finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(PointLayout::Material);
    for backend in context.backends() {
        let mut shoot = |bias: f32, f_lambda: f32| {
            let method = context.method(
                "sh_mip_envmap",
                &[
                    ("resolution", &256),
                    ("lod_mode", &"bias"),
                    ("lod", &bias),
                    ("f_lambda", &f_lambda),
                ],
            )?;
            let measured = context.run_once(
                &loaded,
                backend,
                &*method,
                Quantity::GlossyRadiance,
                &points,
            )?;
            finding.runs.push(measured.run);
            Ok::<_, RunError>(measured.estimate)
        };
        let mut plain = Vec::new();
        for bias in BIASES {
            plain.push(shoot(bias, 0.0)?);
        }
        let mut rows = Vec::new();
        for f_lambda in F_LAMBDAS {
            let mut row = Vec::new();
            for bias in BIASES {
                row.push(shoot(bias, f_lambda)?);
            }
            rows.push(row);
        }
        judge(&view, (&plain, &rows), backend, &mut finding);
        if backend == context.backends()[0] {
            finding.pictures.extend(
                rows.iter()
                    .zip(F_LAMBDAS)
                    .map(|(row, f)| pictures(&view, row, f)),
            );
        }
    }
    Ok(finding)
}

fn judge(
    view: &View,
    (plain, rows): (&[Estimate], &[Vec<Estimate>]),
    backend: Backend,
    finding: &mut Finding,
) {
    let mut gloss: Vec<Vec<f64>> = Vec::new();
    let mut sharpness_of: Vec<Vec<f64>> = Vec::new();
    for (row, f) in rows.iter().zip(F_LAMBDAS) {
        let sharp: Vec<f64> = row
            .iter()
            .map(|e| sharpness(&view.surfaces(), &view.image(e)))
            .collect();
        let away = |(e, p): (&Estimate, &Estimate)| {
            Judge::at(p, None, (0..p.len()).collect())
                .relative_rms(e)
                .value
        };
        gloss.push(row.iter().zip(plain).map(away).collect());
        for (i, b) in BIASES.into_iter().enumerate() {
            let case = format!("b = {b}, f_λ = {f}");
            let away = gloss.last().map_or(0.0, |g| g[i]);
            finding.measure(
                (&*case, "difference of neighbours / mean"),
                backend,
                Amount::exact(sharp[i]),
                "",
            );
            finding.measure(
                (&*case, "rms from f_λ = 0 / mean"),
                backend,
                Amount::exact(away),
                "",
            );
        }
        sharpness_of.push(sharp);
    }
    let (blurrier, stronger) = judged(backend, &sharpness_of, &gloss);
    finding.judge("C1", stronger);
    finding.judge("C2", blurrier);
}

/// That pictures lose sharpness with each step of b, and gain distance from that of f_λ = 0 with each step
/// of f_λ; a list of both for each f_λ, over b.
fn judged(backend: Backend, sharp: &[Vec<f64>], gloss: &[Vec<f64>]) -> (Vec<Trial>, Vec<Trial>) {
    let (mut blurrier, mut stronger) = (Vec::new(), Vec::new());
    for (sharp, f) in sharp.iter().zip(F_LAMBDAS) {
        for i in 1..BIASES.len() {
            let what = format!(
                "f_λ = {f}: neighbours at b = {} differ less than at {}",
                BIASES[i],
                BIASES[i - 1]
            );
            blurrier.push(Trial::less_by(what, backend, (sharp[i], sharp[i - 1]), 0.0));
        }
    }
    for (i, b) in BIASES.into_iter().enumerate() {
        for f in 1..F_LAMBDAS.len() {
            let what = format!(
                "b = {b}: f_λ = {} nearer to 0's than {}",
                F_LAMBDAS[f - 1],
                F_LAMBDAS[f]
            );
            let pair = (gloss[f - 1][i], gloss[f][i]);
            stronger.push(Trial::less_by(what, backend, pair, 0.0));
        }
    }
    (blurrier, stronger)
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

fn pictures(view: &View, row: &[Estimate], f_lambda: f32) -> Row {
    let mut pictures = Row::plain(format!("f_λ = {f_lambda}"));
    for (estimate, bias) in row.iter().zip(BIASES) {
        pictures.add(format!("b = {bias}"), view.image(estimate));
    }
    pictures
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;
    use glam::Vec3;

    #[test]
    fn blur_rises_with_b_and_strength_with_f() {
        let rows = |values: [[f64; 4]; 3]| values.map(|row| row.to_vec());
        let falling = rows([[4.0, 3.0, 2.0, 1.0]; 3]);
        let rising = rows([[1.0; 4], [2.0; 4], [3.0; 4]]);
        let (blurrier, stronger) = judged(Backend::Cpu, &falling, &rising);
        assert_eq!(
            (signs(&blurrier), signs(&stronger)),
            ("+".repeat(9), "+".repeat(8))
        );
        let (sharper, weaker) = (
            rows([[1.0, 2.0, 3.0, 4.0]; 3]),
            rows([[3.0; 4], [2.0; 4], [1.0; 4]]),
        );
        let (blurrier, stronger) = judged(Backend::Cpu, &sharper, &weaker);
        assert_eq!(
            (signs(&blurrier), signs(&stronger)),
            ("-".repeat(9), "-".repeat(8))
        );
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
