//! What `bench` and `sweep` do: every task of a plan, each kept as soon as it is done.
//!
//! Longer than most: from a plan to its results is one way, and what it holds is what every step needs.

mod axis;
mod cell;
mod journal;
mod plan;
mod results;
mod run_settings;
mod shard;
mod split;
mod tasks;

pub use axis::Axis;
pub use journal::JournalError;
pub use shard::Shard;

pub(crate) use journal::{Done, Entry, Journal};
pub(crate) use plan::{Plan, Setup};

use crate::cli::ReferenceBudget;
use crate::clock::{Pulse, Sampling};
use crate::commands::reference_stop;
use crate::error::HarnessError;
use crate::gallery::Gallery;
use crate::lab::Lab;
use crate::progress;
use crate::record::{Backend, Results, Run};
use crate::stages::Stages;
use crate::truth::{Cache, References};
use crate::view::View;
use cell::Cell;
use interreflect_cpu::path_tracer::Stop;
use interreflect_cpu::scene::CpuScene;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::Quantity;
use interreflect_scene::digest;
use std::path::PathBuf;
use std::sync::Arc;
use tasks::Task;

/// How a campaign is carried out.
pub(crate) struct Settings<'a> {
    pub(crate) sampling: Sampling,
    pub(crate) budget: ReferenceBudget,
    /// Folder of references that are kept.
    pub(crate) references: Option<PathBuf>,
    pub(crate) shard: Shard,
    pub(crate) axes: &'a [Axis],
    /// What conclusions need is measured too: baselines, floors, splits.
    pub(crate) concluding: bool,
    /// Digest of what results depend on beside the plan: the program.
    pub(crate) program: String,
    /// The command that it came from.
    pub(crate) command_line: &'a str,
}

/// A plan on its way.
pub(crate) struct Campaign<'a> {
    pub(crate) lab: &'a Lab,
    pub(crate) plan: &'a Plan,
    pub(crate) settings: Settings<'a>,
    pub(crate) gallery: Gallery,
    pub(crate) journal: Journal,
    /// What failed, in words.
    pub(crate) failures: Vec<String>,
    pulse: Pulse,
    /// Number of the next task.
    next: usize,
}

/// How many times fewer samples light paths between the truth and a model get than the truth.
const BETWEEN: u32 = 4;

/// A task to do, with its number and its key.
struct Todo {
    task: Task,
    at: usize,
    key: String,
}

/// A scene of the plan on the backends, with its points, for all quantities.
struct Opened<'a> {
    setup: &'a Setup,
    /// The scene's digest.
    hash: &'a str,
    cx: &'a CpuCx,
    scene: Arc<CpuScene>,
    stages: Stages<'a>,
    view: View,
}

impl<'a> Campaign<'a> {
    pub(crate) fn new(
        lab: &'a Lab,
        plan: &'a Plan,
        settings: Settings<'a>,
        gallery: Gallery,
        journal: Journal,
    ) -> Self {
        Self {
            lab,
            plan,
            settings,
            gallery,
            journal,
            failures: Vec::new(),
            pulse: Pulse::new(),
            next: 0,
        }
    }

    /// Does everything that is not done yet; `each` is called whenever something new is.
    ///
    /// # Errors
    /// [`HarnessError`] if a scene can't be used or a file not be written. What fails of a method is kept
    /// in `failures`.
    pub(crate) fn run(
        &mut self,
        mut each: impl FnMut(&Self) -> Result<(), HarnessError>,
    ) -> Result<(), HarnessError> {
        self.journal.on(self.lab.machine())?;
        let plan = self.plan;
        let mut cx = self.lab.cpu.clone();
        for setup in &plan.setups {
            let threads = match setup.run.threads {
                0 => self.lab.cpu.threads(),
                threads => threads as usize,
            };
            if threads != cx.threads() {
                cx = self.lab.cpu_on(threads)?;
            }
            let scene = self
                .lab
                .scene(&setup.source, &plan.scene_options, &setup.settings)?;
            let hash = scene.digest();
            let mut opened = None;
            for &quantity in &plan.quantities {
                let todo = self.todo(setup, &hash, quantity)?;
                if todo.is_empty() {
                    continue;
                }
                let opened = match &opened {
                    Some(opened) => opened,
                    None => opened.insert(self.open(setup, &hash, &cx)?),
                };
                self.cell(opened, quantity, todo, &mut each)?;
            }
        }
        Ok(())
    }

    /// The tasks of a cell that belong to this part and are not done.
    fn todo(
        &mut self,
        setup: &Setup,
        hash: &str,
        quantity: Quantity,
    ) -> Result<Vec<Todo>, HarnessError> {
        let tasks = Task::all(self.lab, self.plan, quantity, self.settings.concluding)?;
        let budget = self.settings.budget;
        let mut todo = Vec::new();
        for task in tasks {
            let at = self.next;
            self.next += 1;
            let of_task = task.digest(quantity);
            let run = (setup.run.points, setup.run.threads);
            let key = digest(&(
                &self.settings.program,
                hash,
                run,
                budget,
                self.lab.seed,
                of_task,
            ));
            if self.settings.shard.has(at) && !self.journal.has(&key, at) {
                todo.push(Todo { task, at, key });
            }
        }
        Ok(todo)
    }

