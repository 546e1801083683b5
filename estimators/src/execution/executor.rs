//! One method and quantity on one backend's side of a loaded scene.

use super::{BackendScene, Elapsed, Placed};
use crate::frame::Request;
use crate::{
    Backend, Captures, Changed, Configured, EstimatorError, Frame, Inputs, Quantity, Records,
    Session, VisibleTriangles,
};
use glam::Quat;
use interreflect_scene::{Estimate, Needs, Points};
use std::rc::Rc;

/// Runs one method and quantity on a loaded scene: it has what the method needs, its session, the
/// captures, the points and their estimate.
///
/// Phases run in their order whatever is called: one that was left out runs when a later one needs what
/// it makes.
pub struct Executor<'s, B: Backend> {
    scene: &'s B::Scene,
    request: Request,
    session: Box<dyn Session<B>>,
    captures: Option<Rc<Captures<B>>>,
    points: &'s Points,
    placed: Placed<B>,
    visible: Option<VisibleTriangles<'s>>,
    rigid_rotation: Option<Quat>,
    last_frame_ms: Option<f64>,
}

/// What a method keeps between the frames of a sequence, while there is no scene.
pub struct Suspended<B: Backend> {
    session: Box<dyn Session<B>>,
    captures: Option<Rc<Captures<B>>>,
}

impl<B: Backend> Suspended<B> {
    /// Without the captures: the scene has changed.
    pub fn without_captures(self) -> Self {
        Self {
            captures: None,
            ..self
        }
    }
}

impl<'s, B: Backend> Executor<'s, B> {
    /// A new session of a method at these points.
    ///
    /// # Errors
    /// [`EstimatorError`] if the method can't work here or a point can't be shaded.
    pub fn new(
        scene: &'s B::Scene,
        method: &dyn Configured,
        quantity: Quantity,
        points: &'s Points,
    ) -> Result<Self, EstimatorError> {
        let request = Request::new(scene.scene(), method, quantity)?;
        let session = Suspended {
            session: scene.open(method)?,
            captures: None,
        };
        Self::with(scene, request, points, session)
    }

    /// The next frame of a session, in a scene that may have changed.
    ///
    /// # Errors
    /// [`EstimatorError`] as [`Executor::new`].
    pub fn resume(
        scene: &'s B::Scene,
        method: &dyn Configured,
        quantity: Quantity,
        points: &'s Points,
        session: Suspended<B>,
    ) -> Result<Self, EstimatorError> {
        let request = Request::new(scene.scene(), method, quantity)?;
        Self::with(scene, request, points, session)
    }

    fn with(
        scene: &'s B::Scene,
        request: Request,
        points: &'s Points,
        Suspended { session, captures }: Suspended<B>,
    ) -> Result<Self, EstimatorError> {
        Ok(Self {
            scene,
            request,
            session,
            captures,
            points,
            placed: scene.place(points)?,
            visible: None,
            rigid_rotation: None,
            last_frame_ms: None,
        })
    }

    /// Leaves the scene; session and captures stay for the next frame.
    pub fn suspend(self) -> Suspended<B> {
        Suspended {
            session: self.session,
            captures: self.captures,
        }
    }

    /// The session alone: what a method keeps, without scene, captures and points.
    pub fn into_session(self) -> Box<dyn Session<B>> {
        self.session
    }

