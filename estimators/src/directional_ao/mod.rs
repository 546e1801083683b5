//! Ambient occlusion from many directions: Sattler, Sarlette, Zachmann, Klein, *Hardware-accelerated
//! Ambient Occlusion Computation*. One depth map for each of k directions says which points are open
//! there; a bit per point and direction is kept, so that light may change without looking again.

mod cpu;
mod environment;
mod gpu;
mod level;
pub mod math;
mod params;
mod progress;
mod sphere;
mod todo;

use crate::{Info, Method, OwnModel, Quantity, Unsupported};
use glam::Vec3;
use interreflect_cpu::path_tracer::LightPaths;
use interreflect_scene::params::Fidelity;
use interreflect_scene::{DirectionalDepthSpec, Environment, Needs, SceneFacts};
use std::f64::consts::{FRAC_1_PI, PI};

pub use cpu::State as CpuState;
pub use gpu::State as GpuState;
pub use params::{Bias, DirectionalAoParams, Visibility};
pub use sphere::{DIRECTIONS, MAX_LEVEL, directions};

/// The method.
pub struct DirectionalAo;

impl Method for DirectionalAo {
    type Params = DirectionalAoParams;

    const INFO: Info = Info {
        id: "directional_ao",
        title: "Ambient occlusion from many directions",
        source: "M. Sattler, R. Sarlette, G. Zachmann, R. Klein: Hardware-accelerated Ambient \
                 Occlusion Computation",
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::AmbientOcclusion, Quantity::Irradiance];

    fn needs(
        params: &Self::Params,
        quantity: Quantity,
        scene: &SceneFacts,
    ) -> Result<Needs, Unsupported> {
        let coloured = quantity == Quantity::Irradiance;
        if coloured && !scene.environment {
            return Err(Unsupported(
                "directional_ao gathers irradiance from an environment at infinity, and the scene \
                 has none; add --environment FILE, or ask for ambient_occlusion"
                    .into(),
            ));
        }
        let rays = params.visibility == Visibility::Rays;
        let maps = (scene.occluders && !rays).then(|| params.depths());
        Ok(Needs {
            directional_depths: maps.into_iter().collect(),
            environment: coloured,
            light_transport: scene.occluders && rays,
            ..Needs::default()
        })
    }

    fn model(_params: &Self::Params, quantity: Quantity) -> OwnModel {
        match quantity {
            Quantity::Irradiance => OwnModel::OccludedEnvironment,
            _ => OwnModel::LightTransport(LightPaths::default()),
        }
    }
}

impl DirectionalAoParams {
    /// The depth maps that points are tested against.
    fn depths(&self) -> DirectionalDepthSpec {
        DirectionalDepthSpec {
            size: self.map_resolution,
            slope_scaled: self.bias == Bias::PolygonOffset,
        }
    }

    /// What depths of points may lie behind the map's: a texel's width where the bias is constant,
    /// in a map whose depth goes through the sphere that a map of so many texels sees.
    fn margin(&self) -> f32 {
        match self.bias {
            Bias::Constant => 1.0 / self.map_resolution as f32,
            Bias::PolygonOffset | Bias::None => 0.0,
        }
    }
}

/// What an open direction counts, times its cosine: (1/π)·w_j for openness, I_j·w_j for irradiance
/// (P5, the sum over M_ij).
fn values(
    params: &DirectionalAoParams,
    level: u32,
    environment: Option<&environment::Blurred>,
    turned: Option<&Environment>,
) -> Vec<[f32; 3]> {
    let uniform = 4.0 * PI / f64::from(DIRECTIONS[level as usize]);
    let weights = sphere::weights_sr(level);
    let weight = |j: usize| match params.fidelity {
        Fidelity::Published => uniform,
        Fidelity::Corrected => weights[j],
    };
    let directions = sphere::directions(level);
    let value = |(j, &towards): (usize, &Vec3)| {
        let value = match (environment, turned) {
            (Some(blurred), Some(turned)) => {
                blurred.radiance(turned, towards).as_dvec3() * weight(j)
            }
            _ => glam::DVec3::splat(weight(j) * FRAC_1_PI),
        };
        value.as_vec3().to_array()
    };
    directions.iter().enumerate().map(value).collect()
}
