//! What `bench` and `sweep` do: every task of a plan, each kept as soon as it is done.
//!
//! Longer than most: from a plan to its results is one way, and what it holds is what every step needs.

mod axis;
mod error_breakdown;
mod journal;
mod observer;
mod plan;
mod results;
mod run_settings;
mod scene_quantity;
mod shard;
mod tasks;

pub use axis::Axis;
pub use shard::Shard;

pub(crate) use journal::{Done, Entry, Journal};
pub(crate) use observer::{Images, Observer};
pub(crate) use plan::{Plan, Selection, Setup};

use super::clock::{Sampling, Throttle};
use super::context::{Context, GpuUse, remarkable};
use super::error::RunError;
use super::settings::ReferenceBudget;
use super::truth::{Cache, References};
use super::view::View;
use crate::domain::record::{Invocation, Results};
use interreflect_cpu::path_tracer::Stop;
use interreflect_cpu::tiles::CpuCx;
use interreflect_estimators::Quantity;
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::digest;
use scene_quantity::SceneQuantity;
use std::path::PathBuf;
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
    pub(crate) command: &'a str,
    /// The same, taken apart.
    pub(crate) invocation: Option<&'a Invocation>,
}

/// A plan on its way.
pub(crate) struct Campaign<'a> {
    pub(crate) context: &'a Context,
    pub(crate) plan: &'a Plan,
    pub(crate) settings: Settings<'a>,
    images: &'a dyn Images,
    pub(crate) journal: Journal,
    /// What failed, in words.
    pub(crate) failures: Vec<String>,
    throttle: Throttle,
    /// Number of the next task.
    next: usize,
}

/// How many times fewer samples light paths between the truth and a model get than the truth.
const BETWEEN: u32 = 4;

/// A task to do, with its number and its key.
struct KeyedTask {
    task: Task,
    at: usize,
    key: String,
}

/// A scene of the plan on the backends, with its points, for all quantities.
struct OpenedSetup<'a> {
    setup: &'a Setup,
    /// The scene's digest.
    hash: &'a str,
    cx: &'a CpuCx,
    loaded: LoadedScene,
    view: View,
}

impl<'a> Campaign<'a> {
    pub(crate) fn new(
        context: &'a Context,
        plan: &'a Plan,
        settings: Settings<'a>,
        images: &'a dyn Images,
        journal: Journal,
    ) -> Self {
        Self {
            context,
            plan,
            settings,
            images,
            journal,
            failures: Vec::new(),
            throttle: Throttle::new(),
            next: 0,
        }
    }

    /// Does everything that is not done yet; `observer` hears of it.
    ///
    /// # Errors
    /// [`RunError`] if a scene can't be used or a file not be written. What fails of a method is kept
    /// in `failures`.
    pub(crate) fn run(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        self.journal.on(self.context.machine())?;
        let plan = self.plan;
        let mut cx = self.context.cpu.clone();
        for setup in &plan.setups {
            let threads = match setup.run.threads {
                0 => self.context.cpu.threads(),
                threads => threads as usize,
            };
            if threads != cx.threads() {
                cx = self.context.cpu_on(threads)?;
            }
            let hash = setup.scene.digest();
            let mut opened = None;
            for &quantity in &plan.quantities {
                let todo = self.todo(setup, &hash, quantity)?;
                if todo.is_empty() {
                    continue;
                }
                let opened = match &opened {
                    Some(opened) => opened,
                    None => opened.insert(self.open(setup, &hash, &cx, observer)?),
                };
                self.scene_quantity(opened, quantity, todo, observer)?;
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
    ) -> Result<Vec<KeyedTask>, RunError> {
        let tasks = Task::all(self.context, self.plan, quantity, self.settings.concluding)?;
        let budget = self.settings.budget;
        let mut todo = Vec::new();
        for task in tasks {
            let at = self.next;
            self.next += 1;
            let of_task = task.digest(quantity);
            let run = &setup.run;
            let key = digest(&(
                &self.settings.program,
                hash,
                run,
                budget,
                self.context.seed,
                of_task,
            ));
            if self.settings.shard.has(at) && !self.journal.has(&key, at) {
                todo.push(KeyedTask { task, at, key });
            }
        }
        Ok(todo)
    }

    fn open<'c>(
        &self,
        setup: &'c Setup,
        hash: &'c str,
        cx: &'c CpuCx,
        observer: &mut dyn Observer,
    ) -> Result<OpenedSetup<'c>, RunError> {
        let gpu = GpuUse::where_listed(self.plan.backends);
        let loaded = self.context.set_up(cx, &setup.scene, gpu)?;
        if let Some(warning) = remarkable(&setup.scene) {
            observer.warn(&warning);
        }
        let camera = setup.scene.camera;
        let shaded = (setup.run.points as usize, setup.run.shade);
        let host = &loaded.cpu().scene;
        let view = cx.install(|| View::of_about(host, &camera, shaded))?;
        Ok(OpenedSetup {
            setup,
            hash,
            cx,
            loaded,
            view,
        })
    }

    /// Does tasks of one quantity of a scene.
    fn scene_quantity(
        &mut self,
        opened: &OpenedSetup<'_>,
        quantity: Quantity,
        todo: Vec<KeyedTask>,
        observer: &mut dyn Observer,
    ) -> Result<(), RunError> {
        let OpenedSetup {
            setup,
            hash,
            cx,
            loaded,
            view,
        } = opened;
        let scene = &loaded.cpu().scene;
        observer.begin(&setup.name, quantity, todo.len());
        let points = view.points(quantity.layout());
        let cache = self.settings.references.as_ref().map(|folder| {
            let of = digest(&(
                &self.settings.program,
                hash,
                setup.run.points,
                setup.run.shade,
            ));
            Cache::new(folder.clone(), of)
        });
        let stop = self.settings.budget.stop();
        let seed = self.context.seed;
        let references = |stop| {
            let references = References::new(cx, scene, quantity, &points, stop, seed);
            references.cached(cache.clone())
        };
        let fewer = Stop {
            samples: stop.samples.map(|samples| samples.div_ceil(BETWEEN)),
            ..stop
        };
        let mut here = SceneQuantity {
            name: setup.name.clone(),
            digest: (*hash).into(),
            setup,
            quantity,
            cx,
            loaded,
            view,
            points: points.clone(),
            references: references(stop),
            between: references(fewer),
            sampling: self.settings.sampling,
            machine: self.context.machine().id(),
            last: None,
        };
        self.images
            .truth(&setup.name, quantity, view, here.references.truth())?;
        for KeyedTask { task, at, key } in todo {
            observer.task(task.label());
            let suffix = self.suffix(&task, &key);
            let (backends, throttle) = (self.plan.backends, &mut self.throttle);
            let outcome = here.perform(&task, backends, throttle, self.images, &suffix)?;
            if let Some(warning) = outcome.done.warning() {
                observer.warn(&warning);
            }
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
            observer.done(self)?;
        }
        observer.end();
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
            machine: self.context.machine(),
            command: self.settings.command.into(),
            invocation: self.settings.invocation.cloned(),
            seed: Some(self.context.seed),
            ..Results::default()
        };
        results.take(self.journal.done());
        results.of_machines(self.journal.machines());
        results
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