    /// The backend's side of the scene.
    pub fn scene(&self) -> &'s B::Scene {
        self.scene
    }

    /// What the method declared.
    pub fn needs(&self) -> &Needs {
        &self.request.needs
    }

    /// Whether captures of an earlier frame are used: then this one pays for none.
    pub fn keeps_captures(&self) -> bool {
        let keep_within_m = self.request.needs.keep_within_m;
        self.scene.scene().keeps_captures(keep_within_m)
    }

    /// Phase *solve*: see [`BackendScene::solve`].
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    pub fn solve(&self) -> Result<Option<f64>, EstimatorError> {
        self.scene.solve(&self.request.needs)
    }

    /// Phase *capture*: makes every declared capture anew.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    pub fn capture(&mut self) -> Result<Elapsed, EstimatorError> {
        let (captures, elapsed) = self.scene.capture(&self.request.needs)?;
        self.captures = Some(Rc::new(captures));
        Ok(elapsed)
    }

    /// Takes captures that were made before, here or by the other backend.
    pub fn set_captures(&mut self, captures: Rc<Captures<B>>) {
        self.captures = Some(captures);
    }

    /// Whether there are captures.
    pub fn has_captures(&self) -> bool {
        self.captures.is_some()
    }

    /// The captures, made now where there are none.
    ///
    /// # Errors
    /// [`EstimatorError`] as [`Executor::capture`].
    pub fn captures(&mut self) -> Result<Rc<Captures<B>>, EstimatorError> {
        if let Some(captures) = &self.captures {
            return Ok(captures.clone());
        }
        let captures = Rc::new(self.scene.capture(&self.request.needs)?.0);
        Ok(self.captures.insert(captures).clone())
    }

    /// Goes to other points; the session goes on.
    ///
    /// # Errors
    /// [`EstimatorError`] if one can't be shaded.
    pub fn place(&mut self, points: &'s Points) -> Result<(), EstimatorError> {
        self.placed = self.scene.place(points)?;
        self.points = points;
        Ok(())
    }

    /// Says what the camera sees of the points in the next frames, where they are vertices.
    pub fn set_visible(&mut self, visible: Option<VisibleTriangles<'s>>) {
        self.visible = visible;
    }

    /// Says that all surfaces and points are one rigid body in every frame of the session, and how it
    /// is turned in the next ones, from rest.
    pub fn set_rigid_rotation(&mut self, rotation: Option<Quat>) {
        self.rigid_rotation = rotation;
    }

    /// Says how long the frame before took, which a method may choose its level of detail by.
    pub fn set_last_frame_ms(&mut self, ms: Option<f64>) {
        self.last_frame_ms = ms;
    }

    /// Phase *prepare*, where this has changed since the last one.
    ///
    /// # Errors
    /// [`EstimatorError`] if the method fails or the backend refuses.
    pub fn prepare(&mut self, changed: Changed) -> Result<Elapsed, EstimatorError> {
        self.phase("prepare", changed, |session, frame| session.prepare(frame))
    }

    /// Phase *shade*; prepares first where that was left out.
    ///
    /// # Errors
    /// [`EstimatorError`] as [`Executor::prepare`].
    pub fn shade(&mut self) -> Result<Elapsed, EstimatorError> {
        if self.session.prepared().is_none() {
            self.prepare(Changed::ALL)?;
        }
        self.phase("shade", Changed::NOTHING, |session, frame| {
            let prepared = session.prepared();
            prepared.map_or(Ok(()), |prepared| prepared.shade(frame))
        })
    }

    /// Runs the caller's work as a phase, on the session and a frame in which this has changed.
    ///
    /// # Errors
    /// [`EstimatorError`] if the work fails or the backend refuses.
    pub fn phase(
        &mut self,
        label: &str,
        changed: Changed,
        mut work: impl FnMut(&mut dyn Session<B>, &mut Frame<'_, B>) -> Result<(), EstimatorError>,
    ) -> Result<Elapsed, EstimatorError> {
        let captures = self.captures()?;
        let points = (&self.placed.points, self.points);
        let mut inputs = Inputs::new(&self.request, &captures, points, changed);
        inputs.visible = self.visible;
        inputs.rigid_rotation = self.rigid_rotation;
        inputs.last_frame_ms = self.last_frame_ms;
        let (session, out) = (&mut *self.session, &mut self.placed.out);
        self.scene.timed(label, &mut |cx| {
            work(session, &mut Frame::new(&inputs, cx, out))
        })
    }

    /// Phase *read-back*: the estimate on the host; milliseconds, or `None` where it is there already.
    ///
    /// # Errors
    /// [`EstimatorError`] if the backend refuses.
    pub fn read_back(&self) -> Result<(Estimate, Option<f64>), EstimatorError> {
        self.scene.read_back(&self.placed.out)
    }

    /// All phases once, as in a first frame: the estimate on the host.
    ///
    /// # Errors
    /// [`EstimatorError`] if the method fails or the backend refuses.
    pub fn estimate(&mut self) -> Result<Estimate, EstimatorError> {
        self.prepare(Changed::ALL)?;
        self.shade()?;
        Ok(self.read_back()?.0)
    }

    /// The declared captures that no phase has read so far: none, once an honest method has shaded.
    pub fn unread(&self) -> Needs {
        self.request.unread()
    }

    /// What the last `prepare` made; nothing before the first.
    ///
    /// # Errors
    /// [`EstimatorError`] if the device fails.
    pub fn records(&self) -> Result<Vec<Records>, EstimatorError> {
        match self.session.prepared() {
            Some(prepared) => prepared.records(self.scene.caps()),
            None => Ok(Vec::new()),
        }
    }
}
