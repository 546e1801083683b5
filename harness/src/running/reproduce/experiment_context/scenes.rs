//! Scenes of experiments, and what their cameras see.

use super::super::assets::{Assets, Model};
use super::super::experiment_scene::ExperimentScene;
use super::super::finding::Finding;
use super::super::scene_setup::SceneSetup;
use super::ExperimentContext;
use crate::running::context::GpuUse;
use crate::running::error::RunError;
use crate::running::view::{Look, Shade, View};
use interreflect_estimators::execution::LoadedScene;
use interreflect_scene::library::RECEIVERS;
use interreflect_scene::{Camera, Role, Scene};

/// Share of a mesh's area turned inside out above which it is remarked.
const FOLDED: f64 = 1e-3;

impl ExperimentContext<'_> {
    /// A model, or what takes its place.
    pub(in super::super) fn mesh(&self, name: &str) -> Model {
        self.assets.mesh(name)
    }

    /// The models and maps.
    pub(in super::super) fn assets(&self) -> &Assets {
        &self.assets
    }

    /// A setup's scene: models and environment as they are found, and notes of what takes the place of those that
    /// are not.
    pub(in super::super) fn place(&self, setup: &SceneSetup) -> ExperimentScene {
        let mut place = ExperimentScene::of(setup.source);
        for &model in setup.models {
            place = match RECEIVERS.contains(&model) {
                true => place.with_shape(model),
                false => place.with(&self.mesh(model)),
            };
        }
        if let Some(name) = setup.environment {
            let environment = self.assets.environment(name);
            if environment.is_none() {
                place.notes.push(format!(
                    "{name} not found: the scene's own environment in its place; `make assets` brings it"
                ));
            }
            place = place.under(environment);
        }
        let settings = setup.settings.iter();
        settings.fold(place, |place, (name, value)| place.set(name, value))
    }

    /// Opens a scene; what takes something's place in it is noted, and what is wrong with a mesh.
    pub(in super::super) fn scene(
        &self,
        place: &ExperimentScene,
        finding: &mut Finding,
    ) -> Result<Scene, RunError> {
        for note in &place.notes {
            finding.note(note.as_str());
        }
        let scene = self
            .context
            .scene(&place.source, &place.changes, &place.settings)?;
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
    pub(in super::super) fn set_up(&self, scene: &Scene) -> Result<LoadedScene, RunError> {
        let gpu = GpuUse::where_listed(&self.backends);
        self.context.set_up(&self.context.cpu, scene, gpu)
    }

    /// Opens a scene and sets it up.
    pub(in super::super) fn load(
        &self,
        place: &ExperimentScene,
        finding: &mut Finding,
    ) -> Result<LoadedScene, RunError> {
        self.set_up(&self.scene(place, finding)?)
    }

    /// What a scene's camera sees, cropped to about as many shaded points as a picture has.
    pub(in super::super) fn view(&self, loaded: &LoadedScene) -> Result<View, RunError> {
        self.view_of(loaded, (self.points(), Shade::default()))
    }

    /// As [`Self::view`], of about as many points as said, on these surfaces.
    pub(in super::super) fn view_of(
        &self,
        loaded: &LoadedScene,
        points: (usize, Shade),
    ) -> Result<View, RunError> {
        let scene = &*loaded.cpu().scene;
        let camera = scene.scene().camera;
        self.context
            .cpu
            .install(|| View::of_about(scene, &camera, points))
    }

    /// What a scene's camera sees, `width` pixels wide.
    pub(in super::super) fn whole_view(
        &self,
        loaded: &LoadedScene,
        width: u32,
        look: Look,
    ) -> Result<View, RunError> {
        let scene = &*loaded.cpu().scene;
        let camera = scene.scene().camera;
        let [w, h] = camera.resolution;
        let camera = Camera {
            resolution: [width, (width * h).div_ceil(w)],
            ..camera
        };
        self.context.cpu.install(|| View::new(scene, &camera, look))
    }
}
