//! What experiments work with: scenes on the backends, methods, and measurements.

use super::assets::{Assets, Model};
use super::finding::Finding;
use super::place::{Place, setting};
use super::shot::Shot;
use crate::clock::Sampling;
use crate::error::HarnessError;
use crate::frames::{Frame, Shaded};
use crate::lab::{GpuUse, Lab};
use crate::record::{Backend, Phases, Run, TimeSource};
use crate::stages::{Sequence, measure_on, next_frame};
use crate::truth::References;
use crate::view::{Look, View};
use interreflect_cpu::path_tracer::Stop;
use interreflect_estimators::execution::LoadedScene;
use interreflect_estimators::{Configured, Quantity, VisibleTriangles};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Camera, Points, Role, Scene};

/// Share of a mesh's area turned inside out above which it is remarked.
const FOLDED: f64 = 1e-3;

/// Methods, backends and models, and how much effort is made.
pub struct Desk<'a> {
    lab: &'a Lab,
    backends: Vec<Backend>,
    assets: Assets,
    quick: bool,
}

impl<'a> Desk<'a> {
    /// A desk for those of the backends that there are; `quick` takes fewer points, samples and cases.
    pub fn new(lab: &'a Lab, backends: Vec<Backend>, assets: Assets, quick: bool) -> Self {
        Self {
            lab,
            backends,
            assets,
            quick,
        }
    }

    /// The backends that there are.
    pub(super) fn backends(&self) -> Vec<Backend> {
        self.backends.clone()
    }

    /// The one of two that the effort calls for.
    pub(super) fn pick<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Points of a picture.
    pub(super) fn points(&self) -> usize {
        self.pick(8_000, 16_000)
    }

    /// When references are good enough.
    pub(super) fn stop(&self) -> Stop {
        Stop {
            samples: Some(self.pick(64, 256)),
            ..Stop::default()
        }
    }

    /// A model, or what takes its place.
    pub(super) fn mesh(&self, name: &str) -> Model {
        self.assets.mesh(name)
    }

    /// The models and maps.
    pub(super) fn assets(&self) -> &Assets {
        &self.assets
    }

    /// Opens a scene; what takes something's place in it is noted, and what is wrong with a mesh.
    pub(super) fn scene(
        &self,
        place: &Place,
        finding: &mut Finding,
    ) -> Result<Scene, HarnessError> {
        for note in &place.notes {
            finding.note(note.as_str());
        }
        let scene = self
            .lab
            .scene(&place.source, &place.options, &place.settings)?;
        for object in scene.objects_of(Role::Receiver) {
            let folded = object.mesh.folded_share();
            if folded > FOLDED {
                finding.note(format!(
                    "{}: {:.1} % of its area is in triangles that are turned inside out, and seen as \
                     dark dots",
                    object.name,
                    100.0 * folded
                ));
            }
        }
        Ok(scene)
    }

    /// Sets a scene up on the backends.
    pub(super) fn set_up(&self, scene: &Scene) -> Result<LoadedScene, HarnessError> {
        self.lab.set_up(scene, GpuUse::where_listed(&self.backends))
    }

    /// Opens a scene and sets it up.
    pub(super) fn room(
        &self,
        place: &Place,
        finding: &mut Finding,
    ) -> Result<LoadedScene, HarnessError> {
        self.set_up(&self.scene(place, finding)?)
    }

    /// What a room's camera sees, cropped to about as many shaded points as a picture has.
    pub(super) fn view(&self, room: &LoadedScene) -> Result<View, HarnessError> {
        self.view_of(room, self.points())
    }

    /// As [`Self::view`], of about as many points as said.
    pub(super) fn view_of(&self, room: &LoadedScene, count: usize) -> Result<View, HarnessError> {
        let scene = &*room.cpu().scene;
        let camera = scene.scene().camera;
        self.lab
            .cpu
            .install(|| View::of_about(scene, &camera, count))
    }

    /// What a room's camera sees, `width` pixels wide.
    pub(super) fn whole_view(
        &self,
        room: &LoadedScene,
        width: u32,
        look: Look,
    ) -> Result<View, HarnessError> {
        let scene = &*room.cpu().scene;
        let camera = scene.scene().camera;
        let [w, h] = camera.resolution;
        let camera = Camera {
            resolution: [width, (width * h).div_ceil(w)],
            ..camera
        };
        self.lab.cpu.install(|| View::with(scene, &camera, look))
    }

