//! Indirect light of few samples beside the truth, and beside a uniform ambient light.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::judge::{ERROR, Judge, scaled};
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::truth::References;
use crate::running::view::View;
use glam::{DVec3, Vec3};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::{Estimate, PointLayout, Points};
use std::f32::consts::FRAC_1_PI;

/// Least correlation of colours that passes for colour bleeding.
const ALIKE: f64 = 0.5;

/// Share of the truth's light that passes for comparable.
const ENOUGH: f64 = 0.5;

pub(super) fn cornell_box(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for lamp in ["area", "spot"] {
        let loaded = context.load(
            &ExperimentScene::of("cornell-box").set("light", lamp),
            &mut finding,
        )?;
        let view = context.view(&loaded)?;
        let points = view.points(Quantity::Irradiance.layout());
        let references = context.precise(&loaded, Quantity::Irradiance, &points);
        let case = format!("{lamp} light");
        let what = ("C1", &*case, &view, references);
        for light in compare(context, &loaded, what, &mut finding)? {
            finding.judge("C2", [enough(&case, &light)]);
            finding.judge("C3", [bleeds(&case, &light)]);
        }
    }
    Ok(finding)
}

pub(super) fn cave(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let loaded = context.load(&ExperimentScene::of("cave"), &mut finding)?;
    let view = context.view(&loaded)?;
    let points = view.points(Quantity::Irradiance.layout());
    let references = context.references(&loaded, Quantity::Irradiance, &points);
    let what = ("C1", "cave", &view, references);
    for light in compare(context, &loaded, what, &mut finding)? {
        finding.judge("C2", [enough("cave", &light)]);
    }
    Ok(finding)
}

/// That most of the truth's light arrives.
fn enough(case: &str, light: &Published) -> Trial {
    let what = format!("{case}: a half below the share of the truth's light");
    Trial::less(what, light.backend, Amount::exact(ENOUGH), light.energy)
}

/// That its colours are the truth's.
fn bleeds(case: &str, light: &Published) -> Trial {
    let what = format!("{case}: a half below the correlation of colours");
    Trial::less(what, light.backend, Amount::exact(ALIKE), light.alike)
}

/// That an estimate is nearer to the truth than no indirect light and, up to a factor on its brightness, than
/// uniform ambient light.
fn nearer(
    judge: &Judge<'_>,
    (case, backend): (&str, Backend),
    estimate: &Estimate,
    ambient: &Estimate,
) -> [Trial; 2] {
    let none = Estimate::new(estimate.len());
    let bright = scaled(estimate, judge.factor(estimate));
    let than_none = format!("{case}: nearer than direct light alone");
    let than_ambient = format!("{case}: nearer than uniform ambient light");
    [
        judge.nearer(than_none, backend, estimate, &none),
        judge.nearer(than_ambient, backend, &bright, ambient),
    ]
}

/// Light of the published map on a backend.
pub(super) struct Published {
    backend: Backend,
    /// Its sum over the truth's.
    energy: Amount,
    /// Correlation of its colours with the truth's.
    alike: Amount,
}

/// Compares maps of 3×3 samples in a scene that is set up with the truth and a uniform ambient light; its trials are
/// of a claim.
pub(super) fn compare(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    (claim, case, view, mut references): (&'static str, &str, &View, References<'_>),
    finding: &mut Finding,
) -> Result<Vec<Published>, RunError> {
    let mut published = Vec::new();
    let quantity = Quantity::Irradiance;
    let points = view.points(quantity.layout());
    let materials = view.points(PointLayout::Material);
    let truth = references.truth();
    let judge = Judge::new(truth, &points);
    let ambient = uniform(&truth.values, &points);
    let first = context.backends()[0];
    let direct = context.direct_light(loaded, first, view)?;
    let lit = |e: &Estimate| view.lit(&reflected(&materials, e), &direct);
    let title = format!("{case}: direct and indirect light");
    let mut row = Row::against(title, "path tracing", lit(&truth.values), view.surfaces());
    row.add(
        "direct light alone",
        view.lit(&Estimate::new(points.len()), &direct),
    );
    row.add("best uniform ambient light", lit(&ambient));
    let mut alone = Row::plain(format!("{case}: indirect light alone"));
    alone.add(
        "path tracing",
        view.image(&reflected(&materials, &truth.values)),
    );
    for backend in context.backends() {
        for fidelity in ["published", "corrected"] {
            let map = context.method("direct_radiance_map", &[("fidelity", &fidelity)])?;
            let measured = context.run_once(loaded, backend, &*map, quantity, &points)?;
            let estimate = &measured.estimate;
            let alike = Amount::exact(correlation(estimate, &truth.values));
            let energy =
                Amount::exact(sum(estimate).element_sum() / sum(&truth.values).element_sum());
            let error = judge.error(estimate);
            for (name, amount) in [
                (ERROR, error),
                ("energy", energy),
                ("correlation of colours", alike),
            ] {
                finding.measure((format!("{case}, {fidelity}"), name), backend, amount, "");
            }
            if backend == context.backends()[0] {
                row.add(fidelity, lit(estimate));
                alone.add(fidelity, view.image(&reflected(&materials, estimate)));
            }
            if fidelity == "published" {
                let trials = nearer(&judge, (case, backend), estimate, &ambient);
                finding.judge(claim, trials);
                published.push(Published {
                    backend,
                    energy,
                    alike,
                });
            }
            finding.runs.push(measured.run);
        }
    }
    let at = (format!("{case}, uniform ambient light"), ERROR);
    finding.measure(at, context.backends()[0], judge.error(&ambient), "");
    finding.pictures.extend([row, alone]);
    Ok(published)
}