    fn open<'c>(
        &self,
        setup: &'c Setup,
        hash: &'c str,
        cx: &'c CpuCx,
    ) -> Result<Opened<'c>, HarnessError> {
        let gpu = self.plan.backends.contains(&Backend::Gpu);
        let options = &self.plan.scene_options;
        let loaded = self
            .lab
            .load(&setup.source, options, &setup.settings, gpu)?;
        let camera = loaded.cpu.scene().camera;
        let count = setup.run.points as usize;
        let view = cx.install(|| View::of_about(&loaded.cpu, &camera, count))?;
        Ok(Opened {
            setup,
            hash,
            cx,
            scene: loaded.cpu.clone(),
            stages: Stages::new(cx, loaded),
            view,
        })
    }

    /// Does tasks of one quantity of a scene.
    fn cell(
        &mut self,
        opened: &Opened<'_>,
        quantity: Quantity,
        todo: Vec<Todo>,
        each: &mut impl FnMut(&Self) -> Result<(), HarnessError>,
    ) -> Result<(), HarnessError> {
        let Opened {
            setup,
            hash,
            cx,
            scene,
            stages,
            view,
        } = opened;
        progress::begin(format_args!(
            "{}, {}: {} tasks",
            setup.name,
            quantity.name(),
            todo.len()
        ));
        let bar = progress::bar("path tracing", todo.len() as u64);
        let points = view.points(quantity.layout());
        let cache = self.settings.references.as_ref().map(|folder| {
            let of = digest(&(&self.settings.program, hash, setup.run.points));
            Cache::new(folder.clone(), of)
        });
        let stop = reference_stop(&self.settings.budget);
        let seed = self.lab.seed;
        let references = |stop| {
            let references = References::new(cx, scene, quantity, &points, stop, seed);
            references.cached(cache.clone())
        };
        let fewer = Stop {
            samples: stop.samples.map(|samples| samples.div_ceil(BETWEEN)),
            ..stop
        };
        let mut cell = Cell {
            name: setup.name.clone(),
            digest: (*hash).into(),
            setup,
            quantity,
            cx,
            scene: scene.clone(),
            stages,
            view,
            points: points.clone(),
            references: references(stop),
            between: references(fewer),
            sampling: self.settings.sampling,
            machine: self.lab.machine().id(),
        };
        self.gallery
            .begin(&setup.name, quantity, view, cell.references.truth())?;
        for Todo { task, at, key } in todo {
            bar.set_message(task.label());
            let suffix = self.suffix(&task, &key);
            let (backends, pulse) = (self.plan.backends, &mut self.pulse);
            let outcome = cell.perform(&task, backends, pulse, &self.gallery, &suffix)?;
            let entry = Entry {
                key,
                at,
                done: outcome.done,
            };
            match outcome.failure {
                None => self.journal.keep(entry)?,
                Some(failure) => {
                    self.failures.push(failure);
                    self.journal.remember(entry);
                }
            }
            each(self)?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(())
    }

    /// What tells an image's file from others of its method: nothing, where a method runs once.
    fn suffix(&self, task: &Task, key: &str) -> String {
        let Task::Run(method, _) = task else {
            return String::new();
        };
        let own = |axis: &&Axis| axis.owner == method.info().id;
        let values = method.values();
        let value = |axis: &Axis| {
            let found = values.iter().find(|(field, _)| field.name == axis.name);
            found.map(|(field, value)| format!("-{}={value}", field.name))
        };
        let varied: String = self
            .settings
            .axes
            .iter()
            .filter(own)
            .filter_map(value)
            .collect();
        match self.settings.axes.is_empty() {
            true => varied,
            // A folder may hold what other sweeps left.
            false => format!("{varied}-{}", &key[..6]),
        }
    }

    /// What there is so far.
    pub(crate) fn results(&self) -> Results {
        let mut results = Results {
            machine: self.lab.machine(),
            command: self.settings.command_line.into(),
            seed: Some(self.lab.seed),
            ..Results::default()
        };
        results.take(self.journal.done());
        results.of_machines(self.journal.machines());
        results
    }

    /// The error that tells of what failed, if anything did.
    pub(crate) fn failed(&self, runs: &[Run]) -> Result<(), HarnessError> {
        match self.failures.first() {
            None => Ok(()),
            Some(first) => Err(HarnessError::Failed {
                failed: self.failures.len(),
                runs: runs.len(),
                first: first.clone(),
            }),
        }
    }
}

/// Digest of the program that runs: another build may give other results.
pub(crate) fn program() -> String {
    let executable = std::env::current_exe().and_then(std::fs::read);
    executable.map_or_else(
        |why| why.to_string(),
        |bytes| interreflect_scene::digest_of_bytes(&bytes),
    )
}
