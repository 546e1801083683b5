//! `bench`: estimators on scenes, timed and compared with what is true.

use super::reference::{POINTS, stop};
use super::{print_json, print_line};
use crate::cli::Bench;
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::lab::{Lab, Loaded};
use crate::output::{Header, Tev, ensure_writable, write_results};
use crate::progress;
use crate::record::{Backend, Comparison, Results, Run};
use crate::report::Report;
use crate::stages::{Stages, Timed};
use crate::truth::References;
use crate::view::View;
use interreflect_estimators::{Configured, EstimatorError, OwnModel, Quantity, Registry};
use interreflect_gpu::GpuError;
use interreflect_scene::library::library;
use interreflect_scene::params::{Choice, FIDELITY};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// How often a run is timed if nothing is said.
const REPEAT: usize = 5;

/// Folder for results if nothing is said.
const OUT: &str = "results";

pub(super) fn run(
    command: &Bench,
    registry: Registry,
    command_line: &str,
) -> Result<(), HarnessError> {
    let mut bench = Benching::new(command, registry, command_line)?;
    let scenes = match command.scenes.is_empty() {
        true => {
            let benched = library().iter().filter(|s| s.benched);
            benched.map(|s| s.name.to_owned()).collect()
        }
        false => command.scenes.clone(),
    };
    // Everything that can be wrong is found before the first scene is measured.
    let mut names = BTreeSet::new();
    for source in &scenes {
        let scene = bench.lab.scene(source, &command.scene, &command.settings)?;
        if !names.insert(scene.name.clone()) {
            return Err(HarnessError::Usage(format!(
                "{source}: a scene named `{}` is there already; give each another name",
                scene.name
            )));
        }
    }
    let gpu = command.backend.list().contains(&Backend::Gpu);
    if gpu {
        bench.check_gpu()?;
    }
    let tev = command.tev.connect()?;
    if let Some(folder) = &bench.out {
        ensure_writable(folder)?;
        // By now the adapter is open, which the machine's description names.
        let header = Header::of_program(command_line, &bench.lab.machine(), bench.lab.seed);
        bench.gallery = Gallery::new(folder, header);
    }
    for source in &scenes {
        let settings = &command.settings;
        let loaded = bench.lab.load(source, &command.scene, settings, gpu)?;
        bench.scene(loaded)?;
    }
    bench.finish(tev)
}

struct Benching<'a> {
    command: &'a Bench,
    command_line: &'a str,
    lab: Lab,
    methods: Vec<Box<dyn Configured>>,
    quantities: Vec<Quantity>,
    out: Option<PathBuf>,
    runs: Vec<Run>,
    gallery: Gallery,
    failures: Vec<String>,
}

impl<'a> Benching<'a> {
    fn new(
        command: &'a Bench,
        registry: Registry,
        command_line: &'a str,
    ) -> Result<Self, HarnessError> {
        let lab = Lab::new(registry, &command.run)?;
        let mut ids: Vec<String> = match command.estimators.is_empty() {
            true => {
                let entries = lab.registry.entries().iter();
                entries.map(|e| e.info().id.to_owned()).collect()
            }
            false => command.estimators.clone(),
        };
        keep_first_of_each(&mut ids);
        lab.check_owners(&ids, &command.settings)?;
        let mut methods = Vec::new();
        for id in &ids {
            methods.extend(variants(&lab, id, command)?);
        }
        let mut quantities = match command.quantities.is_empty() {
            true => Quantity::ALL.iter().map(|(_, q)| *q).collect(),
            false => command.quantities.clone(),
        };
        keep_first_of_each(&mut quantities);
        let offered = |q: &Quantity| methods.iter().any(|m| m.quantities().contains(q));
        if !quantities.iter().any(offered) {
            let names: Vec<_> = quantities.iter().map(|q| q.name()).collect();
            return Err(HarnessError::Usage(format!(
                "none of the estimators {} offers {}",
                ids.join(", "),
                names.join(" or ")
            )));
        }
        let out = match (&command.out, command.json) {
            (Some(folder), _) => Some(folder.clone()),
            (None, true) => None,
            (None, false) => Some(PathBuf::from(OUT)),
        };
        Ok(Self {
            command,
            command_line,
            lab,
            methods,
            quantities,
            out,
            runs: Vec::new(),
            gallery: Gallery::default(),
            failures: Vec::new(),
        })
    }

