//! What a method's phases take, on a stage whose clock is made up: each time lands in its own phase, and a
//! frame is the sum of those that it pays.
#![allow(clippy::unwrap_used, reason = "tests")]

use interreflect::clock::Sampling;
use interreflect::frames::{Frame, Frames};
use interreflect::measure::measure;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::stage::{CpuStage, Elapsed, Phase, Placed, Stage};
use interreflect_estimators::{
    Captures, Configured, Cpu, EstimatorError, Quantity, Registry, Session, Unsupported,
};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Estimate, Needs, Point, PointLayout, Points, SceneRequest, open};
use std::sync::Arc;

const SOLVE_MS: f64 = 10_000.0;
const CAPTURE_MS: f64 = 1000.0;
const PREPARE_MS: f64 = 200.0;
const SHADE_MS: f64 = 30.0;

/// The CPU with a clock of its own.
struct Stub<'a>(CpuStage<'a>);

fn took(wall_ms: f64) -> Elapsed {
    Elapsed {
        wall_ms,
        device_ms: None,
    }
}

impl Stage for Stub<'_> {
    type Backend = Cpu;

    fn open(&self, method: &dyn Configured) -> Result<Box<dyn Session<Cpu>>, Unsupported> {
        self.0.open(method)
    }

    fn place(&self, points: &Points) -> Result<Placed<Cpu>, EstimatorError> {
        self.0.place(points)
    }

    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError> {
        Ok(self.0.solve(needs)?.map(|_| SOLVE_MS))
    }

    fn capture(&self, needs: &Needs) -> Result<(Captures<Cpu>, Elapsed), EstimatorError> {
        Ok((self.0.capture(needs)?.0, took(CAPTURE_MS)))
    }

    fn timed(&self, label: &str, work: &mut Phase<'_, Cpu>) -> Result<Elapsed, EstimatorError> {
        self.0.timed(label, work)?;
        Ok(took(match label {
            "prepare" => PREPARE_MS,
            "shade" => SHADE_MS,
            _ => f64::NAN,
        }))
    }

    fn read_back(&self, out: &Estimate) -> Result<(Estimate, Option<f64>), EstimatorError> {
        self.0.read_back(out)
    }

    fn compiled_ms(&self) -> Option<f64> {
        None
    }

    fn host_bytes(&self, captures: &Captures<Cpu>) -> Option<u64> {
        self.0.host_bytes(captures)
    }

    fn made_bytes(&self) -> Option<u64> {
        None
    }
}

fn with_stub(check: impl FnOnce(&Stub<'_>, &dyn Configured, &Points)) {
    let scene = open(&SceneRequest::new("colored-room")).unwrap();
    let cx = CpuCx::new(None, None).unwrap();
    let stub = Stub(CpuStage {
        cx: &cx,
        scene: Arc::new(CpuScene::new(&scene).unwrap()),
    });
    let mut method = Registry::builtin()
        .get("constant_ambient")
        .unwrap()
        .configure();
    method.set("capture_resolution", "8").unwrap();
    method.set("bounces", "1").unwrap();
    let point = Point {
        normal: glam::Vec3::Y,
        ..Point::default()
    };
    let points = Points::new(PointLayout::Surface, [Some(point)]);
    check(&stub, &*method, &points);
}

#[test]
fn a_frame_pays_for_captures_preparation_and_shading() {
    with_stub(|stub, method, points| {
        let scene = stub.0.scene.scene();
        let mut frames = Frames::new(stub, method).unwrap();
        let mut ms = |moves| {
            let frame = Frame {
                scene,
                moves,
                points,
                seen: None,
            };
            let shaded = frames.next(stub, method, Quantity::Irradiance, &frame);
            shaded.unwrap().ms
        };
        let still = Moves::default();
        let all = CAPTURE_MS + PREPARE_MS + SHADE_MS;
        assert_eq!(ms(still), all, "the first frame");
        assert_eq!(ms(still), PREPARE_MS + SHADE_MS, "captures are kept");
        let camera = Moves {
            camera: true,
            ..still
        };
        assert_eq!(ms(camera), PREPARE_MS + SHADE_MS, "the camera alone moves");
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
            assert_eq!(ms(moves), all, "{moves:?}");
        }
    });
}

#[test]
fn each_time_is_its_own_phase_s() {
    with_stub(|stub, method, points| {
        let scene = stub.0.scene.scene();
        for sampling in [
            Sampling::ONCE,
            Sampling {
                least: 3,
                most: 3,
                patience_ms: 1e9,
                ..Sampling::default()
            },
        ] {
            let quantity = Quantity::Irradiance;
            let measured = measure(stub, scene, method, quantity, points, &sampling).unwrap();
            let phases = measured.phases;
            let median = |phase: Option<interreflect::record::Timing>| phase.map(|t| t.median);
            assert_eq!(median(phases.solve), Some(SOLVE_MS));
            assert_eq!(median(phases.capture), Some(CAPTURE_MS));
            assert_eq!(median(phases.prepare), Some(PREPARE_MS));
            assert_eq!(median(phases.shade), Some(SHADE_MS));
            assert_eq!((phases.compile, phases.readback), (None, None));
            let frame = CAPTURE_MS + PREPARE_MS + SHADE_MS;
            assert_eq!(phases.frame_ms(), Some(frame));
            assert_eq!(phases.shade.map(|t| t.n), Some(sampling.most));
        }
    });
}
