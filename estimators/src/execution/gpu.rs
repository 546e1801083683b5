//! A scene on the GPU.

use super::{BackendScene, CpuLoadedScene, Elapsed, Phase, Placed, environment, milliseconds, sum};
use crate::{Captures, Configured, EstimatorError, Gpu, Session, Unsupported};
use interreflect_gpu::{
    GpuCoarseIrradiance, GpuContext, GpuDirectionalDepths, GpuError, GpuEstimate, GpuOccluders,
    GpuPoints, GpuScene, capture_cube, capture_rsms, direct_light,
};
use interreflect_scene::{DirectLight, Estimate, Needs, Points, Scene};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;
use std::time::Instant;

/// A scene on the GPU.
pub struct GpuLoadedScene {
    /// The device.
    pub context: Arc<GpuContext>,
    /// The scene, uploaded.
    pub scene: GpuScene,
    host: CpuLoadedScene,
    /// Uploaded coarse solutions by their bounces, with the milliseconds that solving and uploading
    /// took.
    coarse: RefCell<BTreeMap<u32, (GpuCoarseIrradiance, f64)>>,
    /// All triangles, uploaded when depth maps of them are first asked for.
    occluders: RefCell<Option<Arc<GpuOccluders>>>,
}

impl GpuLoadedScene {
    /// Uploads a scene; what the host computes once, it computes on the CPU's side.
    ///
    /// # Errors
    /// [`GpuError`] if the device refuses.
    pub fn new(context: &Arc<GpuContext>, host: CpuLoadedScene) -> Result<Self, GpuError> {
        Ok(Self {
            context: context.clone(),
            scene: GpuScene::new(context, host.scene.scene())?,
            host,
            coarse: RefCell::default(),
            occluders: RefCell::default(),
        })
    }

    fn occluders(&self) -> Result<Arc<GpuOccluders>, EstimatorError> {
        let mut known = self.occluders.borrow_mut();
        let occluders = match known.take() {
            Some(occluders) => occluders,
            None => {
                let scene = self.host.scene.scene();
                Arc::new(GpuOccluders::new(&self.context, scene)?)
            }
        };
        Ok(known.insert(occluders).clone())
    }
}

impl BackendScene for GpuLoadedScene {
    type Backend = Gpu;

    fn scene(&self) -> &Scene {
        self.host.scene.scene()
    }

    fn caps(&self) -> &GpuContext {
        &self.context
    }

    fn open(&self, method: &dyn Configured) -> Result<Box<dyn Session<Gpu>>, Unsupported> {
        method.on_gpu(&self.context)
    }

    fn place(&self, points: &Points) -> Result<Placed<Gpu>, EstimatorError> {
        points.validate()?;
        Ok(Placed {
            points: GpuPoints::upload(&self.context, points)?,
            out: GpuEstimate::new(&self.context, points.len())?,
        })
    }

    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError> {
        let solutions = self.host.solutions(needs);
        let mut uploaded = self.coarse.borrow_mut();
        for (&bounces, solution) in &solutions {
            if let Entry::Vacant(place) = uploaded.entry(bounces) {
                let start = Instant::now();
                let (context, scene) = (&self.context, &self.scene);
                let coarse = GpuCoarseIrradiance::upload(context, scene, &solution.irradiance)?;
                place.insert((coarse, solution.ms + milliseconds(start)));
            }
        }
        Ok(sum(solutions
            .keys()
            .filter_map(|k| Some(uploaded.get(k)?.1))))
    }

    fn capture(&self, needs: &Needs) -> Result<(Captures<Gpu>, Elapsed), EstimatorError> {
        self.solve(needs)?;
        let coarse = self.coarse.borrow();
        let scene = self.host.scene.scene();
        let origin = scene.capture_origin(needs.keep_within_m);
        let mut captures = Captures::default();
        let (_, time) = self.context.record("capture", |cx| {
            for spec in &needs.cubes {
                let coarse = coarse.get(&spec.bounces).map(|(c, _)| c);
                let cube = capture_cube(cx, &self.scene, origin, *spec, coarse)?;
                captures.cubes.insert(*spec, cube);
            }
            for spec in &needs.rsms {
                let views = capture_rsms(cx, &self.scene, *spec)?;
                captures.rsms.insert(*spec, views);
            }
            Ok::<_, EstimatorError>(())
        })?;
        for &spec in &needs.directional_depths {
            let depths = GpuDirectionalDepths::new(self.occluders()?, spec);
            captures.depths.insert(spec, depths);
        }
        captures.environment = environment(needs, scene);
        Ok((captures, time.into()))
    }

    fn timed(&self, label: &str, work: &mut Phase<'_, Gpu>) -> Result<Elapsed, EstimatorError> {
        let (_, time) = self.context.record(label, |cx| work(cx))?;
        Ok(time.into())
    }

    fn direct_light(
        &self,
        placed: &mut Placed<Gpu>,
        how: DirectLight,
    ) -> Result<Elapsed, EstimatorError> {
        let Placed { points, out } = placed;
        let (_, time) = self.context.record("direct light", |cx| {
            direct_light(cx, &self.scene, points, out, how)
        })?;
        Ok(time.into())
    }

    fn read_back(&self, out: &GpuEstimate) -> Result<(Estimate, Option<f64>), EstimatorError> {
        let start = Instant::now();
        let estimate = out.download(&self.context)?;
        Ok((estimate, Some(milliseconds(start))))
    }

    fn compiled_ms(&self) -> Option<f64> {
        Some(self.context.cache_stats().ms)
    }

    fn host_bytes(&self, _captures: &Captures<Gpu>) -> Option<u64> {
        None
    }

    fn made_bytes(&self) -> Option<u64> {
        Some(self.context.made_bytes())
    }

    fn software(&self) -> bool {
        self.context.info().software
    }
}
