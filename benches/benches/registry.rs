//! Every registered method in each fidelity and quantity on each backend, and the captures.
//!
//! Times on a software adapter say nothing about a GPU: their ids say `gpu-software`.

use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, measurement::WallTime};
use criterion::{criterion_group, criterion_main};
use interreflect::view::{Shade, View};
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::execution::{BackendScene, GpuLoadedScene, LoadedScene};
use interreflect_estimators::{
    Changed, Configured, EstimatorError, Quantity, Registry, Unsupported,
};
use interreflect_gpu::GpuContext;
use interreflect_scene::{
    CubeChannels, CubeSpec, Needs, Point, PointLayout, Points, RsmChannels, RsmSpec, RsmViews,
    SceneRequest, open,
};
use std::time::Duration;

/// Points that are shaded.
const POINTS: usize = 65_536;

/// The scene: walls of six colours, a light with shadows, a glossy receiver.
const SCENE: &str = "colored-room";

/// What is benchmarked on: a loaded scene, and points of it.
struct Fixture {
    loaded: LoadedScene,
    points: Vec<Point>,
}

impl Fixture {
    fn new() -> Self {
        let scene = open(&SceneRequest::new(SCENE)).expect("a scene of the library");
        let cx = CpuCx::new(None, None).expect("a pool of threads");
        let loaded = LoadedScene::new(&cx, &scene).expect("a scene that the CPU takes");
        let cpu = &loaded.cpu().scene;
        let view = cx.install(|| View::of_about(cpu, &scene.camera, (POINTS, Shade::default())));
        let view = view.expect("a view with points");
        let seen = view.points(PointLayout::Material);
        let on_receiver: Vec<_> = seen.iter().flatten().collect();
        let points = on_receiver.iter().copied().cycle().take(POINTS).collect();
        let loaded = match GpuContext::new(None) {
            Ok(context) => loaded
                .with_gpu(&context)
                .expect("a scene that the GPU takes"),
            Err(why) => {
                eprintln!("no GPU benchmarks: {why}");
                loaded
            }
        };
        Self { loaded, points }
    }

    /// The scene on the GPU and how its times are labelled; `None` without an adapter.
    fn gpu(&self) -> Option<(&GpuLoadedScene, &'static str)> {
        let side = self.loaded.gpu().ok()?;
        let label = match side.software() {
            true => "gpu-software",
            false => "gpu",
        };
        Some((side, label))
    }
}

/// Each method in each of its fidelities, with the name of its benchmarks.
fn variants() -> Vec<(String, Box<dyn Configured>)> {
    let mut variants = Vec::new();
    for entry in Registry::builtin().entries() {
        let id = entry.info().id;
        let mut method = entry.configure();
        // One that samples takes its time for each sample: the least shows it.
        method.set("samples", "1").ok();
        variants.extend(method.in_each_fidelity().into_iter().map(|method| {
            let fidelity = method.fidelity().map(|f| format!(".{f}"));
            (format!("{id}{}", fidelity.unwrap_or_default()), method)
        }));
    }
    variants
}

type Group<'a> = BenchmarkGroup<'a, WallTime>;

fn settings(group: &mut Group<'_>) {
    group
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
}

fn methods(criterion: &mut Criterion) {
    let fixture = Fixture::new();
    let gpu = fixture.gpu();
    for (name, method) in variants() {
        for quantity in method.quantities() {
            let mut group = criterion.benchmark_group(format!("{name}/{}", quantity.name()));
            settings(&mut group);
            let run = Run {
                fixture: &fixture,
                method: &*method,
                quantity: *quantity,
            };
            run.on(&mut group, fixture.loaded.cpu(), "cpu");
            if let Some((loaded, label)) = gpu {
                run.on(&mut group, loaded, label);
            }
            group.finish();
        }
    }
}

struct Run<'a> {
    fixture: &'a Fixture,
    method: &'a dyn Configured,
    quantity: Quantity,
}

impl Run<'_> {
    fn on<S: BackendScene>(&self, group: &mut Group<'_>, loaded: &S, backend: &str) {
        if let Err(error) = self.bench(group, loaded, backend) {
            match error {
                EstimatorError::Unsupported(Unsupported(why)) => eprintln!("not run: {why}"),
                error => panic!("{}: {error}", self.method.info().id),
            }
        }
    }

    fn bench<S: BackendScene>(
        &self,
        group: &mut Group<'_>,
        loaded: &S,
        backend: &str,
    ) -> Result<(), EstimatorError> {
        let points = self.fixture.points.iter().copied().map(Some);
        let points = Points::new(self.quantity.layout(), points);
        let mut executor = loaded.executor(self.method, self.quantity, &points)?;
        executor.prepare(Changed::ALL)?;
        group.bench_function(BenchmarkId::new("prepare", backend), |bencher| {
            bencher.iter(|| {
                executor
                    .prepare(Changed::ALL)
                    .expect("what was prepared once")
            });
        });
        executor.shade()?;
        group.throughput(Throughput::Elements(POINTS as u64));
        group.bench_function(BenchmarkId::new("shade", backend), |bencher| {
            bencher.iter(|| executor.shade().expect("what was shaded once"));
        });
        Ok(())
    }
}

/// A cube of 256² texels a face: radiance alone, and with distance and normal.
fn captures(criterion: &mut Criterion) {
    let fixture = Fixture::new();
    let gpu = fixture.gpu();
    let mut group = criterion.benchmark_group("capture/cube 256");
    settings(&mut group);
    for (name, located) in [("radiance", false), ("radiance+distance+normal", true)] {
        let spec = CubeSpec {
            size: 256,
            channels: CubeChannels {
                radiance: true,
                distance: located,
                normal: located,
            },
            bounces: 0,
        };
        let needs = Needs {
            cubes: [spec].into(),
            ..Needs::default()
        };
        capture(
            &mut group,
            fixture.loaded.cpu(),
            BenchmarkId::new(name, "cpu"),
            &needs,
        );
        if let Some((loaded, label)) = gpu {
            capture(&mut group, loaded, BenchmarkId::new(name, label), &needs);
        }
    }
    group.finish();
}

/// Views from the light, 16² and 256² texels each, with position, radiance and normal.
fn rsms(criterion: &mut Criterion) {
    let fixture = Fixture::new();
    let gpu = fixture.gpu();
    let mut group = criterion.benchmark_group("capture/RSMs");
    settings(&mut group);
    for size in [16, 256] {
        let channels = RsmChannels {
            radiance: true,
            normal: true,
            true_colors: false,
        };
        let needs = Needs {
            rsms: [RsmSpec {
                size,
                views: RsmViews::Surround,
                channels,
            }]
            .into(),
            ..Needs::default()
        };
        let name = format!("{size}");
        capture(
            &mut group,
            fixture.loaded.cpu(),
            BenchmarkId::new(&name, "cpu"),
            &needs,
        );
        if let Some((loaded, label)) = gpu {
            capture(&mut group, loaded, BenchmarkId::new(&name, label), &needs);
        }
    }
    group.finish();
}

fn capture<S: BackendScene>(group: &mut Group<'_>, loaded: &S, id: BenchmarkId, needs: &Needs) {
    group.bench_function(id, |bencher| {
        bencher.iter(|| loaded.capture(needs).expect("a capture").1);
    });
}

criterion_group!(benches, methods, captures, rsms);
criterion_main!(benches);