    /// A method with parameters.
    pub(super) fn method(
        &self,
        id: &str,
        parameters: &[(&str, &dyn ToString)],
    ) -> Result<Box<dyn Configured>, HarnessError> {
        let settings = parameters
            .iter()
            .map(|(name, value)| setting(name, value.to_string()));
        self.lab.configure(id, &settings.collect::<Vec<_>>())
    }

    /// The references of a quantity at points, none of them computed yet.
    pub(super) fn references<'b>(
        &'b self,
        room: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        self.references_to(self.stop(), room, quantity, points)
    }

    /// As [`Self::references`], with eight times as many samples: for what is cheap to trace and judged by
    /// more than a mean.
    pub(super) fn precise<'b>(
        &'b self,
        room: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        let stop = Stop {
            samples: self.stop().samples.map(|n| 8 * n),
            ..Stop::default()
        };
        self.references_to(stop, room, quantity, points)
    }

    fn references_to<'b>(
        &'b self,
        stop: Stop,
        room: &'b LoadedScene,
        quantity: Quantity,
        points: &'b Points,
    ) -> References<'b> {
        let (cx, seed) = (&self.lab.cpu, self.lab.seed);
        References::new(cx, &room.cpu().scene, quantity, points, stop, seed)
    }

    /// Runs a method for its estimate alone: its record has no times.
    pub(super) fn shot(
        &self,
        room: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
    ) -> Result<Shot, HarnessError> {
        let mut shot = self.measured(room, backend, method, (quantity, points), &Sampling::ONCE)?;
        shot.run.phases_ms = Phases::default();
        Ok(shot)
    }

    /// Runs and times a method.
    pub(super) fn timed_shot(
        &self,
        room: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        quantity: Quantity,
        points: &Points,
    ) -> Result<Shot, HarnessError> {
        let usual = Sampling::default();
        let sampling = Sampling {
            most: self.pick(8, usual.most),
            patience_ms: self.pick(usual.patience_ms, 5.0 * usual.patience_ms),
            ..usual
        };
        self.measured(room, backend, method, (quantity, points), &sampling)
    }

    /// The only place that measures.
    fn measured(
        &self,
        room: &LoadedScene,
        backend: Backend,
        method: &dyn Configured,
        (quantity, points): (Quantity, &Points),
        sampling: &Sampling,
    ) -> Result<Shot, HarnessError> {
        let timed = measure_on(room, backend, method, quantity, points, sampling)?;
        let values = method.values().into_iter();
        let run = Run {
            fidelity: method.fidelity().map(str::to_owned),
            params: values.map(|(field, value)| (field.name, value)).collect(),
            points: points.len(),
            phases_ms: timed.measured.phases,
            time_source: (timed.measured.phases.shade).map_or(TimeSource::WallClock, |t| t.source),
            bytes: Some(timed.measured.bytes),
            software: timed.software,
            truth_missing: Some("compared by the experiment".into()),
            own_model_missing: Some("compared by the experiment".into()),
            ..Run::new(
                room.scene().name.clone(),
                method.info().id,
                backend,
                quantity.name(),
            )
        };
        Ok(Shot {
            estimate: timed.measured.estimate,
            run,
        })
    }

    /// Runs the next frame of a sequence.
    pub(super) fn frame(
        &self,
        room: &LoadedScene,
        (running, backend): (&mut Sequence, Backend),
        method: &dyn Configured,
        quantity: Quantity,
        (points, seen, moves): (&Points, Option<VisibleTriangles<'_>>, Moves),
    ) -> Result<Shaded, HarnessError> {
        let scene = room.scene();
        let frame = Frame {
            scene,
            moves,
            points,
            visible: seen,
        };
        next_frame(room, backend, running, method, quantity, &frame)
    }

    /// Whether times of a backend are a software adapter's.
    pub(super) fn software(&self, backend: Backend) -> bool {
        backend == Backend::Gpu && self.lab.machine().software == Some(true)
    }
}
