//! One method over the frames of a sequence: a session that lives on while the scene moves.

use crate::domain::metrics::check_finite;
use crate::running::error::RunError as HarnessError;
use interreflect_estimators::stage::{Placed, Stage};
use interreflect_estimators::{
    Backend, Captures, Changed, Configured, Inputs, Quantity, Seen, Session,
};
use interreflect_scene::motion::Moves;
use interreflect_scene::{Estimate, Points, Scene};

/// A session and its last frame.
pub struct Frames<B: Backend> {
    session: Box<dyn Session<B>>,
    last: Option<Last<B>>,
}

struct Last<B: Backend> {
    points: Points,
    /// Good as long as the scene stays as it is.
    captures: Captures<B>,
    ms: f64,
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
    pub seen: Option<Seen<'a>>,
}

/// A frame's estimate and the milliseconds that it took.
pub struct Shaded {
    /// The quantity at each point.
    pub estimate: Estimate,
    /// Captures, unless the scene is as it was, `prepare` and `shade`.
    pub ms: f64,
}

impl<B: Backend> Frames<B> {
    /// A session of a method before its first frame.
    ///
    /// # Errors
    /// [`HarnessError`] if the method has no implementation on the backend.
    pub fn new<S: Stage<Backend = B>>(
        stage: &S,
        method: &dyn Configured,
    ) -> Result<Self, HarnessError> {
        let session = stage.open(method)?;
        Ok(Self {
            session,
            last: None,
        })
    }

    /// Runs the next frame on `stage`, the scene at its time.
    ///
    /// # Errors
    /// [`HarnessError`] if the method can't run there, or estimates a number that is not finite.
    pub fn next<S: Stage<Backend = B>>(
        &mut self,
        stage: &S,
        method: &dyn Configured,
        quantity: Quantity,
        frame: &Frame<'_>,
    ) -> Result<Shaded, HarnessError> {
        let (scene, points) = (frame.scene, frame.points);
        let facts = scene.facts();
        let needs = method.needs(quantity, &facts)?;
        let changed = self.changed(frame);
        let last_frame_ms = self.last.as_ref().map(|last| last.ms);
        let kept = self.last.take().filter(|_| !changed.any(Changed::SCENE));
        let (captures, capture_ms) = match kept {
            Some(last) => (last.captures, 0.0),
            None => {
                stage.solve(&needs)?;
                let (captures, elapsed) = stage.capture(&needs)?;
                (captures, elapsed.ms())
            }
        };
        let Placed {
            points: placed,
            mut out,
        } = stage.place(points)?;
        let origin = (facts, scene.capture_origin(needs.keep_within_m));
        let mut inputs = Inputs::new(&needs, &captures, &placed, points, origin, changed);
        inputs.seen = frame.seen;
        inputs.last_frame_ms = last_frame_ms;
        let session = &mut self.session;
        let prepare = stage.timed("prepare", &mut |cx| {
            session.prepare(cx, quantity, &inputs, &out)
        })?;
        let shade = stage.timed("shade", &mut |cx| {
            session.shade(cx, quantity, &inputs, &mut out)
        })?;
        let estimate = stage.read_back(&out)?.0;
        check_finite(method.info().id, &estimate, Some(points))?;
        let ms = capture_ms + prepare.ms() + shade.ms();
        self.last = Some(Last {
            points: points.clone(),
            captures,
            ms,
        });
        Ok(Shaded { estimate, ms })
    }

    fn changed(&self, frame: &Frame<'_>) -> Changed {
        let Some(last) = &self.last else {
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
