//! `bench`: estimators on scenes, timed and compared with what is true.

use super::reference::{POINTS, stop};
use super::{print_json, print_line};
use crate::cli::Bench;
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::lab::{Lab, Loaded};
use crate::measure::{Measured, measure};
use crate::output::write_json;
use crate::progress;
use crate::record::{Backend, Results, Run, TimeSource};
use crate::report::Report;
use crate::stage::{CpuStage, GpuStage, Stage};
use crate::truth::References;
use crate::view::View;
use interreflect_estimators::{Configured, OwnModel, Quantity, Registry};
use interreflect_scene::library::library;
use interreflect_scene::params::{Choice, FIDELITY, Fidelity};
use std::path::PathBuf;

/// How often a run is timed if nothing is said.
const REPEAT: usize = 5;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(command: &Bench, registry: Registry) -> Result<(), HarnessError> {
    let mut bench = Benching::new(command, registry)?;
    let scenes = match command.scenes.is_empty() {
        true => library().iter().map(|s| s.name.to_owned()).collect(),
        false => command.scenes.clone(),
    };
    // Every scene is opened before the first is measured: a misspelt name costs no waiting.
    let gpu = command.backend.list().contains(&Backend::Gpu);
    for scene in &scenes {
        let settings = &command.settings;
        bench.lab.load(scene, &command.scene, settings, false)?;
    }
    for scene in &scenes {
        let settings = &command.settings;
        let loaded = bench.lab.load(scene, &command.scene, settings, gpu)?;
        if let (Some(Err(error)), false) = (&loaded.gpu, bench.warned) {
            eprintln!("warning: no GPU runs: {error}");
            bench.warned = true;
        }
        bench.scene(loaded)?;
    }
    bench.finish()
}

struct Benching<'a> {
    command: &'a Bench,
    lab: Lab,
    methods: Vec<Box<dyn Configured>>,
    quantities: Vec<Quantity>,
    out: Option<PathBuf>,
    runs: Vec<Run>,
    gallery: Gallery,
    warned: bool,
}

impl<'a> Benching<'a> {
    fn new(command: &'a Bench, registry: Registry) -> Result<Self, HarnessError> {
        let lab = Lab::new(registry, &command.run)?;
        let ids: Vec<String> = match command.estimators.is_empty() {
            true => {
                let entries = lab.registry.entries().iter();
                entries.map(|e| e.info().id.to_owned()).collect()
            }
            false => command.estimators.clone(),
        };
        lab.check_owners(&ids, &command.settings)?;
        let mut methods = Vec::new();
        for id in &ids {
            methods.extend(variants(&lab, id, command)?);
        }
        let quantities = match command.quantities.is_empty() {
            true => Quantity::ALL.iter().map(|(_, q)| *q).collect(),
            false => command.quantities.clone(),
        };
        let out = match (&command.out, command.json) {
            (Some(folder), _) => Some(folder.clone()),
            (None, true) => None,
            (None, false) => Some(PathBuf::from(OUT)),
        };
        Ok(Self {
            command,
            lab,
            methods,
            quantities,
            out,
            runs: Vec::new(),
            gallery: Gallery::default(),
            warned: false,
        })
    }

    fn scene(&mut self, loaded: Loaded) -> Result<(), HarnessError> {
        let scene = loaded.cpu.clone();
        let stages = Stages::new(&self.lab, loaded);
        let count = self.command.points.unwrap_or(POINTS);
        let camera = scene.scene().camera;
        let view = self
            .lab
            .cpu
            .install(|| View::of_about(&scene, &camera, count));
        for quantity in self.quantities.clone() {
            let methods: Vec<_> = self
                .methods
                .iter()
                .filter(|m| m.quantities().contains(&quantity))
                .map(|m| m.boxed_clone())
                .collect();
            if methods.is_empty() || self.only_light_transport(&methods, quantity) {
                continue;
            }
            let points = view.points(quantity.layout());
            let name = scene.scene().name.clone();
            let bar = progress::bar("", methods.len() as u64 * 2);
            let stop = stop(&self.command.budget);
            let seed = self.lab.seed;
            let mut references =
                References::new(&self.lab.cpu, &scene, quantity, &points, stop, seed);
            bar.set_message("path tracing");
            self.gallery
                .begin(&name, quantity, &view, references.truth());
            for method in &methods {
                for &backend in self.command.backend.list() {
                    bar.set_message(method.info().id);
                    let repeat = self.command.repeat.unwrap_or(REPEAT);
                    let measured = stages.measure(backend, &**method, quantity, &points, repeat);
                    let mut run = record(&name, &**method, quantity, backend, points.len());
                    match measured {
                        Ok((measured, time_source, software)) => {
                            let model = method.model(quantity);
                            let [own, truth] = references.compare(&measured.estimate, model)?;
                            run.own_model = Some(own);
                            run.truth = Some(truth);
                            run.phases_ms = measured.phases;
                            run.time_source = time_source;
                            run.software = software;
                            self.gallery.add(&run, &view, &measured.estimate);
                        }
                        Err(why) => run.skipped = Some(skip_reason(why)?),
                    }
                    self.runs.push(run);
                    self.save()?;
                    bar.inc(1);
                }
            }
            bar.finish_and_clear();
        }
        Ok(())
    }

