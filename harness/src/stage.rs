//! A scene set up on one backend: where captures, points and estimates live, and how a phase is
//! timed there.

use interreflect_cpu::capture::cube::capture_cube as capture_cube_cpu;
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::capture::light_view::capture_light_views as capture_light_views_cpu;
use interreflect_cpu::path_tracer::CoarseSolution;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::{
    Backend, Captures, Configured, Cpu, EstimatorError, Gpu, Session, Unsupported,
};
use interreflect_gpu::{
    GpuCoarseIrradiance, GpuContext, GpuDirectionalDepths, GpuEstimate, GpuOccluders, GpuPoints,
    GpuScene, GpuTime, TimeSource, capture_cube as capture_cube_gpu,
    capture_light_views as capture_light_views_gpu,
};
use interreflect_scene::{Environment, Estimate, Needs, Points, Scene};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::sync::Arc;
use std::time::Instant;

/// What an estimator does in one phase.
pub type Phase<'p, B> = dyn FnMut(&mut <B as Backend>::Cx<'_>) -> Result<(), EstimatorError> + 'p;

/// A backend with a scene on it.
pub trait Stage {
    /// The backend.
    type Backend: Backend;

    /// Starts a method here.
    ///
    /// # Errors
    /// [`Unsupported`] if it has no implementation here.
    fn open(&self, method: &dyn Configured)
    -> Result<Box<dyn Session<Self::Backend>>, Unsupported>;

    /// Puts points, and room for their estimate, where the backend reads them.
    ///
    /// # Errors
    /// [`EstimatorError`] if they don't fit.
    fn place(&self, points: &Points) -> Result<Placed<Self::Backend>, EstimatorError>;

    /// Finds the coarse solutions that captured radiance will hold: work done once for a scene, not
    /// once a frame. The milliseconds that this took when it was done, `None` if nothing is needed.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError>;

    /// Makes every capture that is needed, those that would be kept too, where they were made;
    /// milliseconds, without those of [`Stage::solve`].
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn capture(&self, needs: &Needs) -> Result<(Captures<Self::Backend>, f64), EstimatorError>;

    /// Runs one phase to its end; milliseconds.
    ///
    /// # Errors
    /// [`EstimatorError`] if the work fails or the backend refuses.
    fn timed(
        &self,
        label: &str,
        work: &mut Phase<'_, Self::Backend>,
    ) -> Result<f64, EstimatorError>;

    /// Brings the estimate to the host; milliseconds, or `None` where it is there already.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    fn read_back(
        &self,
        out: &<Self::Backend as Backend>::Out,
    ) -> Result<(Estimate, Option<f64>), EstimatorError>;

    /// Milliseconds spent compiling so far, or `None` where nothing is compiled.
    fn compiled_ms(&self) -> Option<f64>;

    /// Whether all phases so far were timed by the device's own clock.
    fn device_clock(&self) -> bool;
}

/// Points and room for their estimate on a backend.
pub struct Placed<B: Backend> {
    /// The points.
    pub points: B::Points,
    /// Where the estimate goes.
    pub out: B::Out,
}

/// A scene on the CPU.
#[derive(Clone)]
pub struct CpuStage<'a> {
    /// Threads and instruction set.
    pub cx: &'a CpuCx,
    /// The scene.
    pub scene: Arc<CpuScene>,
}

impl CpuStage<'_> {
    /// The coarse solutions of all captures, each once.
    fn solutions(&self, needs: &Needs) -> BTreeMap<u32, Arc<CoarseSolution>> {
        let solve = |spec| self.cx.install(|| self.scene.coarse_for(spec));
        let solutions = needs.cubes.iter().filter_map(solve);
        solutions.map(|s| (s.irradiance.bounces(), s)).collect()
    }
}

impl Stage for CpuStage<'_> {
    type Backend = Cpu;

    fn open(&self, method: &dyn Configured) -> Result<Box<dyn Session<Cpu>>, Unsupported> {
        method.on_cpu()
    }

    fn place(&self, points: &Points) -> Result<Placed<Cpu>, EstimatorError> {
        Ok(Placed {
            points: points.clone(),
            out: Estimate::new(points.len()),
        })
    }

    fn solve(&self, needs: &Needs) -> Result<Option<f64>, EstimatorError> {
        Ok(sum(self.solutions(needs).values().map(|s| s.ms)))
    }

    fn capture(&self, needs: &Needs) -> Result<(Captures<Cpu>, f64), EstimatorError> {
        self.solve(needs)?;
        let origin = self.scene.scene().capture_origin(needs.keep_within_m);
        let mut captures = Captures::default();
        let start = Instant::now();
        for spec in &needs.cubes {
            let capture = || capture_cube_cpu(&self.scene, origin, *spec);
            let cube = self.cx.install(capture);
            captures.cubes.insert(*spec, cube);
        }
        for spec in &needs.light_views {
            let capture = || capture_light_views_cpu(&self.scene, *spec);
            let views = self.cx.install(capture);
            captures.light_views.insert(*spec, views);
        }
        let ms = milliseconds(start);
        for &spec in &needs.directional_depths {
            let depths = DirectionalDepths::new(self.scene.clone(), spec);
            captures.depths.insert(spec, depths);
        }
        captures.environment = environment(needs, self.scene.scene());
        if needs.light_transport {
            captures.transport = Some(self.scene.clone());
        }
        Ok((captures, ms))
    }

    fn timed(&self, _label: &str, work: &mut Phase<'_, Cpu>) -> Result<f64, EstimatorError> {
        let mut cx = self.cx;
        let start = Instant::now();
        work(&mut cx)?;
        Ok(milliseconds(start))
    }

    fn read_back(&self, out: &Estimate) -> Result<(Estimate, Option<f64>), EstimatorError> {
        Ok((out.clone(), None))
    }

    fn compiled_ms(&self) -> Option<f64> {
        None
    }

    fn device_clock(&self) -> bool {
        false
    }
}

