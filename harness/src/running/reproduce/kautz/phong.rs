//! The box filter of the mip pyramid beside the Phong filter.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::viewer::{LOOKS, SHOWN, Viewer};
use super::super::{Claim, Experiment, Item, Paper};
use super::studio;
use super::{MIRRORING, PIXELS, RESOLUTION};
use super::{biased, lines};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::Look;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::{Estimate, Points};
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.5",
    paper: Paper::Kautz,
    item: Item::Figure(5),
    title: "box filter beside the Phong filter, N = 225",
    setup: &Filters {
        scene: studio(&["bunny"], MIRRORING),
        exponent: 225.0,
        bias: 2.25,
        resolution: RESOLUTION,
        pixels: PIXELS,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "Differences from the Phong filter are not very noticeable.",
            rule: "A trial is a backend: pictures of mirrored light alone, clipped and encoded as they are \
                shown, differ by less than 5 % of white, rms.",
        },
        Claim {
            id: "C2",
            says: "The box filter shows some blocks.",
            rule: "A trial is a backend: along lines over the cube's faces the strongest kinks of mirrored \
                light, changes of slope from step to step over the mean slope, are more than twice those of \
                the Phong filter on a map of 64² cells a face.",
        },
        Claim {
            id: "C3",
            says: "The box filter is 20 times faster than the two-pass convolution of paraboloid maps.",
            rule: "A trial is a backend: a frame takes less than a twentieth of the time, beyond the spread \
                of both.",
        },
    ],
};

/// A model under an environment, and the filters.
#[derive(Serialize)]
pub(super) struct Filters {
    pub(super) scene: SceneSetup,
    /// N of the Phong filter.
    pub(super) exponent: f64,
    /// b of the box filter.
    pub(super) bias: f64,
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
    /// Pixels along the picture's edge, whatever the effort: the hardware's level rises where pixels are larger.
    pub(super) pixels: u32,
}

/// Largest rms difference of pictures, where white is 1, that passes for not very noticeable.
const SAME: f64 = 0.05;

/// How many times stronger kinks are that show blocks.
const BLOCKY: f64 = 2.0;

/// Cells along a face's edge of the Phong filter's map, where kinks are told: 1.4° each.
const FINE: u32 = 64;

/// Why the claim about time has no trials.
const RIVAL: &str = "the two-pass convolution of paraboloid maps is not implemented; the rival that ran is a \
                     brute-force sum of the Phong lobe over all texels";

impl Runs for Filters {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::GlossyRadiance;
        let loaded = context.load(&context.place(&self.scene), &mut finding)?;
        let view = context.whole_view(&loaded, self.pixels, Look::default())?;
        let points = view.points(quantity.layout());
        let along = lines::points(footprint(&points));
        for backend in context.backends() {
            // With f_λ = 1 nothing but the filter is seen.
            let parameters: [(&str, &dyn ToString); 2] =
                [("exponent", &self.exponent), ("f_lambda", &1)];
            let slow = context.method("phong_envmap", &parameters)?;
            let fast = biased(context, self.resolution, self.bias, 1.0)?;
            let run = |method: &dyn Configured| {
                context.run_timed(&loaded, backend, method, quantity, &points)
            };
            let (phong, boxed) = (run(&*slow)?, run(&*fast)?);
            let viewer = Viewer::new(&view, &phong.estimate, None);
            let title = format!("mirrored light alone, {backend}");
            let caption = format!("Phong, N = {}", self.exponent);
            let mut row = Row::rendered(title, caption, &view, &phong.estimate);
            row.add(
                format!("box, b = {}", self.bias),
                view.image(&boxed.estimate),
            );
            for bias in [self.bias - 1.0, self.bias + 1.0] {
                let method = biased(context, self.resolution, bias, 1.0)?;
                let other = context.run_once(&loaded, backend, &*method, quantity, &points)?;
                note(&viewer, (bias, backend), &other.estimate, &mut finding);
                row.add(format!("box, b = {bias}"), view.image(&other.estimate));
            }
            let rms = note(&viewer, (self.bias, backend), &boxed.estimate, &mut finding);
            finding.judge("C1", [unnoticed(backend, rms)]);
            // As fine as its kinks do not count: four cells in the lobe's width.
            let fine: [(&str, &dyn ToString); 3] = [
                ("exponent", &self.exponent),
                ("f_lambda", &1),
                ("map_resolution", &FINE),
            ];
            let fine = context.method("phong_envmap", &fine)?;
            let mut kinks = |name: &str, method: &dyn Configured| {
                let run = context.run_once(&loaded, backend, method, quantity, &along)?;
                let kinks = lines::kinks(&run.estimate);
                finding.measure(
                    (name, "kinks / mean slope"),
                    backend,
                    Amount::exact(kinks),
                    "",
                );
                Ok::<_, RunError>(kinks)
            };
            let pair = (kinks("Phong", &*fine)?, kinks("box", &*fast)?);
            finding.judge("C2", [blocky(backend, pair)]);
            let ratio = phong.prepare_ms().over(boxed.prepare_ms());
            let unit = ("", context.software(backend));
            let name = "times as long to prepare as the box filter";
            finding.time(("brute-force Phong", name), backend, ratio, unit);
            finding.pictures.push(row);
            finding.runs.extend([phong.run, boxed.run]);
        }
        finding.leave_out("C3", RIVAL);
        finding.note("the level that a bias makes depends on the size of pixels, and the paper does not say how many its picture has");
        finding.note("a smoother magnification, which would cure the blocks, is not implemented");
        Ok(finding)
    }
}

/// The median footprint.
fn footprint(points: &Points) -> f32 {
    let mut all: Vec<f32> = points.iter().flatten().map(|p| p.footprint).collect();
    all.sort_by(f32::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or_default()
}

/// Notes how far a bias's picture is from the reference: the rms difference as shown.
fn note(
    viewer: &Viewer<'_>,
    (bias, backend): (f64, Backend),
    estimate: &Estimate,
    finding: &mut Finding,
) -> f64 {
    let (case, rms) = (format!("b = {bias}"), viewer.shown_rms(estimate));
    finding.measure((&*case, SHOWN), backend, Amount::exact(rms), "");
    let looks = Amount::exact(viewer.difference(estimate));
    finding.measure((&*case, LOOKS), backend, looks, "");
    rms
}

/// That pictures differ by less than a twentieth of white.
pub(super) fn unnoticed(backend: Backend, rms: f64) -> Trial {
    Trial::less_by(SHOWN, backend, (rms, SAME), 0.0)
}

/// That the box filter's kinks are more than twice the Phong filter's.
fn blocky(backend: Backend, (phong, boxed): (f64, f64)) -> Trial {
    let what =
        format!("{BLOCKY} times the kinks of the Phong filter below those of the box filter");
    Trial::less_by(what, backend, (BLOCKY * phong, boxed), 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn the_box_filter_looks_alike_but_for_its_blocks() {
        let judged = |rms, phong, boxed| {
            let (alike, blocky) = (
                unnoticed(Backend::Cpu, rms),
                blocky(Backend::Cpu, (phong, boxed)),
            );
            signs([&alike, &blocky])
        };
        assert_eq!(judged(0.04, 1.0, 2.1), "++");
        assert_eq!(judged(0.06, 1.0, 1.9), "--");
    }
}
