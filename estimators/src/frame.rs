//! What an estimator is given in one frame.

use crate::backend::{Backend, Cpu, Gpu};
use crate::captures::Captures;
use crate::configured::Configured;
use crate::error::{EstimatorError, Unsupported};
use crate::quantity::Quantity;
use glam::{Quat, Vec3};
use interreflect_cpu::tiles::TileKernel;
use interreflect_gpu::{Binding, GpuContext};
use interreflect_scene::{
    CubeSpec, DirectionalDepthSpec, Environment, Needs, Points, RsmSpec, Scene, SceneFacts,
};
use std::cell::RefCell;
use std::ops::{BitOr, Deref};
use std::sync::Arc;

/// What changed since a session's last `prepare`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changed(u8);

impl Changed {
    /// The method's parameters.
    pub const PARAMS: Self = Self(1);
    /// What the captures hold: geometry, materials, lights or environment.
    pub const CAPTURES: Self = Self(2);
    /// The points, or where their estimate goes.
    pub const POINTS: Self = Self(4);
    /// The surfaces: they moved, or others are there.
    pub const GEOMETRY: Self = Self(8);
    /// What arrives from infinitely far away.
    pub const ENVIRONMENT: Self = Self(16);
    /// Everything in the scene: what a frame costs that keeps nothing.
    pub const SCENE: Self = Self(2 | 8 | 16);
    /// Everything: the first call.
    pub const ALL: Self = Self(31);
    /// Nothing: the same frame again.
    pub const NOTHING: Self = Self(0);

    /// Whether any of `what` changed.
    pub fn any(self, what: Self) -> bool {
        self.0 & what.0 != 0
    }
}

impl BitOr for Changed {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// Triangles whose corners are shading points, and what the camera sees of both.
#[derive(Clone, Copy, Debug)]
pub struct VisibleTriangles<'a> {
    /// The points at each triangle's corners.
    pub triangles: &'a [[u32; 3]],
    /// The triangles that some pixel of this frame shows.
    pub visible: &'a [u32],
    /// The points that the camera sees themselves: in the image, with nothing before them. A visible
    /// triangle can have hidden corners.
    pub visible_points: &'a [u32],
}

/// What stays the same over the frames of one method in one scene.
#[derive(Debug)]
pub(crate) struct Request {
    /// What is estimated.
    pub(crate) quantity: Quantity,
    /// What the method declared.
    pub(crate) needs: Needs,
    /// What it was told of the scene when it did.
    pub(crate) scene: SceneFacts,
    /// Where cube captures are made.
    pub(crate) reference_point: Vec3,
    /// What has been read so far.
    pub(crate) read: RefCell<Needs>,
}

impl Request {
    pub(crate) fn new(
        scene: &Scene,
        method: &dyn Configured,
        quantity: Quantity,
    ) -> Result<Self, Unsupported> {
        let facts = scene.facts();
        let needs = method.needs(quantity, &facts)?;
        Ok(Self {
            quantity,
            scene: facts,
            reference_point: scene.capture_origin(needs.keep_within_m),
            needs,
            read: RefCell::default(),
        })
    }

    /// What is declared and was not read.
    pub(crate) fn unread(&self) -> Needs {
        let (needs, read) = (&self.needs, self.read.borrow());
        Needs {
            cubes: &needs.cubes - &read.cubes,
            rsms: &needs.rsms - &read.rsms,
            directional_depths: &needs.directional_depths - &read.directional_depths,
            environment: needs.environment && !read.environment,
            light_transport: needs.light_transport && !read.light_transport,
            ..Needs::default()
        }
    }
}

/// What a method reads in one frame: its points, and of all captures those that it declared.
pub struct Inputs<'a, B: Backend> {
    request: &'a Request,
    captures: &'a Captures<B>,
    /// What is estimated.
    pub quantity: Quantity,
    /// The points, where the backend reads them.
    pub points: &'a B::Points,
    /// The same points on the host.
    pub host_points: &'a Points,
    /// Reference point of the cube captures in world space, in metres: where they were made.
    pub reference_point: Vec3,
    /// What the method was told of the scene when it declared its needs.
    pub scene: SceneFacts,
    /// What changed since the session's last `prepare`.
    pub changed: Changed,
    /// What the camera sees of the points, where they are vertices.
    pub visible: Option<VisibleTriangles<'a>>,
    /// Where all surfaces and points are one rigid body in every frame of the session, how it is
    /// turned in this one, from rest: places and normals changed by this rotation and a translation
    /// alone. `None` where nothing of the kind is known.
    pub rigid_rotation: Option<Quat>,
    /// Milliseconds that the last frame took, its `prepare` and `shade` among them, in a sequence of
    /// frames.
    pub last_frame_ms: Option<f64>,
}

