//! The pictures from the lights, texel by texel.

use super::super::experiment_context::ExperimentContext;
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::InCode;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::steps::BOX;
use crate::domain::image::HdrImage;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::rsms;
use glam::{DVec3, Vec3};
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::RsmImage;
use interreflect_scene::rsm::view_index;
use serde::Serialize;
use std::f32::consts::FRAC_1_PI;

pub(super) const FIGURE_6: Experiment = Experiment {
    id: "frisvad.6",
    paper: Paper::Frisvad,
    item: Item::Figure(6),
    title: "positions, radiance and normals seen from the light",
    setup: &LightPictures { scene: BOX },
    claims: &[],
};

pub(super) const TEXELS: Experiment = Experiment {
    id: "frisvad.rsm",
    paper: Paper::Frisvad,
    item: Item::NotInThePaper,
    title: "contents of the reflective shadow map, texel by texel",
    setup: &InCode(run),
    claims: &[
        Claim {
            id: "C1",
            says: "Photons lie on the surfaces that the light hits first.",
            rule: "A trial is a scene and a backend: less than one in a hundred photons lies elsewhere \
                than the place that a ray along its texel meets first, by a thousandth of the way.",
        },
        Claim {
            id: "C2",
            says: "They hold the light that is reflected there.",
            rule: "A trial is a scene and a backend: radiance differs from ρ/π·E·cos α by less than \
                1 % rms.",
        },
    ],
};

/// Largest share of photons that lie elsewhere, and largest error of radiance over its mean.
const FEW: f64 = 0.01;

/// Fraction of a ray's length by which a place may be off.
const OFF: f64 = 1e-3;

/// The scenes whose pictures from their lights are shown.
#[derive(Serialize)]
pub(super) struct LightPictures {
    pub(super) scene: SceneSetup,
}

impl Runs for LightPictures {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        for backend in context.backends() {
            if let Some(view) = from_light(context, &loaded, backend)? {
                let shown = rows(&view, &format!("{}, {backend}", self.scene));
                finding.pictures.extend(shown);
            }
        }
        Ok(finding)
    }
}

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    for scene in ["cornell-box", "cave"] {
        let loaded = context.load(&ExperimentScene::of(scene), &mut finding)?;
        for backend in context.backends() {
            let Some(view) = from_light(context, &loaded, backend)? else {
                continue;
            };
            let (photons, elsewhere, error) = check(&loaded, &view);
            for (name, value) in [
                ("photons", photons as f64),
                ("share elsewhere", elsewhere),
                ("rms error of radiance / mean", error),
            ] {
                finding.measure((scene, name), backend, Amount::exact(value), "");
            }
            let [place, radiance] = judged(scene, backend, [elsewhere, error]);
            finding.judge("C1", [place]);
            finding.judge("C2", [radiance]);
        }
    }
    Ok(finding)
}

/// The pictures that the published map takes from the scene's lights.
fn from_light(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    backend: Backend,
) -> Result<Option<RsmImage>, RunError> {
    let map = context.method("direct_radiance_map", &[])?;
    let needs = map.needs(Quantity::Irradiance, &loaded.scene().facts())?;
    Ok(rsms(loaded, backend, &needs)?.pop())
}

/// That photons lie where rays meet a surface, and hold the light that is reflected there.
fn judged(scene: &str, backend: Backend, [elsewhere, error]: [f64; 2]) -> [Trial; 2] {
    let place = format!("{scene}: share of photons elsewhere");
    let radiance = format!("{scene}: rms error of radiance over mean");
    [
        Trial::less_by(place, backend, (elsewhere, FEW), 0.0),
        Trial::less_by(radiance, backend, (error, FEW), 0.0),
    ]
}

