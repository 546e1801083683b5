//! Indirect-illumination estimators: traits, parameters, registry and one folder per method.
//!
//! A method says what it is ([`Method`]) and how it runs on a backend ([`Estimator`]); the
//! [`Registry`] erases its types. Add one by copying a folder and registering it.

pub mod averaging;
mod backend;
mod captures;
mod claims;
mod configured;
mod error;
mod frame;
pub mod leaves;
pub mod lobes;
mod method;
mod model;
pub mod prelude;
mod quantity;
pub mod ranges;
mod records;
mod registry;
mod tolerance;

pub mod classic_envmap;
pub mod constant_ambient;
pub mod convolution;
pub mod direct_radiance_map;
pub mod directional_ao;
pub mod execution;
pub mod localized_cubemap;
pub mod path_reference;
pub mod phong_envmap;
pub mod point_form_factor;
pub mod polygon_form_factor;
pub mod reflection;
pub mod sh_mip_envmap;
pub mod texels;

/// WGSL twin of [`interreflect_cpu::lane::Lane::lobe_power`].
pub const LOBE_POWER: &str = include_str!("lobe_power.wgsl");

/// WGSL twin of [`interreflect_cpu::lane::Lane::angle`].
pub const ANGLE: &str = include_str!("angle.wgsl");

pub use backend::{Backend, Cpu, Gpu};
pub use captures::Captures;
pub use claims::{Answers, Claim, FormFactorLaw, PatchKernel, PointEstimate};
pub use configured::{Configured, Session};
pub use error::{EstimatorError, Unsupported};
pub use frame::{Changed, Frame, Inputs, VisibleTriangles};
pub use method::{Estimator, Figure, Info, Kernels, Method, Prepared, Reference};
pub use model::{OtherModel, OwnModel, ReferenceModel};
pub use quantity::Quantity;
pub use records::Records;
pub use registry::{CpuOnly, Entry, Registry, UnknownEstimator};
pub use tolerance::Tolerance;

pub use {bytemuck, glam, wgpu};
