//! The box filter of a mip level beside the Phong filter.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::verdict::{Amount, Trial};
use super::environments::environments;
use crate::domain::image::{Exposure, HdrImage};
use crate::domain::record::Backend;
use crate::running::error::RunError;
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
        let loaded = context.load(&place, &mut finding)?;
        let view = context.view(&loaded)?;
        let points = view.points(quantity.layout());
        for backend in context.backends() {
            // With f_λ = 1 nothing but the filter is seen.
            let slow = context.method("phong_envmap", &[("exponent", &225), ("f_lambda", &1)])?;
            let slow = context.run_timed(&loaded, backend, &*slow, quantity, &points)?;
            let reference = view.image(&slow.estimate);
            let title = format!("{name}, {backend}");
            let mut row = Row::against(title, "Phong, N = 225", reference.clone(), view.surfaces());
            for level in [MATCHING - 1, MATCHING, MATCHING + 1] {
                let fast = context.method("sh_mip_envmap", &[("lod", &level), ("f_lambda", &1)])?;
                let fast = context.run_timed(&loaded, backend, &*fast, quantity, &points)?;
                let image = view.image(&fast.estimate);
                let rms = Amount::exact(displayed_rms(&view.surfaces(), &image, &reference));
                let label = format!("level {level}: rms of pictures");
                finding.measure((name, label), backend, rms, "");
                row.add(format!("mip level {level}"), image);
                if level == MATCHING {
                    let software = context.software(backend);
                    let ratio = slow.prepare_ms().over(fast.prepare_ms());
                    let at = (name, "times as long to prepare");
                    finding.time(at, backend, ratio, ("", software));
                    let times = (fast.prepare_ms(), slow.prepare_ms());
                    let [same, faster] = judged(name, backend, rms, times);
                    finding.judge("C1", [same]);
                    finding.judge("C2", [faster]);
                }
                finding.runs.push(fast.run);
            }
            finding.runs.push(slow.run);
            finding.pictures.push(row);
        }
    }
    Ok(finding)
}

/// That the box filter's pictures look like the Phong filter's, in a tenth of its time.
fn judged(
    name: &str,
    backend: Backend,
    rms: Amount,
    (box_ms, phong_ms): (Amount, Amount),
) -> [Trial; 2] {
    let same = format!("{name}: rms difference of pictures");
    let faster = format!("{name}: box filter below a tenth of the Phong filter's time, ms");
    [
        Trial::less(same, backend, rms, Amount::exact(SAME)),
        Trial::less(faster, backend, box_ms, phong_ms.times(1.0 / FASTER)),
    ]
}

/// Root mean square difference of two images as they are shown, clipped and encoded, where the surface
/// is seen; white is 1.
fn displayed_rms(surfaces: &[bool], a: &HdrImage, b: &HdrImage) -> f64 {
    let exposure = Exposure::of(b);
    let (a, b) = (a.tone_mapped(exposure), b.tone_mapped(exposure));
    let pixels = a.pixels().zip(b.pixels()).zip(surfaces);
    let (mut square, mut count) = (0.0, 0.0);
    for ((a, b), _) in pixels.filter(|(_, surface)| **surface) {
        for channel in 0..3 {
            let difference = f64::from(a.0[channel]) - f64::from(b.0[channel]);
            square += (difference / 255.0).powi(2);
            count += 1.0;
        }
    }
    (square / f64::max(count, 1.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;
    use glam::Vec3;

    #[test]
    fn the_box_filter_looks_alike_and_takes_a_tenth_of_the_time() {
        let judged = |rms, fast, slow| {
            signs(&judged(
                "case",
                Backend::Cpu,
                about(rms),
                (about(fast), about(slow)),
            ))
        };
        assert_eq!(judged(0.04, 1.0, 15.0), "++");
        assert_eq!(judged(0.06, 1.0, 7.0), "--");
        // The level of 8² texels a face: N ≈ 3(64/2³)² = 192.
        assert_eq!(MATCHING, 3);
    }

    /// The reference is 0.9 of white everywhere: sRGB 243. Black beside it is 243 steps off.
    #[test]
    fn pictures_differ_as_they_are_shown() {
        let image = |values: [f32; 4]| HdrImage {
            width: 2,
            height: 2,
            pixels: values.map(Vec3::splat).to_vec(),
        };
        let (reference, estimate) = (image([3.0; 4]), image([3.0, 0.0, 0.0, 9.0]));
        let rms = displayed_rms(&[true, true, false, false], &estimate, &reference);
        let expected = (243.0_f64 / 255.0) * 0.5_f64.sqrt();
        assert!((rms - expected).abs() < 1e-12, "{rms} {expected}");
        assert_eq!(displayed_rms(&[false; 4], &estimate, &reference), 0.0);
    }
}