impl<'a, B: Backend> Inputs<'a, B> {
    /// The inputs of a frame; only what the request declares can be read of `captures`.
    pub(crate) fn new(
        request: &'a Request,
        captures: &'a Captures<B>,
        (points, host_points): (&'a B::Points, &'a Points),
        changed: Changed,
    ) -> Self {
        Self {
            request,
            captures,
            quantity: request.quantity,
            points,
            host_points,
            reference_point: request.reference_point,
            scene: request.scene,
            changed,
            visible: None,
            rigid_rotation: None,
            last_frame_ms: None,
        }
    }

    /// `kept`, unless it was made of captures or parameters that have changed since.
    pub fn unless_stale<T>(&self, kept: Option<T>) -> Option<T> {
        kept.filter(|_| !self.changed.any(Changed::PARAMS | Changed::CAPTURES))
    }

    /// A cube capture.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name it.
    pub fn cube(&self, spec: &CubeSpec) -> Result<&'a B::Cube, EstimatorError> {
        if !self.request.needs.cubes.contains(spec) {
            return Err(EstimatorError::Undeclared(EstimatorError::cube(spec)));
        }
        self.request.read.borrow_mut().cubes.insert(*spec);
        let found = self.captures.cubes.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(EstimatorError::cube(spec)))
    }

    /// Depth maps along directions.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name them.
    pub fn depths(&self, spec: &DirectionalDepthSpec) -> Result<&'a B::Depths, EstimatorError> {
        let name = || format!("directional depth maps of {0}x{0}", spec.size);
        if !self.request.needs.directional_depths.contains(spec) {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.request
            .read
            .borrow_mut()
            .directional_depths
            .insert(*spec);
        let found = self.captures.depths.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }

    /// What arrives from infinitely far away.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not ask for it.
    pub fn environment(&self) -> Result<&'a Environment, EstimatorError> {
        let name = || "the environment".to_owned();
        if !self.request.needs.environment {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.request.read.borrow_mut().environment = true;
        let found = self.captures.environment.as_ref();
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }

    /// Reflective shadow maps of all lights.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name them.
    pub fn rsm(&self, spec: &RsmSpec) -> Result<&'a B::Rsm, EstimatorError> {
        if !self.request.needs.rsms.contains(spec) {
            return Err(EstimatorError::Undeclared(EstimatorError::rsm(spec)));
        }
        self.request.read.borrow_mut().rsms.insert(*spec);
        let found = self.captures.rsms.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(EstimatorError::rsm(spec)))
    }

    /// Full light transport in the whole scene.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not ask for it.
    pub fn light_transport(&self) -> Result<&'a B::Transport, EstimatorError> {
        let name = || "light transport".to_owned();
        if !self.request.needs.light_transport {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.request.read.borrow_mut().light_transport = true;
        let found = self.captures.transport.as_deref();
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }
}

/// One phase of a frame on its backend: its inputs, and what the work is done with.
///
/// Dereferences to its [`Inputs`].
pub struct Frame<'f, B: Backend> {
    inputs: &'f Inputs<'f, B>,
    /// Threads of the CPU, or the open command encoder of the GPU.
    pub cx: &'f mut B::Cx,
    /// Where the estimate goes: RGB at each point.
    pub out: &'f mut B::Out,
}

impl<'f, B: Backend> Frame<'f, B> {
    pub(crate) fn new(inputs: &'f Inputs<'f, B>, cx: &'f mut B::Cx, out: &'f mut B::Out) -> Self {
        Self { inputs, cx, out }
    }
}

impl<'f, B: Backend> Deref for Frame<'f, B> {
    type Target = Inputs<'f, B>;

    fn deref(&self) -> &Inputs<'f, B> {
        self.inputs
    }
}

impl Frame<'_, Cpu> {
    /// Runs a kernel over all points and writes its values to the estimate.
    pub fn for_each_tile(&mut self, kernel: &impl TileKernel) {
        self.cx.for_each_tile(self.inputs.points, self.out, kernel);
    }
}

impl Frame<'_, Gpu> {
    /// The device.
    pub fn context(&self) -> &Arc<GpuContext> {
        self.cx.context()
    }

    /// What the slots 0 to 2 of a shader over points are bound to: points, their layout, the estimate.
    pub fn point_bindings(&self) -> [Binding<'_>; 3] {
        self.inputs.points.bindings(self.out)
    }
}

#[cfg(test)]
mod tests;
