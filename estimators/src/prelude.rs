//! What a method's folder needs: `use interreflect_estimators::prelude::*`.

pub use crate::frame::{Changed, Frame, Inputs};
pub use crate::leaves::Leaves;
pub use crate::method::{Estimator, Figure, Info, Kernels, Method, Prepared, Reference};
pub use crate::{
    Answers, Claim, Cpu, CpuOnly, EstimatorError, FormFactorLaw, Gpu, OtherModel, OwnModel,
    PointEstimate, Quantity, Records, ReferenceModel, Tolerance, Unsupported,
};
pub use bytemuck::{Pod, Zeroable};
pub use glam::{DVec3, Vec3};
pub use interreflect_cpu::lane::{Lane, Scalar, Vector};
pub use interreflect_cpu::scene::CpuScene;
pub use interreflect_cpu::tiles::{CpuCx, PointLanes, TileKernel};
pub use interreflect_gpu::{Binding, GpuContext, GpuCube, Kernel, Shader, wgsl};
pub use interreflect_scene::conventions::{
    CUBE_FACES, cube_coordinates, cube_vector, texel_centre, texel_index, texel_solid_angle_sr,
};
pub use interreflect_scene::params::Fidelity;
pub use interreflect_scene::{
    Bounds, CubeChannels, CubeImage, CubeSpec, Estimate, Needs, Point, PointLayout, Points,
    RsmChannels, RsmSpec, Scene, SceneFacts,
};
