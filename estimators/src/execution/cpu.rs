//! A scene on the CPU.

use super::{BackendScene, Elapsed, Phase, Placed, environment, sum};
use crate::{Captures, Configured, Cpu, EstimatorError, Session, Unsupported};
use interreflect_cpu::capture::cube::capture_cube;
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::capture::rsm::capture_rsms;
use interreflect_cpu::direct::direct_light;
use interreflect_cpu::path_tracer::CoarseSolution;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_scene::{DirectLight, Estimate, Needs, Points, Scene};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

/// A scene on the CPU.
#[derive(Clone)]
pub struct CpuLoadedScene {
    /// Threads and instruction set.
    pub cx: CpuCx,
    /// The scene.
    pub scene: Arc<CpuScene>,
}

impl CpuLoadedScene {
    /// A scene that these threads work on.
    pub fn new(cx: &CpuCx, scene: Arc<CpuScene>) -> Self {
        let cx = cx.clone();
        Self { cx, scene }
    }

    /// The coarse solutions of all captures, each once.
    pub(super) fn solutions(&self, needs: &Needs) -> BTreeMap<u32, Arc<CoarseSolution>> {
        let solve = |spec| self.cx.install(|| self.scene.coarse_for(spec));
        let solutions = needs.cubes.iter().filter_map(solve);
        solutions.map(|s| (s.irradiance.bounces(), s)).collect()
    }
}

impl BackendScene for CpuLoadedScene {
    type Backend = Cpu;

    fn scene(&self) -> &Scene {
        self.scene.scene()
    }

    fn caps(&self) -> &() {
        &()
    }

    fn open(&self, method: &dyn Configured) -> Result<Box<dyn Session<Cpu>>, Unsupported> {
        method.on_cpu()
    }

    fn place(&self, points: &Points) -> Result<Placed<Cpu>, EstimatorError> {
        points.validate()?;
        Ok(Placed {
            points: points.clone(),
            out: Estimate::new(points.len()),
        })
    }

    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError> {
        Ok(sum(self.solutions(needs).values().map(|s| s.ms)))
    }

    fn capture(&self, needs: &Needs) -> Result<(Captures<Cpu>, Elapsed), EstimatorError> {
        self.solve(needs)?;
        let origin = self.scene.scene().capture_origin(needs.keep_within_m);
        let mut captures = Captures::default();
        let start = Instant::now();
        for spec in &needs.cubes {
            let capture = || capture_cube(&self.scene, origin, *spec);
            let cube = self.cx.install(capture);
            captures.cubes.insert(*spec, cube);
        }
        for spec in &needs.rsms {
            let capture = || capture_rsms(&self.scene, *spec);
            let views = self.cx.install(capture);
            captures.rsms.insert(*spec, views);
        }
        let elapsed = Elapsed::since(start);
        for &spec in &needs.directional_depths {
            let depths = DirectionalDepths::new(self.scene.clone(), spec);
            captures.depths.insert(spec, depths);
        }
        captures.environment = environment(needs, self.scene.scene());
        if needs.light_transport {
            captures.transport = Some(self.scene.clone());
        }
        Ok((captures, elapsed))
    }

    fn timed(&self, _label: &str, work: &mut Phase<'_, Cpu>) -> Result<Elapsed, EstimatorError> {
        let mut cx = self.cx.clone();
        let start = Instant::now();
        work(&mut cx)?;
        Ok(Elapsed::since(start))
    }

    fn direct_light(
        &self,
        placed: &mut Placed<Cpu>,
        how: DirectLight,
    ) -> Result<Elapsed, EstimatorError> {
        let start = Instant::now();
        placed.out = (self.cx).install(|| direct_light(&self.scene, &placed.points, how));
        Ok(Elapsed::since(start))
    }

    fn read_back(&self, out: &Estimate) -> Result<(Estimate, Option<f64>), EstimatorError> {
        Ok((out.clone(), None))
    }

    fn compiled_ms(&self) -> Option<f64> {
        None
    }

    fn host_bytes(&self, captures: &Captures<Cpu>) -> Option<u64> {
        let cubes = captures.cubes.values().map(|cube| cube.bytes());
        let views = captures.rsms.values().map(|views| views.bytes());
        Some(cubes.chain(views).map(|bytes| bytes as u64).sum())
    }

    fn made_bytes(&self) -> Option<u64> {
        None
    }

    fn software(&self) -> bool {
        false
    }
}