/// Photons that no mirror brought, the share of them that a ray does not find, and the rms error of
/// their radiance over its mean.
fn check(loaded: &LoadedScene, view: &RsmImage) -> (usize, f64, f64) {
    let (scene, size) = (loaded.scene(), view.size);
    let geometry = loaded.cpu().scene.all_objects();
    let (mut photons, mut elsewhere) = (0_usize, 0_usize);
    let (mut square, mut sum) = (DVec3::ZERO, DVec3::ZERO);
    for (f, frame) in view.frames.iter().enumerate() {
        for (row, column) in (0..size).flat_map(|r| (0..size).map(move |c| (r, c))) {
            let i = view_index(size, f, column, row);
            let across = |v: u32| 2.0 * (f64::from(v) + 0.5) / f64::from(size) - 1.0;
            let (origin, along) = frame.ray(across(column), across(row));
            let hit =
                loaded
                    .cpu()
                    .scene
                    .closest(geometry, origin, along.as_vec3(), geometry.ray_start());
            if view.path_m[i] <= 0.0 || hit.as_ref().is_some_and(|h| h.material.mirror) {
                continue;
            }
            photons += 1;
            let Some(hit) = hit else {
                elsewhere += 1;
                continue;
            };
            let way = (hit.position - origin).length();
            if hit.position.distance(view.position[i].as_dvec3()) > OFF * way {
                elsewhere += 1;
                continue;
            }
            let light = &scene.lights[frame.light as usize];
            let radiance = light
                .incident(hit.position.as_vec3())
                .map_or(Vec3::ZERO, |incident| {
                    let cosine = hit.geometric_normal.dot(incident.to_light).abs();
                    hit.material.albedo * FRAC_1_PI * incident.irradiance * cosine
                });
            square += (view.radiance[i] - radiance).as_dvec3().powf(2.0);
            sum += radiance.as_dvec3();
        }
    }
    let n = photons.max(1) as f64;
    let rms = (square.element_sum() / (3.0 * n)).sqrt();
    (
        photons,
        elsewhere as f64 / n,
        rms / (sum.element_sum() / (3.0 * n)),
    )
}

/// A row for each channel, as it needs an exposure of its own.
fn rows(view: &RsmImage, case: &str) -> Vec<Row> {
    let (low, extent) = (view.bounds.low, view.bounds.high - view.bounds.low);
    let hit = |i: usize| view.path_m[i] > 0.0;
    let coloured = |values: &[Vec3], colour: &dyn Fn(Vec3) -> Vec3| -> Vec<Vec3> {
        let colour = |(i, v): (usize, &Vec3)| if hit(i) { colour(*v) } else { Vec3::ZERO };
        values.iter().enumerate().map(colour).collect()
    };
    let place = |p: Vec3| (p - low) / extent.max(Vec3::splat(f32::MIN_POSITIVE));
    let channels = [
        ("positions", coloured(&view.position, &place)),
        ("radiance", view.radiance.clone()),
        ("normals", coloured(&view.normal, &|n| 0.5 + 0.5 * n)),
    ];
    let there = channels
        .into_iter()
        .filter(|(_, values)| !values.is_empty());
    let row = |(name, values): (&str, Vec<Vec3>)| {
        let mut row = Row::plain(format!("{case}: {name}"));
        for frame in 0..view.frames.len() {
            let edge = view.size as usize;
            let pixel = |i: usize| {
                let (column, row) = ((i % edge) as u32, (i / edge) as u32);
                values[view_index(view.size, frame, column, row)]
            };
            let image = HdrImage {
                width: edge,
                height: edge,
                pixels: (0..edge * edge).map(pixel).collect(),
            };
            row.add(format!("view {}", frame + 1), image);
        }
        row
    };
    there.map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn one_in_a_hundred_may_be_wrong() {
        let judged = |found| signs(&judged("", Backend::Cpu, found));
        assert_eq!(judged([0.009, 0.011]), "+-");
        assert_eq!(judged([0.011, 0.009]), "-+");
        assert_eq!(OFF, 1e-3);
    }
}
