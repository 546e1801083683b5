//! What a method's phases take: each time lands in its own phase, and a frame is the sum of those that it
//! pays.
//!
//! A method sleeps in its phases, and captures so many texels that this takes longer than both: a loaded
//! machine makes everything slower, and a phase is taken for another only if it sleeps several times too long.
#![allow(clippy::unwrap_used, reason = "tests")]

use interreflect::clock::Sampling;
use interreflect::frames::{self, Frames};
use interreflect::measure::measure;
use interreflect::prelude::*;
use interreflect::record::Timing;
use interreflect::{Entry, Registry};
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::{BackendScene, CpuLoadedScene};
use interreflect_estimators::{Configured, EstimatorError};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Point, Points, SceneRequest, open};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use smart_default::SmartDefault;
use std::sync::Arc;
use std::time::Duration;

/// A phase sleeps so long; it never takes as long as the next one on this list.
const SHADE_MS: f64 = 10.0;
const PREPARE_MS: f64 = 300.0;
/// A capture takes at least as long.
const CAPTURE_MS: f64 = 1000.0;

fn sleep(ms: f64) {
    std::thread::sleep(Duration::from_secs_f64(ms * 1e-3));
}

/// Sleeps in its phases, and estimates nothing.
#[derive(Clone, Debug, PartialEq, SmartDefault, Serialize, Deserialize, JsonSchema)]
struct Sleepy {
    /// Texels along a face's edge when the surroundings are captured.
    #[default(32)]
    #[schemars(range(min = 1, max = 65536), extend("unit" = "texels"))]
    capture_resolution: u32,
}

impl Method for Sleepy {
    const INFO: Info = Info {
        id: "sleepy",
        title: "Sleep",
        summary: "sleeps in its phases",
        references: &[],
        figure: None,
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::Irradiance];

    fn needs(&self, _: Quantity, _: &SceneFacts) -> Result<Needs, Unsupported> {
        let cube = CubeSpec {
            bounces: 1,
            ..CubeSpec::of_radiance(self.capture_resolution)
        };
        Ok(Needs {
            cubes: [cube].into(),
            ..Needs::default()
        })
    }

    fn model(&self, _: Quantity) -> OwnModel {
        OwnModel::MeanRadiance { bounces: 1 }
    }

    fn claims(&self, _: Quantity) -> Vec<Claim> {
        Vec::new()
    }
}

impl CpuOnly for Sleepy {
    const NO_GPU: &'static str = "it sleeps on the CPU only";
}

struct Asleep;

impl Estimator<Cpu> for Sleepy {
    type Prepared = Asleep;

    fn prepare(&self, _: &mut Frame<'_, Cpu>, _: Option<Asleep>) -> Result<Asleep, EstimatorError> {
        sleep(PREPARE_MS);
        Ok(Asleep)
    }
}

impl Prepared<Cpu> for Asleep {
    fn shade(&self, _: &mut Frame<'_, Cpu>) -> Result<(), EstimatorError> {
        sleep(SHADE_MS);
        Ok(())
    }
}

/// A scene, and the method with captures that take long enough there.
fn with_sleepy(check: impl FnOnce(&CpuLoadedScene, &dyn Configured, &Points)) {
    let scene = open(&SceneRequest::new("colored-room")).unwrap();
    let cx = CpuCx::new(Some(1), None).unwrap();
    let scene = CpuLoadedScene::new(&cx, Arc::new(CpuScene::new(&scene).unwrap()));
    let registry = Registry::builtin().with(Entry::cpu_only::<Sleepy>());
    let mut method = registry.get("sleepy").unwrap().configure();
    let facts = scene.scene().facts();
    let mut texels = 32_f64;
    loop {
        let size = texels.ceil().to_string();
        method.set("capture_resolution", &size).unwrap();
        let needs = method.needs(Quantity::Irradiance, &facts).unwrap();
        // Half as fast again, as other load goes away.
        let least_ms = [(); 2].map(|()| scene.capture(&needs).unwrap().1.ms());
        let missing = 1.5 * CAPTURE_MS / least_ms[0].min(least_ms[1]);
        if missing <= 1.0 {
            break;
        }
        texels *= (1.2 * missing).sqrt().min(4.0);
    }
    let point = Point {
        normal: Vec3::Y,
        ..Point::default()
    };
    let points = Points::new(PointLayout::Surface, [Some(point)]);
    check(&scene, &*method, &points);
}

#[test]
fn a_frame_pays_for_captures_preparation_and_shading() {
    with_sleepy(|loaded, method, points| {
        let mut frames = Frames::<Cpu>::default();
        let mut ms = |moves| {
            let frame = frames::Frame {
                scene: loaded.scene(),
                moves,
                points,
                visible: None,
            };
            let shaded = frames.next(loaded, method, Quantity::Irradiance, &frame);
            shaded.unwrap().ms
        };
        let still = Moves::default();
        let all = |ms: f64| ms >= CAPTURE_MS + PREPARE_MS + SHADE_MS;
        let kept = |ms: f64| (PREPARE_MS + SHADE_MS..CAPTURE_MS).contains(&ms);
        let first = ms(still);
        assert!(all(first), "the first frame: {first} ms");
        let next = ms(still);
        assert!(kept(next), "captures are kept: {next} ms");
        let camera = ms(Moves {
            camera: true,
            ..still
        });
        assert!(kept(camera), "the camera alone moves: {camera} ms");
        for moves in [
            Moves {
                geometry: true,
                ..still
            },
            Moves {
                lights: true,
                ..still
            },
            Moves {
                environment: true,
                ..still
            },
        ] {
            let ms = ms(moves);
            assert!(all(ms), "{moves:?}: {ms} ms");
        }
    });
}

#[test]
fn each_time_is_its_own_phase_s() {
    with_sleepy(|loaded, method, points| {
        for sampling in [
            Sampling::ONCE,
            Sampling {
                least: 3,
                most: 3,
                patience_ms: 1e9,
                ..Sampling::default()
            },
        ] {
            let measured = measure(loaded, method, Quantity::Irradiance, points, &sampling);
            let phases = measured.unwrap().phases;
            let median = |phase: Option<Timing>| phase.map_or(f64::NAN, |t| t.median);
            let [capture, prepare, shade] =
                [phases.capture, phases.prepare, phases.shade].map(median);
            assert!(phases.solve.is_some(), "reflections were solved for");
            assert!(capture >= CAPTURE_MS, "{capture} ms");
            assert!((PREPARE_MS..CAPTURE_MS).contains(&prepare), "{prepare} ms");
            assert!((SHADE_MS..PREPARE_MS).contains(&shade), "{shade} ms");
            assert_eq!((phases.compile, phases.readback), (None, None));
            let frame = phases.frame_ms().unwrap();
            assert!((frame - (capture + prepare + shade)).abs() < 1e-9);
            assert_eq!(phases.shade.map(|t| t.n), Some(sampling.most));
        }
    });
}