    /// Whether only path tracing offers a quantity that nobody asked for by name: the truth would
    /// be compared with itself.
    fn only_light_transport(&self, methods: &[Box<dyn Configured>], quantity: Quantity) -> bool {
        let asked = !self.command.quantities.is_empty() || !self.command.estimators.is_empty();
        let mut models = methods.iter().map(|m| m.model(quantity));
        !asked && models.all(|model| matches!(model, OwnModel::LightTransport(_)))
    }

    fn save(&self) -> Result<(), HarnessError> {
        if let Some(folder) = &self.out {
            write_json(&folder.join("results.json"), &self.results())?;
        }
        Ok(())
    }

    fn results(&self) -> Results {
        Results {
            machine: self.lab.machine(),
            runs: self.runs.clone(),
        }
    }

    fn finish(self) -> Result<(), HarnessError> {
        let results = self.results();
        if let Some(folder) = &self.out {
            self.gallery.write(&folder.join("images"))?;
            let report = Report {
                title: "interreflect bench".into(),
                command: std::env::args().collect::<Vec<_>>().join(" "),
                machine: results.machine.clone(),
                runs: results.runs.clone(),
                rows: self.gallery.into_rows(),
            };
            report.write(&folder.join("report.html"))?;
        }
        if self.command.json {
            return print_json(&results);
        }
        print_line(&crate::table::runs(&results.runs, None))?;
        if let Some(folder) = &self.out {
            print_line(&format!("{}", folder.join("report.html").display()))?;
        }
        Ok(())
    }
}

/// A method once for each of its fidelities, or as it was set on the command line.
fn variants(
    lab: &Lab,
    id: &str,
    command: &Bench,
) -> Result<Vec<Box<dyn Configured>>, HarnessError> {
    let method = lab.configure(id, &command.settings)?;
    let chosen = command.settings.iter().any(|s| s.split().1 == FIDELITY);
    if method.fidelity().is_none() || chosen {
        return Ok(vec![method]);
    }
    let variants = Fidelity::ALL.iter().map(|(name, _)| {
        let mut variant = method.boxed_clone();
        let set = variant.set(FIDELITY, name);
        let error = |error| HarnessError::Param {
            estimator: id.into(),
            error,
        };
        set.map(|()| variant).map_err(error)
    });
    variants.collect()
}

/// A scene on the backends that there are.
struct Stages<'a> {
    cpu: CpuStage<'a>,
    gpu: Result<GpuStage, String>,
}

impl<'a> Stages<'a> {
    fn new(lab: &'a Lab, loaded: Loaded) -> Self {
        let cpu = CpuStage {
            cx: &lab.cpu,
            scene: loaded.cpu,
        };
        let gpu = match loaded.gpu {
            Some(Ok((context, scene))) => Ok(GpuStage { context, scene }),
            Some(Err(error)) => Err(error.to_string()),
            None => Err("the GPU was not asked for".into()),
        };
        Self { cpu, gpu }
    }

    fn measure(
        &self,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &interreflect_scene::Points,
        repeat: usize,
    ) -> Result<(Measured, TimeSource, bool), HarnessError> {
        let scene = self.cpu.scene.scene();
        match backend {
            Backend::Cpu => {
                let measured = measure(&self.cpu, scene, method, quantity, points, repeat)?;
                Ok((measured, TimeSource::WallClock, false))
            }
            Backend::Gpu => {
                let stage = self.gpu.as_ref();
                let stage =
                    stage.map_err(|why| interreflect_estimators::Unsupported(why.clone()))?;
                let measured = measure(stage, scene, method, quantity, points, repeat)?;
                let source = match stage.device_clock() {
                    true => TimeSource::GpuTimestamps,
                    false => TimeSource::WallClock,
                };
                Ok((measured, source, stage.context.info().software))
            }
        }
    }
}

fn record(
    scene: &str,
    method: &dyn Configured,
    quantity: Quantity,
    backend: Backend,
    points: usize,
) -> Run {
    let values = method.values().into_iter();
    Run {
        fidelity: method.fidelity().map(str::to_owned),
        params: values.map(|(field, value)| (field.name, value)).collect(),
        points,
        ..Run::new(scene, method.info().id, backend, quantity.name())
    }
}

/// What can't run is a result; anything else is an error.
fn skip_reason(why: HarnessError) -> Result<String, HarnessError> {
    use interreflect_estimators::EstimatorError;
    match why {
        HarnessError::Unsupported(why)
        | HarnessError::Estimator(EstimatorError::Unsupported(why)) => Ok(why.0),
        other => Err(other),
    }
}
