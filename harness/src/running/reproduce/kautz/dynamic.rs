//! Lighting that changes in every frame.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::judge::Judge;
use super::super::measured_run::amount_of;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use super::RESOLUTION;
use super::biased;
use super::studio;
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::on_backend::Sequence;
use interreflect_estimators::Quantity;
use interreflect_scene::PointLayout;
use interreflect_scene::motion::Moves;
use serde::Serialize;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "kautz.dynamic",
    paper: Paper::Kautz,
    item: Item::Section("7"),
    title: "lighting that changes in every frame",
    setup: &Dynamic {
        scene: studio(
            &["bunny"],
            &[
                ("receiver.diffuse", "0.4"),
                ("receiver.specular", "0.6"),
                ("environment.turn_deg_per_s", "30"),
            ],
        ),
        f_lambda: 0.24,
        bias: 1.5,
        resolution: RESOLUTION,
    },
    claims: &[Claim {
        id: "C1",
        says: "Diffuse and glossy reflections are filtered anew as the lighting changes, interactively.",
        rule: "A trial is a backend: each frame of a session that goes on is that of a new session, within a \
            thousandth of the mean, rms; and a frame, captures included, takes less than 100 ms.",
    }],
};

/// A model while the environment turns.
#[derive(Serialize)]
pub(super) struct Dynamic {
    pub(super) scene: SceneSetup,
    /// f_λ.
    pub(super) f_lambda: f64,
    /// b.
    pub(super) bias: f64,
    /// Texels along a face's edge of the pyramid's base.
    pub(super) resolution: u32,
}

/// Frames a second of the sequence.
const RATE: f32 = 30.0;

/// Milliseconds of a frame that is interactive.
const INTERACTIVE_MS: f64 = 100.0;

/// Largest difference over the mean that passes for the same picture.
const SAME: f64 = 1e-3;

/// What changes from frame to frame.
const TURNING: Moves = Moves {
    geometry: false,
    camera: false,
    lights: false,
    environment: true,
};

impl Runs for Dynamic {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        let quantity = Quantity::GlossyRadiance;
        let rest = context.scene(&context.place(&self.scene), &mut finding)?;
        let method = biased(context, self.resolution, self.bias, self.f_lambda)?;
        for backend in context.backends() {
            let (mut running, mut worst, mut times) = (Sequence::default(), 0.0_f64, Vec::new());
            let mut row = Row::plain(format!("frames while the environment turns, {backend}"));
            let count = context.pick(5_u8, 16);
            for index in 0..count {
                let loaded = context.set_up(&rest.at(f32::from(index) / RATE))?;
                let view = context.view(&loaded)?;
                let points = view.points(PointLayout::Material);
                let seen = (&points, None, TURNING);
                let shoot = |session: &mut Sequence| {
                    context.frame(&loaded, (session, backend), &*method, quantity, seen)
                };
                let (shaded, anew) = (shoot(&mut running)?, shoot(&mut Sequence::default())?);
                let new = Judge::at(&anew.estimate, None, (0..points.len()).collect());
                worst = worst.max(new.relative_rms(&shaded.estimate).value);
                // The first frame warms up.
                if index > 0 {
                    times.push(shaded.ms);
                }
                if index == 0 || index + 1 == count {
                    let direct = context.direct_light(&loaded, backend, &view)?;
                    row.add(
                        format!("frame {index}"),
                        view.lit(&shaded.estimate, &direct),
                    );
                }
            }
            let (frame, case) = (amount_of(&times), "turning environment");
            let unit = ("ms", context.software(backend));
            finding.time((case, "frame"), backend, frame, unit);
            let name = "largest rms difference from a new session / mean";
            finding.measure((case, name), backend, Amount::exact(worst), "");
            finding.judge("C1", judged(backend, worst, frame));
            finding.pictures.push(row);
        }
        Ok(finding)
    }
}

/// That each frame is that of a new session, and takes less than 100 ms.
fn judged(backend: Backend, worst: f64, frame: Amount) -> [Trial; 2] {
    let same = "largest rms difference from a new session over the mean";
    let soon = format!("frame below {INTERACTIVE_MS} ms");
    [
        Trial::less_by(same, backend, (worst, SAME), 0.0),
        Trial::less(soon, backend, frame, Amount::exact(INTERACTIVE_MS)),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::{about, signs};
    use super::*;

    #[test]
    fn frames_have_to_be_new_and_soon() {
        let judged = |worst, ms| signs(&judged(Backend::Cpu, worst, about(ms)));
        assert_eq!(judged(0.9e-3, 80.0), "++");
        assert_eq!(judged(1.1e-3, 120.0), "--");
    }
}
