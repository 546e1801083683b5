//! What a moving light does from frame to frame.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::setup::Runs;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::{Shade, View};
use glam::{Quat, Vec3};
use interreflect_estimators::Quantity;
use interreflect_scene::{Estimate, Light, Points, Scene};
use serde::Serialize;

/// Square lights that swing, wide enough to light several surfaces.
const fn swinging(source: &'static str) -> SceneSetup {
    SceneSetup::of(source).set(&[("light.angle", "95")])
}

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "frisvad.flashing",
    paper: Paper::Frisvad,
    item: Item::Section("5"),
    title: "flashing while the light moves",
    setup: &Flashing {
        scenes: [swinging("cornell-box"), swinging("cave")],
        texels: 16,
        samples: 3,
    },
    claims: &[
        Claim {
            id: "C1",
            says: "Few samples make the light flash while it moves.",
            rule: "A trial is a scene and a backend: flicker, the mean second difference from frame to \
                frame over the mean, is more than twice that of a map of 64² texels, all taken. The \
                light swings by 1° a frame.",
        },
        Claim {
            id: "C2",
            says: "Averaged radiance lessens the flashing.",
            rule: "A trial is a scene and a backend: flicker with averaging is less than 80 % of that \
                without.",
        },
    ],
};

/// How many times smoother a map of all texels is where few samples flash.
const FLASHES: f64 = 2.0;

/// What averaging has to leave at most.
const REDUCED: f64 = 0.8;

/// A light that swings in each of the scenes, and the map whose few samples flash.
#[derive(Serialize)]
pub(super) struct Flashing {
    pub(super) scenes: [SceneSetup; 2],
    /// w, texels along the edge of the picture from the light.
    pub(super) texels: u32,
    /// Samples along the edge.
    pub(super) samples: u32,
}

/// Name, samples along the edge, texels along the edge, fidelity and averaging of what is compared.
type Map = (&'static str, u32, u32, &'static str, bool);

impl Flashing {
    fn maps(&self) -> [Map; 3] {
        let (texels, samples) = (self.texels, self.samples);
        [
            ("few samples", samples, texels, "published", false),
            ("few samples, averaged", samples, texels, "published", true),
            ("all of 64×64 texels", 64, 64, "published", false),
        ]
    }
}

impl Runs for Flashing {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for scene in &self.scenes {
            in_scene(context, (scene, self.maps()), &mut finding)?;
        }
        Ok(finding)
    }
}

fn in_scene(
    context: &ExperimentContext<'_>,
    (setup, map_list): (&SceneSetup, [Map; 3]),
    finding: &mut Finding,
) -> Result<(), RunError> {
    let scene = setup.source;
    let rest = context.scene(&context.place(setup), finding)?;
    let loaded = context.set_up(&rest)?;
    let view = context.view_of(&loaded, (context.pick(5_000, 20_000), Shade::default()))?;
    let points = view.points(Quantity::Irradiance.layout());
    let sequences = sequences(context, &rest, &points, map_list)?;
    for (backend, maps) in context.backends().into_iter().zip(&sequences) {
        let mut flicker = Vec::new();
        let mut rows = Row::plain(format!("{scene}: two frames, {backend}"));
        for (map, frames) in map_list.iter().zip(maps) {
            let value = second_difference(frames);
            let case = format!("{scene}, {}", map.0);
            let amount = Amount::exact(value);
            finding.measure((case, "second difference / mean"), backend, amount, "");
            flicker.push(value);
            pictures(&view, frames, map.0, &mut rows);
        }
        if let [few, averaged, all] = flicker[..] {
            let trials = judged(scene, backend, [few, averaged, all]);
            let [flash, less] = trials;
            finding.judge("C1", [flash]);
            finding.judge("C2", [less]);
        }
        finding.pictures.push(rows);
    }
    Ok(())
}

