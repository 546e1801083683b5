//! Pictures of a figure as steps: what each computes, how it looks and how long its frame takes.

use super::super::experiment_context::ExperimentContext;
use super::super::finding::Finding;
use super::super::measured_run::amount_of;
use super::super::pictures::Row;
use super::super::scene_setup::SceneSetup;
use super::super::verdict::{Amount, Trial};
use super::super::{Claim, Experiment, Item, Paper};
use crate::domain::record::Backend;
use crate::running::error::RunError;
use crate::running::view::{Look, Mirrors, Shade, View, lambertian};
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity};
use interreflect_scene::{DirectLight, Estimate, PointLayout, ReflectionLaw};
use serde::Serialize;
use std::time::Instant;

/// The Cornell box under a distant area light, by eq. 9.
pub(super) const BOX: SceneSetup = SceneSetup::of("cornell-box").set(&[("light", "area")]);
/// Two mirror balls in place of its blocks.
pub(super) const BALLS: SceneSetup =
    SceneSetup::of("cornell-box").set(&[("light", "area"), ("inside", "mirror_balls")]);
pub(super) const CAVE: SceneSetup = SceneSetup::of("cave");
pub(super) const CAVE_WITHOUT_MIRRORS: SceneSetup =
    SceneSetup::of("cave").set(&[("mirrors", "false")]);

pub(super) const FIGURE_3: Experiment = Experiment {
    id: "frisvad.3",
    paper: Paper::Frisvad,
    item: Item::Figure(3),
    title: "Cornell box: local shading, direct light, direct and indirect light",
    setup: &EverDearer {
        scenes: &[BOX],
        steps: &[Step::BlinnPhong, Step::Direct, Step::Eq15],
        grid: GRID,
    },
    claims: &[Claim {
        id: "C1",
        says: "Direct light by eq. 9 is dearer than Blinn-Phong, and indirect light dearer still: 769, 137 and 48.6 frames a second.",
        rule: "A trial is a step to the next picture and a backend: its frame takes longer, beyond the \
            spread of both. Blinn-Phong has no shadows; direct light is Lambert's with shadows, and part of \
            the frame with indirect light. The lamp is a distant area light, seen 90° wide along its normal.",
    }],
};

pub(super) const FIGURE_9: Experiment = Experiment {
    id: "frisvad.9",
    paper: Paper::Frisvad,
    item: Item::Figure(9),
    title: "a cave: direct light, with eq. 15, with eq. 14",
    setup: &EverDearer {
        scenes: &[CAVE, CAVE_WITHOUT_MIRRORS],
        steps: &[Step::Direct, Step::Eq15, Step::Eq14],
        grid: GRID,
    },
    claims: &[Claim {
        id: "C1",
        says: "Eq. 15 is dearer than direct light alone and eq. 14 than eq. 15, with mirrors (20.8, 11.9, 7.7 frames a second) and without (48.0, 18.4, 10.3).",
        rule: "A trial is a scene, a step to the next picture and a backend: its frame takes longer, beyond the \
            spread of both.",
    }],
};

/// What of a picture from the light is used.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Grid {
    /// w, texels along the edge of the picture.
    texels: u32,
    /// Samples along the edge.
    samples: u32,
}

/// The paper's.
pub(super) const GRID: Grid = Grid {
    texels: 16,
    samples: 3,
};

/// What a picture shows; mirrors show what the step's name says of them, else all that is in them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Step {
    /// Local shading by the whole material, without shadows.
    BlinnPhong,
    /// Direct light of diffuse surfaces, with shadows.
    Direct,
    /// Direct and indirect light, a solid angle by its equation.
    Eq11,
    Eq14,
    Eq15,
    /// By eq. 14, with direct light alone in mirrors.
    Eq14WithoutMirrored,
    /// By eq. 14, mirrors as if they were diffuse on top of what they show of direct light.
    Eq14MirrorsAsDiffuse,
}

impl Step {
    /// Under a picture and in a table.
    pub(super) fn caption(self) -> &'static str {
        match self {
            Self::BlinnPhong => "Blinn-Phong",
            Self::Direct => "direct light",
            Self::Eq11 => "eq. 11",
            Self::Eq14 => "eq. 14",
            Self::Eq15 => "eq. 15",
            Self::Eq14WithoutMirrored => "eq. 14, none in mirrors",
            Self::Eq14MirrorsAsDiffuse => "eq. 14, mirrors as if diffuse",
        }
    }

    /// Value of the parameter `solid_angle`.
    fn solid_angle(self) -> Option<&'static str> {
        match self {
            Self::BlinnPhong | Self::Direct => None,
            Self::Eq11 => Some("eq11"),
            Self::Eq15 => Some("eq15"),
            Self::Eq14 | Self::Eq14WithoutMirrored | Self::Eq14MirrorsAsDiffuse => Some("eq14"),
        }
    }

    fn mirrors(self) -> Mirrors {
        match self {
            Self::Eq14WithoutMirrored => Mirrors::Direct,
            Self::Eq14MirrorsAsDiffuse => Mirrors::Diffuse,
            _ => Mirrors::Included,
        }
    }

    fn direct_light(self) -> DirectLight {
        match self {
            Self::BlinnPhong => DirectLight {
                law: ReflectionLaw::BlinnPhong,
                shadows: false,
            },
            _ => ReflectionLaw::Lambert.into(),
        }
    }

    /// The map that the step's indirect light is from, if it has any.
    pub(super) fn map(
        self,
        context: &ExperimentContext<'_>,
        grid: Grid,
    ) -> Result<Option<Box<dyn Configured>>, RunError> {
        let map = |equation| {
            let settings: [(&str, &dyn ToString); 3] = [
                ("map_resolution", &grid.texels),
                ("samples_per_side", &grid.samples),
                ("solid_angle", &equation),
            ];
            context.method("direct_radiance_map", &settings)
        };
        self.solid_angle().map(map).transpose()
    }
}

