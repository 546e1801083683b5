//! One method over the frames of a sequence: a session that lives on while the scene moves.

use crate::domain::metrics::check_finite;
use crate::running::error::RunError;
use glam::Quat;
use interreflect_estimators::execution::{BackendScene, Executor, Suspended};
use interreflect_estimators::{Backend, Changed, Configured, Quantity, VisibleTriangles};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Estimate, Points, Scene};

/// A session, which lives on from frame to frame, and its last frame; neither before the first.
pub struct Frames<B: Backend>(Option<Last<B>>);

struct Last<B: Backend> {
    /// With captures that are good as long as the scene stays as it is.
    session: Suspended<B>,
    points: Points,
    ms: f64,
}

impl<B: Backend> Default for Frames<B> {
    fn default() -> Self {
        Self(None)
    }
}

/// What a frame shows.
pub struct Frame<'a> {
    /// The scene at the frame's time.
    pub scene: &'a Scene,
    /// What can change in it from frame to frame.
    pub moves: Moves,
    /// The points.
    pub points: &'a Points,
    /// What the camera sees of them, where they are vertices.
    pub visible: Option<VisibleTriangles<'a>>,
}

impl Frame<'_> {
    /// How surfaces and points are turned where they are one rigid body: the scene's only object,
    /// moved rigidly and shaded at its vertices, which it takes along.
    fn rigid_rotation(&self) -> Option<Quat> {
        self.scene
            .rigid_rotation()
            .filter(|_| self.visible.is_some())
    }
}

/// A frame's estimate and the milliseconds that it took.
pub struct Shaded {
    /// The quantity at each point.
    pub estimate: Estimate,
    /// Captures, unless the scene is as it was, `prepare` and `shade`.
    pub ms: f64,
}

impl<B: Backend> Frames<B> {
    /// Runs the next frame, `scene` at its time.
    ///
    /// # Errors
    /// [`RunError`] if the method can't run there, or estimates a number that is not finite.
    pub fn next(
        &mut self,
        scene: &B::Scene,
        method: &dyn Configured,
        quantity: Quantity,
        frame: &Frame<'_>,
    ) -> Result<Shaded, RunError> {
        let points = frame.points;
        let changed = self.changed(frame);
        let last = self.0.take();
        let last_frame_ms = last.as_ref().map(|last| last.ms);
        let mut executor = match last {
            None => scene.executor(method, quantity, points)?,
            Some(Last { session, .. }) => {
                let session = match changed.any(Changed::SCENE) {
                    true => session.without_captures(),
                    false => session,
                };
                Executor::resume(scene, method, quantity, points, session)?
            }
        };
        let capture_ms = match executor.has_captures() {
            true => 0.0,
            false => {
                executor.solve()?;
                executor.capture()?.ms()
            }
        };
        executor.set_visible(frame.visible);
        executor.set_rigid_rotation(frame.rigid_rotation());
        executor.set_last_frame_ms(last_frame_ms);
        let ms = capture_ms + executor.prepare(changed)?.ms() + executor.shade()?.ms();
        let estimate = executor.read_back()?.0;
        check_finite(method.info().id, &estimate, Some(points))?;
        self.0 = Some(Last {
            session: executor.suspend(),
            points: points.clone(),
            ms,
        });
        Ok(Shaded { estimate, ms })
    }

    fn changed(&self, frame: &Frame<'_>) -> Changed {
        let Some(last) = &self.0 else {
            return Changed::ALL;
        };
        let moves = frame.moves;
        let captures = moves.geometry || moves.lights || moves.environment;
        [
            (last.points != *frame.points, Changed::POINTS),
            (captures, Changed::CAPTURES),
            (moves.geometry, Changed::GEOMETRY),
            (moves.environment, Changed::ENVIRONMENT),
        ]
        .into_iter()
        .filter(|(changed, _)| *changed)
        .fold(Changed::NOTHING, |all, (_, what)| all | what)
    }
}
