//! The two backends, and what an estimator is given on them.

use crate::error::EstimatorError;
use glam::Vec3;
use interreflect_cpu::capture::directional_depth::DirectionalDepths;
use interreflect_cpu::{scene::CpuScene, tiles::CpuCx};
use interreflect_gpu::{
    GpuContext, GpuCube, GpuCx, GpuDirectionalDepths, GpuEstimate, GpuLightView, GpuPoints,
};
use interreflect_scene::{
    CubeImage, CubeSpec, DirectionalDepthSpec, Environment, Estimate, LightViewImage,
    LightViewSpec, Needs, Points, SceneFacts,
};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::BitOr;

mod sealed {
    pub trait Sealed {}
    impl Sealed for super::Cpu {}
    impl Sealed for super::Gpu {}
}

/// Where an estimator runs.
pub trait Backend: sealed::Sealed + Copy + Send + Sync + 'static {
    /// Its name on the command line and in records.
    const NAME: &'static str;
    /// What varies from machine to machine.
    type Caps;
    /// What an estimator runs with: threads, or an open command encoder.
    type Cx<'c>;
    /// A captured cube.
    type Cube;
    /// Where depth maps along directions come from.
    type Depths;
    /// Captured views from the lights.
    type LightView;
    /// The shaded points.
    type Points;
    /// Where the estimate goes.
    type Out;
    /// Access to full light transport.
    type Transport;
}

/// The CPU backend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cpu;

/// The GPU backend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gpu;

impl Backend for Cpu {
    const NAME: &'static str = "cpu";
    type Caps = ();
    type Cx<'c> = &'c CpuCx;
    type Cube = CubeImage;
    type Depths = DirectionalDepths;
    type LightView = LightViewImage;
    type Points = Points;
    type Out = Estimate;
    type Transport = CpuScene;
}

impl Backend for Gpu {
    const NAME: &'static str = "gpu";
    type Caps = GpuContext;
    type Cx<'c> = GpuCx;
    type Cube = GpuCube;
    type Depths = GpuDirectionalDepths;
    type LightView = GpuLightView;
    type Points = GpuPoints;
    type Out = GpuEstimate;
    type Transport = std::convert::Infallible;
}

/// The captures that were made for one or several methods, by the specs that asked for them.
pub struct Captures<B: Backend> {
    /// Cube maps around the reference point.
    pub cubes: BTreeMap<CubeSpec, B::Cube>,
    /// Depth maps along directions.
    pub depths: BTreeMap<DirectionalDepthSpec, B::Depths>,
    /// What arrives from infinitely far away, if the scene has any.
    pub environment: Option<Environment>,
    /// Views from the lights.
    pub light_views: BTreeMap<LightViewSpec, B::LightView>,
    /// Ray queries in the whole scene.
    pub transport: Option<std::sync::Arc<B::Transport>>,
}

impl<B: Backend> Default for Captures<B> {
    fn default() -> Self {
        Self {
            cubes: BTreeMap::new(),
            depths: BTreeMap::new(),
            environment: None,
            light_views: BTreeMap::new(),
            transport: None,
        }
    }
}

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

/// What the camera sees of points that are the vertices of triangles.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// The points at each triangle's corners.
    pub triangles: &'a [[u32; 3]],
    /// The triangles that some pixel of this frame shows.
    pub visible: &'a [u32],
}

/// One method's own view of a frame: only what it declared can be read.
pub struct Inputs<'a, B: Backend> {
    /// What the method declared.
    pub declared: &'a Needs,
    captures: &'a Captures<B>,
    read: RefCell<Needs>,
    /// The points, where the backend reads them.
    pub points: &'a B::Points,
    /// The same points on the host.
    pub host_points: &'a Points,
    /// Reference point `o` of the cube captures, where they were made.
    pub reference_point: Vec3,
    /// What the method was told of the scene when it declared its needs.
    pub scene: SceneFacts,
    /// What changed since the session's last `prepare`.
    pub changed: Changed,
    /// What the camera sees of the points, where they are vertices.
    pub seen: Option<Seen<'a>>,
    /// Milliseconds that the last frame's `prepare` and `shade` took, in a sequence of frames.
    pub last_frame_ms: Option<f64>,
}

impl<'a, B: Backend> Inputs<'a, B> {
    /// A view of `captures` that shows what `declared` names and nothing else.
    pub fn new(
        declared: &'a Needs,
        captures: &'a Captures<B>,
        points: &'a B::Points,
        host_points: &'a Points,
        (scene, reference_point): (SceneFacts, Vec3),
        changed: Changed,
    ) -> Self {
        Self {
            declared,
            captures,
            read: RefCell::default(),
            points,
            host_points,
            reference_point,
            scene,
            changed,
            seen: None,
            last_frame_ms: None,
        }
    }

    /// A cube capture.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name it.
    pub fn cube(&self, spec: &CubeSpec) -> Result<&'a B::Cube, EstimatorError> {
        if !self.declared.cubes.contains(spec) {
            return Err(EstimatorError::Undeclared(EstimatorError::cube(spec)));
        }
        self.read.borrow_mut().cubes.insert(*spec);
        let found = self.captures.cubes.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(EstimatorError::cube(spec)))
    }

    /// Depth maps along directions.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name them.
    pub fn depths(&self, spec: &DirectionalDepthSpec) -> Result<&'a B::Depths, EstimatorError> {
        let name = || format!("directional depth maps of {0}x{0}", spec.size);
        if !self.declared.directional_depths.contains(spec) {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.read.borrow_mut().directional_depths.insert(*spec);
        let found = self.captures.depths.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }

    /// What arrives from infinitely far away.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not ask for it.
    pub fn environment(&self) -> Result<&'a Environment, EstimatorError> {
        let name = || "the environment".to_owned();
        if !self.declared.environment {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.read.borrow_mut().environment = true;
        let found = self.captures.environment.as_ref();
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }

    /// Views from all lights.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not name them.
    pub fn light_view(&self, spec: &LightViewSpec) -> Result<&'a B::LightView, EstimatorError> {
        if !self.declared.light_views.contains(spec) {
            return Err(EstimatorError::Undeclared(EstimatorError::light_view(spec)));
        }
        self.read.borrow_mut().light_views.insert(*spec);
        let found = self.captures.light_views.get(spec);
        found.ok_or_else(|| EstimatorError::Missing(EstimatorError::light_view(spec)))
    }

    /// Full light transport in the whole scene.
    ///
    /// # Errors
    /// [`EstimatorError::Undeclared`] if `needs` did not ask for it.
    pub fn light_transport(&self) -> Result<&'a B::Transport, EstimatorError> {
        let name = || "light transport".to_owned();
        if !self.declared.light_transport {
            return Err(EstimatorError::Undeclared(name()));
        }
        self.read.borrow_mut().light_transport = true;
        let found = self.captures.transport.as_deref();
        found.ok_or_else(|| EstimatorError::Missing(name()))
    }

    /// What has been read so far: conformance compares it with what was declared.
    pub fn read(&self) -> Needs {
        self.read.borrow().clone()
    }
}
