//! Ambient occlusion from many directions: Sattler, Sarlette, Zachmann, Klein, *Hardware-accelerated
//! Ambient Occlusion Computation*. One depth map for each of k directions says which points are open
//! there; a bit per point and direction is kept, so that light may change without looking again.

mod claims;
mod cpu;
mod environment;
mod gpu;
mod leaves;
mod level;
pub mod math;
mod params;
mod progress;
mod sphere;
mod worklist;

use crate::leaves::Leaves;
use crate::{
    Backend, Claim, EstimatorError, Figure, Info, Inputs, Method, OwnModel, Quantity, Reference,
    Unsupported,
};
use environment::Blurred;
use glam::{DVec3, Vec3};
use interreflect_scene::params::Fidelity;
use interreflect_scene::{DirectionalDepthSpec, Environment, LightPaths, Needs, SceneFacts};
use std::f64::consts::{FRAC_1_PI, PI};

pub use params::{BelowHorizon, Bias, DirectionalAo, Filter, Visibility};
pub use sphere::{DIRECTIONS, MAX_LEVEL, directions};

impl Method for DirectionalAo {
    const INFO: Info = Info {
        id: "directional_ao",
        title: "Ambient occlusion from many directions",
        summary: "openness, and irradiance from the environment with occlusion, from depth maps along k directions",
        references: &[Reference {
            authors: "M. Sattler, R. Sarlette, G. Zachmann, R. Klein",
            title: "Hardware-accelerated Ambient Occlusion Computation",
            venue: "Vision, Modeling and Visualization",
            year: 2004,
            doi: None,
        }],
        figure: Some(Figure {
            scene: "studio",
            quantity: Quantity::AmbientOcclusion,
            settings: &[],
        }),
    };

    const QUANTITIES: &'static [Quantity] = &[Quantity::AmbientOcclusion, Quantity::Irradiance];

    const LEAVES: Leaves = leaves::LEAVES;

    fn needs(&self, quantity: Quantity, scene: &SceneFacts) -> Result<Needs, Unsupported> {
        let coloured = quantity == Quantity::Irradiance;
        if coloured && !scene.environment {
            return Err(Unsupported(
                "directional_ao gathers irradiance from an environment at infinity, and the scene \
                 has none; add --environment FILE, or ask for ambient_occlusion"
                    .into(),
            ));
        }
        let rays = self.visibility == Visibility::Rays;
        let maps = (scene.any_surface && !rays).then(|| self.depths());
        Ok(Needs {
            directional_depths: maps.into_iter().collect(),
            environment: coloured,
            light_transport: scene.any_surface && rays,
            ..Needs::default()
        })
    }

    fn model(&self, quantity: Quantity) -> OwnModel {
        match quantity {
            Quantity::Irradiance => OwnModel::OccludedEnvironment,
            _ => OwnModel::LightTransport(LightPaths::default()),
        }
    }

    fn claims(&self, quantity: Quantity) -> Vec<Claim> {
        claims::claims(self, quantity)
    }
}

impl DirectionalAo {
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

/// The least that the cosine of an open direction counts.
fn least_cosine(method: &DirectionalAo) -> f32 {
    match method.below_horizon {
        BelowHorizon::Clamped => 0.0,
        BelowHorizon::Signed => -1.0,
    }
}

/// The environment, where its light is asked for.
fn environment<'a, B: Backend>(
    inputs: &Inputs<'a, B>,
) -> Result<Option<&'a Environment>, EstimatorError> {
    let coloured = inputs.quantity == Quantity::Irradiance;
    coloured.then(|| inputs.environment()).transpose()
}

/// What an open direction counts, times its cosine: (1/π)·w_j for openness, I_j·w_j for the irradiance
/// of an environment (P5, the sum over M_ij), seen in these directions of a level. It is blurred again
/// only if it is another image.
fn values(
    method: &DirectionalAo,
    (level, directions): (u32, &[Vec3]),
    environment: Option<&Environment>,
    blurred: &mut Option<Blurred>,
) -> Vec<[f32; 3]> {
    let uniform = 4.0 * PI / f64::from(DIRECTIONS[level as usize]);
    let weights = sphere::weights_sr(level).into_iter();
    let weights = weights.map(|weight| match method.fidelity {
        Fidelity::Published => uniform,
        Fidelity::Corrected => weight,
    });
    let rounded = |v: DVec3| v.as_vec3().to_array();
    let Some(environment) = environment else {
        return weights
            .map(|w| rounded(DVec3::splat(w * FRAC_1_PI)))
            .collect();
    };
    let made = blurred.take();
    let made = made.filter(|b| b.is_of(environment, method.blur_deg));
    let made = made.unwrap_or_else(|| Blurred::new(environment, method.blur_deg));
    let radiance = |towards| made.radiance(environment, towards).as_dvec3();
    let pairs = directions.iter().zip(weights);
    let values = pairs
        .map(|(&towards, w)| rounded(radiance(towards) * w))
        .collect();
    *blurred = Some(made);
    values
}

/// The names of what both backends show of themselves.
mod record_names {
    /// A bit for each direction, a word for each 32 directions and point: word after word, points
    /// padded to whole blocks.
    pub(super) const VISIBILITY: &str = "visibility bits";
    /// Points that were evaluated since the start, repetitions counted.
    pub(super) const EVALUATIONS: &str = "evaluations";
}