/// That few samples flash, which all texels don't, and that averaging reduces it.
fn judged(scene: &str, backend: Backend, [few, averaged, all]: [f64; 3]) -> [Trial; 2] {
    let flash =
        format!("{scene}: {FLASHES} times the flicker of all texels below that of few samples");
    let less = format!("{scene}: flicker with averaging below {REDUCED} of that without");
    [
        Trial::less_by(flash, backend, (FLASHES * all, few), 0.0),
        Trial::less_by(less, backend, (averaged, REDUCED * few), 0.0),
    ]
}

/// For each backend and each map the frames of a swinging light.
fn sequences(
    context: &ExperimentContext<'_>,
    rest: &Scene,
    points: &Points,
    map_list: [Map; 3],
) -> Result<Vec<[Vec<Estimate>; 3]>, RunError> {
    let mut all: Vec<[Vec<Estimate>; 3]> = Vec::new();
    all.resize_with(context.backends().len(), Default::default);
    for index in 0..context.pick(24_u8, 90) {
        let loaded = context.set_up(&swung(rest, f32::from(index) / 30.0))?;
        for (backend, maps) in context.backends().into_iter().zip(&mut all) {
            for ((_, samples, texels, fidelity, mip), frames) in map_list.into_iter().zip(maps) {
                let map = context.method(
                    "direct_radiance_map",
                    &[
                        ("samples_per_side", &samples),
                        ("map_resolution", &texels),
                        ("fidelity", &fidelity),
                        ("mip", &mip),
                    ],
                )?;
                let measured =
                    context.run_once(&loaded, backend, &*map, Quantity::Irradiance, points)?;
                frames.push(measured.estimate);
            }
        }
    }
    Ok(all)
}

/// The scene with its spot light swinging about the axis into it, 30° a second.
fn swung(rest: &Scene, time_s: f32) -> Scene {
    let mut scene = rest.clone();
    let turn = Quat::from_axis_angle(Vec3::Z, (30.0 * time_s - 15.0).to_radians());
    for light in &mut scene.lights {
        if let Light::Spot { direction, up, .. } = light {
            (*direction, *up) = (turn * *direction, turn * *up);
        }
    }
    scene
}

/// Mean of |E(t−1) − 2E(t) + E(t+1)| over the mean of E: 0 for light that grows or moves steadily.
fn second_difference(frames: &[Estimate]) -> f64 {
    let (mut difference, mut sum) = (0.0, 0.0);
    for three in frames.windows(3) {
        for ((a, b), c) in three[0].iter().zip(three[1].iter()).zip(three[2].iter()) {
            difference += f64::from((a - 2.0 * b + c).abs().element_sum());
            sum += f64::from(b.element_sum());
        }
    }
    difference / sum
}

/// The two frames between which most changes.
fn pictures(view: &View, frames: &[Estimate], name: &str, row: &mut Row) {
    let change = |pair: &[Estimate]| -> f32 {
        let both = pair[0].iter().zip(pair[1].iter());
        both.map(|(a, b)| (a - b).abs().element_sum()).sum()
    };
    let pairs = frames.windows(2).enumerate();
    let most = pairs.max_by(|a, b| change(a.1).total_cmp(&change(b.1)));
    if let Some((index, pair)) = most {
        row.add(format!("{name}, frame {index}"), view.image(&pair[0]));
        row.add(format!("{name}, frame {}", index + 1), view.image(&pair[1]));
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::synthetic::signs;
    use super::*;

    #[test]
    fn few_samples_flash_twice_and_averaging_takes_a_fifth_away() {
        let judged = |flicker| signs(&judged("", Backend::Cpu, flicker));
        assert_eq!(judged([1.0, 0.79, 0.49]), "++");
        assert_eq!(judged([1.0, 0.81, 0.51]), "--");
    }

    #[test]
    fn steady_change_does_not_flash() {
        let frame = |v: f32| {
            let mut e = Estimate::new(1);
            e.set(0, Vec3::splat(v));
            e
        };
        assert_eq!(
            second_difference(&[frame(1.0), frame(2.0), frame(3.0)]),
            0.0
        );
        assert!((second_difference(&[frame(1.0), frame(2.0), frame(1.0)]) - 1.0).abs() < 1e-6);
    }
}
