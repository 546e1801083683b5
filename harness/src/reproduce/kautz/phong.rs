//! The box filter of a mip level beside the Phong filter.

use super::super::desk::Desk;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::environments::environments;
use crate::error::HarnessError;
use crate::output::Exposure;
use glam::Vec3;
use interreflect_estimators::Quantity;
use interreflect_scene::Estimate;

/// Largest rms difference over the mean that passes for the same look.
const SAME: f64 = 0.1;

/// How many times faster the box filter has to be.
const FASTER: f64 = 10.0;

pub(super) fn run(desk: &Desk<'_>) -> Result<Finding, HarnessError> {
    let mut finding = Finding::default();
    for (name, place) in environments(desk, &mut finding) {
        let place = place.set("receiver.diffuse", 0).set("receiver.specular", 1);
        let room = desk.room(&place, &mut finding)?;
        let view = desk.view(&room)?;
        let quantity = Quantity::GlossyRadiance;
        let points = view.points(quantity.layout());
        for backend in desk.backends() {
            let slow = desk.method("phong_envmap", &[("exponent", &225)])?;
            let slow = desk.timed_shot(&room, backend, &*slow, quantity, &points)?;
            let surfaces = (0..points.len()).filter(|&i| points.get(i).is_some());
            let surfaces: Vec<usize> = surfaces.collect();
            let white = 1.0 / Exposure::of(&view.image(&slow.estimate)).0;
            let displayed = clipped(&slow.estimate, white);
            let judge = Judge::at(&displayed, None, surfaces.clone());
            let unclipped = Judge::at(&slow.estimate, None, surfaces);
            let title = format!("{name}, {backend}");
            let mut row = Row::against(
                title,
                "Phong, N = 225",
                view.image(&slow.estimate),
                view.surfaces(),
            );
            for level in [2, 3, 4] {
                let fast = desk.method("sh_mip_envmap", &[("lod", &level)])?;
                let fast = desk.timed_shot(&room, backend, &*fast, quantity, &points)?;
                let rms = Amount::exact(judge.relative_rms(&clipped(&fast.estimate, white)));
                let label = format!("level {level}: rms difference / mean");
                finding.measure((name, label), backend, rms, "");
                let sun = Amount::exact(unclipped.relative_rms(&fast.estimate));
                finding.measure(
                    (name, format!("level {level}: not clipped")),
                    backend,
                    sun,
                    "",
                );
                row.add(format!("mip level {level}"), view.image(&fast.estimate));
                if level == MATCHING {
                    let software = desk.software(backend);
                    let ratio = slow.prepare_ms().over(fast.prepare_ms());
                    finding.time(
                        (name, "times as long to prepare"),
                        backend,
                        ratio,
                        ("", software),
                    );
                    let what = format!("{name}: rms difference over mean");
                    finding
                        .trials
                        .push(Trial::less(what, backend, rms, Amount::exact(SAME)));
                    let what =
                        format!("{name}: box filter below a tenth of the Phong filter's time, ms");
                    let tenth = slow.prepare_ms().times(1.0 / FASTER);
                    finding
                        .trials
                        .push(Trial::less(what, backend, fast.prepare_ms(), tenth));
                }
                finding.runs.push(fast.run);
            }
            finding.runs.push(slow.run);
            finding.pictures.push(row);
        }
    }
    Ok(finding)
}

/// An estimate as a display shows it: nothing is brighter than white.
fn clipped(estimate: &Estimate, white: f32) -> Estimate {
    let mut all = Estimate::new(estimate.len());
    for (i, value) in estimate.iter().enumerate() {
        all.set(i, value.min(Vec3::splat(white)));
    }
    all
}

/// The level of 64² texels a face that is about as wide as the lobe: N ≈ 3(K/2ᵐ)².
const MATCHING: u32 = 3;