/// The same colour at every point that has a surface: the mean of all.
pub(super) fn uniform(of: &Estimate, points: &Points) -> Estimate {
    let surfaces: Vec<usize> = (0..points.len())
        .filter(|&i| points.get(i).is_some())
        .collect();
    let total: DVec3 = surfaces.iter().map(|&i| of.get(i).as_dvec3()).sum();
    let mean = (total / surfaces.len().max(1) as f64).as_vec3();
    let mut all = Estimate::new(of.len());
    for i in surfaces {
        all.set(i, mean);
    }
    all
}

/// What diffuse surfaces reflect of an irradiance.
pub(super) fn reflected(materials: &Points, irradiance: &Estimate) -> Estimate {
    let mut all = Estimate::new(irradiance.len());
    for (i, point) in materials.iter().enumerate() {
        let albedo = point.map_or(Vec3::ZERO, |p| p.material.diffuse);
        all.set(i, irradiance.get(i) * albedo * FRAC_1_PI);
    }
    all
}

fn sum(estimate: &Estimate) -> DVec3 {
    estimate.iter().map(|v| v.as_dvec3()).sum()
}

/// Pearson's correlation of red less green over their sum, weighted by the second one's sum: colours of
/// what is nearly black are noise.
pub(super) fn correlation(a: &Estimate, b: &Estimate) -> f64 {
    let colour = |v: Vec3| {
        let v = v.as_dvec3();
        let sum = v.x + v.y;
        (sum > 0.0).then(|| ((v.x - v.y) / sum, sum))
    };
    let pairs = a.iter().zip(b.iter()).filter_map(|(a, b)| {
        let (a, (b, weight)) = (colour(a)?.0, colour(b)?);
        Some((a, b, weight))
    });
    let pairs: Vec<(f64, f64, f64)> = pairs.collect();
    let total: f64 = pairs.iter().map(|p| p.2).sum();
    let mean =
        |f: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|p| p.2 * f(p.0, p.1)).sum::<f64>() / total;
    let (ma, mb) = (mean(&|a, _| a), mean(&|_, b| b));
    let covariance = mean(&|a, b| (a - ma) * (b - mb));
    covariance / (mean(&|a, _| (a - ma).powi(2)) * mean(&|_, b| (b - mb).powi(2))).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{exact, of, signs};
    use super::*;
    use interreflect_scene::Point;

    #[test]
    fn light_has_to_beat_none_and_ambient_and_to_arrive_in_its_colours() {
        let truth = of(&[1.0, 2.0, 3.0, 2.0]);
        let (judge, ambient) = (exact(&truth), of(&[2.0; 4]));
        let judged =
            |estimate: &Estimate| signs(&nearer(&judge, ("", Backend::Cpu), estimate, &ambient));
        // Half as bright but of the right shape; then so bright that nothing would be nearer; then upside down.
        assert_eq!(judged(&of(&[0.5, 1.0, 1.5, 1.0])), "++");
        assert_eq!(judged(&of(&[9.0, 18.0, 27.0, 18.0])), "-+");
        assert_eq!(judged(&of(&[3.0, 2.0, 1.0, 2.0])), "+-");
        let light = |energy, alike| Published {
            backend: Backend::Gpu,
            energy: Amount::exact(energy),
            alike: Amount::exact(alike),
        };
        let both = |light: &Published| signs([&enough("", light), &bleeds("", light)]);
        assert_eq!(both(&light(0.51, 0.49)), "+-");
        assert_eq!(both(&light(0.49, 0.51)), "-+");
    }

    #[test]
    fn ambient_light_is_the_mean_and_diffuse_surfaces_reflect_by_pi() {
        let at = |albedo| {
            Some(Point {
                normal: Vec3::Y,
                material: interreflect_scene::SurfaceMaterial {
                    diffuse: Vec3::splat(albedo),
                    ..Default::default()
                },
                ..Point::default()
            })
        };
        let points = Points::new(PointLayout::Material, [at(0.5), None, at(0.25)]);
        let mean = uniform(&of(&[1.0, 7.0, 3.0]), &points);
        let found: Vec<f32> = mean.iter().map(|v| v.y).collect();
        assert_eq!(found, [2.0, 0.0, 2.0]);
        let pi = std::f32::consts::PI;
        let lit = reflected(&points, &of(&[pi, pi, 4.0 * pi]));
        for (found, expected) in lit.iter().zip([0.5, 0.0, 1.0]) {
            assert!((found.x - expected).abs() < 1e-6, "{found}");
        }
        assert_eq!(sum(&of(&[1.0, 2.0])), DVec3::splat(3.0));
    }

    #[test]
    fn opposite_colours_correlate_negatively() {
        let (mut a, mut b) = (Estimate::new(3), Estimate::new(3));
        for (i, share) in [0.2_f32, 0.5, 0.8].into_iter().enumerate() {
            a.set(i, Vec3::new(share, 1.0 - share, 0.0));
            b.set(i, Vec3::new(1.0 - share, share, 0.0));
        }
        assert!((correlation(&a, &b) + 1.0).abs() < 1e-6);
    }

    #[test]
    fn colours_correlate_whatever_their_brightness() {
        let (mut a, mut b) = (Estimate::new(4), Estimate::new(4));
        for i in 0..4 {
            let red = i as f32;
            a.set(i, Vec3::new(red, 3.0, 0.0));
            b.set(i, Vec3::new(red, 3.0, 1.0) * (1.0 + red));
        }
        assert!((correlation(&a, &b) - 1.0).abs() < 1e-9);
    }
}