/// All that the camera sees, a quarter as many pixels across in a quick run.
pub(super) fn view(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    step: Step,
) -> Result<View, RunError> {
    let look = Look {
        mirrors: step.mirrors(),
        shade: Shade::All,
        ..Look::default()
    };
    context.whole_view(loaded, context.pick(128, 512), look)
}

/// The view of a step, and the milliseconds that it takes over a few runs: rays of the CPU, for both backends.
fn seen(
    context: &ExperimentContext<'_>,
    loaded: &LoadedScene,
    step: Step,
) -> Result<(View, Amount), RunError> {
    let of_step = view(context, loaded, step)?;
    let mut times_ms = Vec::new();
    for _ in 0..3 {
        let start = Instant::now();
        view(context, loaded, step)?;
        times_ms.push(1e3 * start.elapsed().as_secs_f64());
    }
    Ok((of_step, amount_of(&times_ms)))
}

/// A picture of a step on a backend: how it looks, and a frame of it in milliseconds.
pub(super) struct Taken {
    pub(super) step: Step,
    /// Irradiance at the view's points; zeros where a step has no indirect light.
    pub(super) irradiance: Estimate,
    /// Finding what is seen, through mirrors too, direct light with shadows, and captures, preparation and shading of
    /// indirect light.
    pub(super) frame_ms: Amount,
    /// All light that reaches the camera.
    pub(super) image: crate::domain::image::HdrImage,
}

/// The steps of a scene on a backend, with their times among the finding's numbers.
pub(super) fn take(
    context: &ExperimentContext<'_>,
    (scene, loaded): (&str, &LoadedScene),
    (steps, grid, backend): (&[Step], Grid, Backend),
    finding: &mut Finding,
) -> Result<Vec<Taken>, RunError> {
    finding.note("surfaces seen are found by rays on the CPU, through mirrors too, and their time is part of both backends' frames");
    let mut taken = Vec::new();
    for &step in steps {
        let (view, seen_ms) = seen(context, loaded, step)?;
        let points = view.points(Quantity::Irradiance.layout());
        let (direct, direct_ms) =
            context.direct_light_timed(loaded, backend, (&view.seen(), step.direct_light()))?;
        let (irradiance, frame_ms) = match step.map(context, grid)? {
            None => (Estimate::new(points.len()), seen_ms.plus(direct_ms)),
            Some(map) => {
                let quantity = Quantity::Irradiance;
                let measured = context.run_timed(loaded, backend, &*map, quantity, &points)?;
                let frame_ms = measured.frame_ms().plus(direct_ms).plus(seen_ms);
                finding.runs.push(measured.run);
                (measured.estimate, frame_ms)
            }
        };
        let unit = ("ms", context.software(backend));
        let case = format!("{scene}, {}", step.caption());
        finding.time((case.as_str(), "frame"), backend, frame_ms, unit);
        finding.time((case.as_str(), "surfaces seen"), backend, seen_ms, unit);
        finding.time((case.as_str(), "direct light"), backend, direct_ms, unit);
        let materials = view.points(PointLayout::Material);
        taken.push(Taken {
            step,
            image: view.lit(&lambertian(&materials, &irradiance), &direct),
            irradiance,
            frame_ms,
        });
    }
    Ok(taken)
}

/// The steps' pictures side by side.
pub(super) fn row(scene: &str, taken: Vec<Taken>) -> Row {
    let mut row = Row::plain(scene.to_owned());
    for picture in taken {
        row.add(picture.step.caption(), picture.image);
    }
    row
}

/// That each step's frame takes longer than the one before.
pub(super) fn ever_dearer(scene: &str, backend: Backend, taken: &[Taken]) -> Vec<Trial> {
    let dearer = |pair: &[Taken]| {
        let [first, second] = [0, 1].map(|i| pair[i].step.caption());
        let what = format!("{scene}: a frame of {first} below {second}, ms");
        Trial::less(what, backend, pair[0].frame_ms, pair[1].frame_ms)
    };
    taken.windows(2).map(dearer).collect()
}

/// The scenes of a figure, the steps of each, and pictures of them beside each other.
#[derive(Serialize)]
pub(super) struct EverDearer {
    pub(super) scenes: &'static [SceneSetup],
    pub(super) steps: &'static [Step],
    #[serde(flatten)]
    pub(super) grid: Grid,
}

impl super::super::setup::Runs for EverDearer {
    fn run(&self, context: &ExperimentContext<'_>) -> Result<Finding, RunError> {
        let mut finding = Finding::default();
        for setup in self.scenes {
            let name = setup.to_string();
            let loaded = context.load(&context.place(setup), &mut finding)?;
            for backend in context.backends() {
                let what = (self.steps, self.grid, backend);
                let taken = take(context, (&name, &loaded), what, &mut finding)?;
                finding.judge("C1", ever_dearer(&name, backend, &taken));
                finding
                    .pictures
                    .push(row(&format!("{name}, {backend}"), taken));
            }
        }
        Ok(finding)
    }
}
