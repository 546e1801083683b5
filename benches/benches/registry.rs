//! Every registered method in each fidelity and quantity on each backend, and the captures.
//!
//! Times on a software adapter say nothing about a GPU: their ids say `gpu-software`.

use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, measurement::WallTime};
use criterion::{criterion_group, criterion_main};
use interreflect::view::View;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::stage::{CpuStage, GpuStage, Placed, Stage};
use interreflect_estimators::{
    Changed, Configured, EstimatorError, Inputs, Quantity, Registry, Unsupported,
};
use interreflect_gpu::{GpuContext, GpuScene};
use interreflect_scene::{
    CubeChannels, CubeSpec, LightViewChannels, LightViewSpec, Needs, Point, PointLayout, Points,
    SceneRequest, open,
};
use std::sync::Arc;
use std::time::Duration;

/// Points that are shaded.
const POINTS: usize = 65_536;

/// The scene: walls of six colours, a light with shadows, a glossy receiver.
const SCENE: &str = "colored-room";

struct Lab {
    cx: CpuCx,
    scene: Arc<CpuScene>,
    points: Vec<Point>,
}

impl Lab {
    fn new() -> Self {
        let scene = open(&SceneRequest::new(SCENE)).expect("a scene of the library");
        let cpu = Arc::new(CpuScene::new(&scene).expect("a scene that the CPU takes"));
        let cx = CpuCx::new(None, None).expect("a pool of threads");
        let view = cx.install(|| View::of_about(&cpu, &scene.camera, POINTS));
        let view = view.expect("a view with points");
        let seen = view.points(PointLayout::Material);
        let on_receiver: Vec<_> = seen.iter().flatten().collect();
        Self {
            points: on_receiver.iter().copied().cycle().take(POINTS).collect(),
            scene: cpu,
            cx,
        }
    }

    fn cpu(&self) -> CpuStage<'_> {
        CpuStage {
            cx: &self.cx,
            scene: self.scene.clone(),
        }
    }

    /// The scene on the GPU and how its times are labelled; `None` without an adapter.
    fn gpu(&self) -> Option<(GpuStage<'_>, &'static str)> {
        let context = GpuContext::new(None)
            .inspect_err(|e| eprintln!("no GPU benchmarks: {e}"))
            .ok()?;
        let scene =
            GpuScene::new(&context, self.scene.scene()).expect("a scene that the GPU takes");
        let label = match context.info().software {
            true => "gpu-software",
            false => "gpu",
        };
        Some((GpuStage::new(context, scene, self.cpu()), label))
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
    let lab = Lab::new();
    let gpu = lab.gpu();
    for (name, method) in variants() {
        for quantity in method.quantities() {
            let mut group = criterion.benchmark_group(format!("{name}/{}", quantity.name()));
            settings(&mut group);
            let run = Run {
                lab: &lab,
                method: &*method,
                quantity: *quantity,
            };
            run.on(&mut group, &lab.cpu(), "cpu");
            if let Some((stage, label)) = &gpu {
                run.on(&mut group, stage, label);
            }
            group.finish();
        }
    }
}

struct Run<'a> {
    lab: &'a Lab,
    method: &'a dyn Configured,
    quantity: Quantity,
}

impl Run<'_> {
    fn on<S: Stage>(&self, group: &mut Group<'_>, stage: &S, backend: &str) {
        if let Err(error) = self.bench(group, stage, backend) {
            match error {
                EstimatorError::Unsupported(Unsupported(why)) => eprintln!("not run: {why}"),
                error => panic!("{}: {error}", self.method.info().id),
            }
        }
    }

    fn bench<S: Stage>(
        &self,
        group: &mut Group<'_>,
        stage: &S,
        backend: &str,
    ) -> Result<(), EstimatorError> {
        let (scene, quantity) = (self.lab.scene.scene(), self.quantity);
        let needs = self.method.needs(quantity, &scene.facts())?;
        let mut session = stage.open(self.method)?;
        let points = Points::new(quantity.layout(), self.lab.points.iter().copied().map(Some));
        let Placed {
            points: placed,
            mut out,
        } = stage.place(&points)?;
        let (captures, _) = stage.capture(&needs)?;
        let origin = (scene.facts(), scene.reference_point);
        let inputs = Inputs::new(&needs, &captures, &placed, &points, origin, Changed::ALL);
        let mut prepare = || {
            stage.timed("prepare", &mut |cx| {
                session.prepare(cx, quantity, &inputs, &out)
            })
        };
        prepare()?;
        group.bench_function(BenchmarkId::new("prepare", backend), |bencher| {
            bencher.iter(|| prepare().expect("what was prepared once"));
        });
        let mut shade = || {
            stage.timed("shade", &mut |cx| {
                session.shade(cx, quantity, &inputs, &mut out)
            })
        };
        shade()?;
        group.throughput(Throughput::Elements(POINTS as u64));
        group.bench_function(BenchmarkId::new("shade", backend), |bencher| {
            bencher.iter(|| shade().expect("what was shaded once"));
        });
        Ok(())
    }
}

/// A cube of 256² texels a face: radiance alone, and with distance and normal.
fn captures(criterion: &mut Criterion) {
    let lab = Lab::new();
    let gpu = lab.gpu();
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
            &lab.cpu(),
            BenchmarkId::new(name, "cpu"),
            &needs,
        );
        if let Some((stage, label)) = &gpu {
            capture(&mut group, stage, BenchmarkId::new(name, label), &needs);
        }
    }
    group.finish();
}

/// Views from the light, 16² and 256² texels each, with position, radiance and normal.
fn light_views(criterion: &mut Criterion) {
    let lab = Lab::new();
    let gpu = lab.gpu();
    let mut group = criterion.benchmark_group("capture/light views");
    settings(&mut group);
    for size in [16, 256] {
        let channels = LightViewChannels {
            radiance: true,
            normal: true,
            true_colors: false,
        };
        let needs = Needs {
            light_views: [LightViewSpec { size, channels }].into(),
            ..Needs::default()
        };
        let name = format!("{size}");
        capture(
            &mut group,
            &lab.cpu(),
            BenchmarkId::new(&name, "cpu"),
            &needs,
        );
        if let Some((stage, label)) = &gpu {
            capture(&mut group, stage, BenchmarkId::new(&name, label), &needs);
        }
    }
    group.finish();
}

fn capture<S: Stage>(group: &mut Group<'_>, stage: &S, id: BenchmarkId, needs: &Needs) {
    group.bench_function(id, |bencher| {
        bencher.iter(|| stage.capture(needs).expect("a capture").1);
    });
}

criterion_group!(benches, methods, captures, light_views);
criterion_main!(benches);
