//! The box filter of a mip level beside the Phong filter.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::environments::environments;
use crate::domain::image::{Exposure, HdrImage};
use crate::running::error::RunError;
use crate::running::view::View;
use interreflect_estimators::Quantity;

/// Largest rms difference of pictures, where white is 1, that passes for the same look.
const SAME: f64 = 0.05;

/// How many times faster the box filter has to be.
const FASTER: f64 = 10.0;

/// The level of 64² texels a face that is about as wide as the lobe: N ≈ 3(K/2ᵐ)².
const MATCHING: u32 = 3;

pub(super) fn run(context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
    let mut finding = Finding::default();
    let quantity = Quantity::GlossyRadiance;
    for (name, place) in environments(context, &mut finding) {
        let place = place.set("receiver.diffuse", 0).set("receiver.specular", 1);
        let room = context.room(&place, &mut finding)?;
        let view = context.view(&room)?;
        let points = view.points(quantity.layout());
        for backend in context.backends() {
            // With f_λ = 1 nothing but the filter is seen.
            let slow = context.method("phong_envmap", &[("exponent", &225), ("f_lambda", &1)])?;
            let slow = context.run_timed(&room, backend, &*slow, quantity, &points)?;
            let reference = view.image(&slow.estimate);
            let title = format!("{name}, {backend}");
            let mut row = Row::against(title, "Phong, N = 225", reference.clone(), view.surfaces());
            for level in [MATCHING - 1, MATCHING, MATCHING + 1] {
                let fast = context.method("sh_mip_envmap", &[("lod", &level), ("f_lambda", &1)])?;
                let fast = context.run_timed(&room, backend, &*fast, quantity, &points)?;
                let image = view.image(&fast.estimate);
                let rms = Amount::exact(displayed_rms(&view, &image, &reference));
                let label = format!("level {level}: rms of pictures");
                finding.measure((name, label), backend, rms, "");
                row.add(format!("mip level {level}"), image);
                if level == MATCHING {
                    let software = context.software(backend);
                    let ratio = slow.prepare_ms().over(fast.prepare_ms());
                    let at = (name, "times as long to prepare");
                    finding.time(at, backend, ratio, ("", software));
                    let what = format!("{name}: rms difference of pictures");
                    let same = Amount::exact(SAME);
                    finding.trials.push(Trial::less(what, backend, rms, same));
                    let what =
                        format!("{name}: box filter below a tenth of the Phong filter's time, ms");
                    let tenth = slow.prepare_ms().times(1.0 / FASTER);
                    let trial = Trial::less(what, backend, fast.prepare_ms(), tenth);
                    finding.trials.push(trial);
                }
                finding.runs.push(fast.run);
            }
            finding.runs.push(slow.run);
            finding.pictures.push(row);
        }
    }
    Ok(finding)
}

/// Root mean square difference of two images as they are shown, clipped and encoded, where the surface
/// is seen; white is 1.
fn displayed_rms(view: &View, a: &HdrImage, b: &HdrImage) -> f64 {
    let exposure = Exposure::of(b);
    let (a, b) = (a.tone_mapped(exposure), b.tone_mapped(exposure));
    let pixels = a.pixels().zip(b.pixels()).zip(view.surfaces());
    let (mut square, mut count) = (0.0, 0.0);
    for ((a, b), _) in pixels.filter(|(_, surface)| *surface) {
        for channel in 0..3 {
            let difference = f64::from(a.0[channel]) - f64::from(b.0[channel]);
            square += (difference / 255.0).powi(2);
            count += 1.0;
        }
    }
    (square / f64::max(count, 1.0)).sqrt()
}