/// A scene on the GPU.
pub struct GpuStage<'a> {
    /// The device.
    pub context: Arc<GpuContext>,
    /// The scene, uploaded.
    pub scene: GpuScene,
    host: CpuStage<'a>,
    /// Uploaded coarse solutions by their bounces, with the milliseconds that solving and uploading
    /// took.
    coarse: RefCell<BTreeMap<u32, (GpuCoarseIrradiance, f64)>>,
    /// All triangles, uploaded when depth maps of them are first asked for.
    occluders: RefCell<Option<Arc<GpuOccluders>>>,
    fell_back: Cell<bool>,
}

impl<'a> GpuStage<'a> {
    /// A scene on a device; `host` is the same scene, for what the host computes once.
    pub fn new(context: Arc<GpuContext>, scene: GpuScene, host: CpuStage<'a>) -> Self {
        Self {
            context,
            scene,
            host,
            coarse: RefCell::default(),
            occluders: RefCell::default(),
            fell_back: Cell::new(false),
        }
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

    /// Milliseconds of a recording; remembers if the device's clock was of no use.
    fn milliseconds(&self, time: GpuTime) -> f64 {
        if time.source == TimeSource::WallClock {
            self.fell_back.set(true);
        }
        time.ms
    }
}

impl Stage for GpuStage<'_> {
    type Backend = Gpu;

    fn open(&self, method: &dyn Configured) -> Result<Box<dyn Session<Gpu>>, Unsupported> {
        method.on_gpu(&self.context)
    }

    fn place(&self, points: &Points) -> Result<Placed<Gpu>, EstimatorError> {
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

    fn capture(&self, needs: &Needs) -> Result<(Captures<Gpu>, f64), EstimatorError> {
        self.solve(needs)?;
        let coarse = self.coarse.borrow();
        let scene = self.host.scene.scene();
        let origin = scene.capture_origin(needs.keep_within_m);
        let mut captures = Captures::default();
        let (_, time) = self.context.record("capture", |cx| {
            for spec in &needs.cubes {
                let coarse = coarse.get(&spec.bounces).map(|(c, _)| c);
                let cube = capture_cube_gpu(cx, &self.scene, origin, *spec, coarse)?;
                captures.cubes.insert(*spec, cube);
            }
            for spec in &needs.light_views {
                let views = capture_light_views_gpu(cx, &self.scene, *spec)?;
                captures.light_views.insert(*spec, views);
            }
            Ok::<_, EstimatorError>(())
        })?;
        for &spec in &needs.directional_depths {
            let depths = GpuDirectionalDepths::new(self.occluders()?, spec);
            captures.depths.insert(spec, depths);
        }
        captures.environment = environment(needs, scene);
        Ok((captures, self.milliseconds(time)))
    }

    fn timed(&self, label: &str, work: &mut Phase<'_, Gpu>) -> Result<f64, EstimatorError> {
        let (_, time) = self.context.record(label, |cx| work(cx))?;
        Ok(self.milliseconds(time))
    }

    fn read_back(&self, out: &GpuEstimate) -> Result<(Estimate, Option<f64>), EstimatorError> {
        let start = Instant::now();
        let estimate = out.download(&self.context)?;
        Ok((estimate, Some(milliseconds(start))))
    }

    fn compiled_ms(&self) -> Option<f64> {
        Some(self.context.cache_stats().ms)
    }

    fn device_clock(&self) -> bool {
        self.context.device_clock() && !self.fell_back.get()
    }
}

/// The environment, where it is asked for.
fn environment(needs: &Needs, scene: &Scene) -> Option<Environment> {
    scene.environment.clone().filter(|_| needs.environment)
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// The sum of some times; `None` without any.
fn sum(times_ms: impl Iterator<Item = f64>) -> Option<f64> {
    times_ms.reduce(|a, b| a + b)
}