    fn scene(&mut self, loaded: Loaded) -> Result<(), HarnessError> {
        let scene = loaded.cpu.clone();
        let stages = Stages::new(&self.lab.cpu, loaded);
        let count = self.command.points.unwrap_or(POINTS);
        let camera = scene.scene().camera;
        let view = self
            .lab
            .cpu
            .install(|| View::of_about(&scene, &camera, count))?;
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
            let backends = self.command.backend.list();
            let bar = progress::bar("", (methods.len() * backends.len()) as u64);
            let stop = stop(&self.command.budget);
            let seed = self.lab.seed;
            let mut references =
                References::new(&self.lab.cpu, &scene, quantity, &points, stop, seed);
            bar.set_message("path tracing");
            self.gallery
                .begin(&name, quantity, &view, references.truth())?;
            for method in &methods {
                for &backend in backends {
                    bar.set_message(method.info().id);
                    let repeat = self.command.repeat.unwrap_or(REPEAT);
                    let on_backend = stages.measure(backend, &**method, quantity, &points, repeat);
                    let mut run = record(&name, &**method, quantity, backend, points.len());
                    match on_backend {
                        Ok(Timed {
                            measured,
                            time_source,
                            software,
                        }) => {
                            let model = method.model(quantity);
                            let [own, truth] = references.compare(&measured.estimate, model);
                            (run.own_model, run.own_model_missing) = either(own);
                            (run.truth, run.truth_missing) = either(truth);
                            run.phases_ms = measured.phases;
                            run.time_source = time_source;
                            run.software = software;
                            let index = self.runs.len();
                            self.gallery
                                .add(index, &mut run, &view, &measured.estimate)?;
                        }
                        Err(why) => {
                            let (reason, failed) = skip_reason(why);
                            if failed {
                                let label = format!("{} on {backend} in {name}", run.label());
                                self.failures.push(format!("{label}: {reason}"));
                            }
                            run.skipped = Some(reason);
                        }
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
            write_results(folder, &self.results())?;
        }
        Ok(())
    }

    fn results(&self) -> Results {
        Results {
            machine: self.lab.machine(),
            command: self.command_line.to_owned(),
            seed: Some(self.lab.seed),
            runs: self.runs.clone(),
        }
    }

    fn finish(mut self, mut tev: Option<Tev>) -> Result<(), HarnessError> {
        let results = self.results();
        if let Some(folder) = &self.out {
            let rows = std::mem::take(&mut self.gallery).finish(&results.runs)?;
            let report = Report::new(&results, rows);
            report.write(&folder.join("report.html"))?;
            if let Some(tev) = &mut tev {
                report.show_in(tev)?;
            }
        }
        if self.command.json {
            print_json(&results)?;
        } else {
            print_line(&crate::table::runs(&results.runs, None))?;
            if let Some(folder) = &self.out {
                print_line(&format!("{}", folder.join("report.html").display()))?;
            }
        }
        match self.failures.first() {
            None => Ok(()),
            Some(first) => Err(HarnessError::Failed {
                failed: self.failures.len(),
                runs: results.runs.len(),
                first: first.clone(),
            }),
        }
    }

    /// A GPU that was asked for by name, or alone, has to be there; else its runs are skipped.
    fn check_gpu(&self) -> Result<(), HarnessError> {
        let Err(error) = self.lab.gpu() else {
            return Ok(());
        };
        let alone = self.command.backend.list() == [Backend::Gpu];
        if alone || matches!(error, GpuError::UnknownAdapter { .. }) {
            return Err(error.into());
        }
        eprintln!("warning: no GPU runs: {error}");
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
    let chosen = command.settings.iter().any(|s| {
        let (owner, name) = s.split();
        name == FIDELITY && owner.is_none_or(|owner| owner == id)
    });
    if chosen {
        return Ok(vec![method]);
    }
    Ok(method.in_each_fidelity())
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

/// Why a run did not take place, and whether that is a failure: that a method can't run so is a
/// result.
fn skip_reason(why: HarnessError) -> (String, bool) {
    match why {
        HarnessError::Unsupported(why)
        | HarnessError::Estimator(EstimatorError::Unsupported(why)) => (why.0, false),
        failure => (failure.to_string(), true),
    }
}

/// A comparison, or why there is none.
fn either(result: Result<Comparison, HarnessError>) -> (Option<Comparison>, Option<String>) {
    match result {
        Ok(comparison) => (Some(comparison), None),
        Err(why) => (None, Some(why.to_string())),
    }
}

fn keep_first_of_each<T: Clone + PartialEq>(list: &mut Vec<T>) {
    let mut kept: Vec<T> = Vec::new();
    list.retain(|item| {
        let new = !kept.contains(item);
        kept.push(item.clone());
        new
    });
}
